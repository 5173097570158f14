// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include "app/commands/commands.h"
#include "app/commands/train/train_files.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "app/reports/progress_line.h"
#include "app/reports/report.h"

namespace surefoot {

namespace {

/// The lives of a request, with a progress line on a terminal.
Result<std::vector<LifeResult>> run(const Registry& registry, const TrainRequest& request, TrainFiles& files) {
  RunOptions options{};
  options.jobs = request.jobs;
  options.keepRows = files.keepRows();
  options.interrupted = &watchForInterrupt();
  if (files.wantsRows())
    options.takeRows = [&](int life, const std::vector<EpisodeRow>& rows) { files.takeRows(life, rows); };
  if (files.wantsVisits()) {
    options.visit = [&](const Life& life) { files.visit(life); };
    options.visitEvery = files.visitEvery();
  }
  if (request.resumed)
    options.make = [&](int) -> Result<std::unique_ptr<Life>> {
      auto resumed = resume(registry, request.resumed, request.limits, request.versions);
      if (!resumed) return resumed.error();
      return std::move(resumed->life);
    };
  if (request.mostSteps)
    options.make = [&](int life) {
      return makeLife(registry, request.configuration, life, options.keepRows, *request.mostSteps);
    };
  std::optional<ProgressLine> line;
  if (isatty(STDERR_FILENO))
    options.progress = [&](const Progress& p) {
      if (!line) line.emplace();
      line->show(p.share, fmt::format("{} of {} lives, {} falls", p.livesDone, request.configuration.lives, p.falls));
    };
  return runLives(registry, request.configuration, options);
}

}  // namespace

int trainCommand(const Registry& registry, const TrainRequest& request) {
  const Configuration& configuration = request.configuration;
  const auto environment = makeEnvironment(registry, configuration);
  if (!environment) return fail(environment.error());
  auto files = TrainFiles::claim(request, (*environment)->task());
  if (!files) return fail(files.error());
  tell(request.note);
  const auto lives = run(registry, request, *files);
  if (!lives) return fail(lives.error());

  // Whatever fails here, the rest is still reported.
  const std::vector<Error> missing = files->finish(*lives);
  const int printed = print(request.json ? resultAsJson(configuration, *lives) : resultAsTable(configuration, *lives));
  for (const Error& error : missing) fail(error);
  if (!missing.empty()) return exitCode(missing.front().kind);
  if (printed != kDone) return printed;

  for (const LifeResult& life : *lives)
    if (!life.divergence.empty()) {
      const std::string which = configuration.lives > 1 ? fmt::format("life {}: ", life.life) : "";
      std::string message = which + life.divergence;
      if (request.save || request.checkpoint) message.replace(message.size() - 1, 1, "; nothing of it is saved.");
      return fail({message, ErrorKind::Diverged});
    }
  for (const LifeResult& life : *lives)
    if (!life.unanswered.empty() && !watchForInterrupt())
      return fail({life.unanswered + (request.checkpoint ? " The life can go on: --resume " + *request.checkpoint : ""),
                   ErrorKind::Unanswered});
  const auto complete =
      static_cast<int>(std::count_if(lives->begin(), lives->end(), [](const LifeResult& r) { return r.complete; }));
  if (complete < configuration.lives)
    return fail({fmt::format("interrupted; {} of {} lives are complete, the others end where they were.", complete,
                             configuration.lives),
                 ErrorKind::Interrupted});
  return kDone;
}

}  // namespace surefoot
