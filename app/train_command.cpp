// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/report.h"
#include "app/train_files.h"

namespace surefoot {

namespace {

std::string duration(double seconds) {
  const auto s = static_cast<std::int64_t>(seconds + 0.5);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

/// One line on the terminal, drawn over again.
class ProgressLine {
 public:
  explicit ProgressLine(int lives) : lives_(lives) {}
  void show(const Progress& p) {
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const auto filled = static_cast<std::size_t>(p.share * 24);
    const std::string eta = p.share > 0.001 ? duration(elapsed / p.share - elapsed) : "…";
    write(fmt::format("\r[{}{}] {:3.0f} %  {} of {} lives, {} falls, {} elapsed, {} left \033[K",
                      std::string(filled, '#'), std::string(24 - filled, '.'), p.share * 100, p.livesDone, lives_,
                      p.falls, duration(elapsed), eta));
  }
  ~ProgressLine() { write("\r\033[K"); }

 private:
  /// The terminal may be gone by now; that is no reason to lose the run.
  static void write(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
  }

  int lives_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

namespace {

/// The lives of a request, with a progress line on a terminal.
Result<std::vector<LifeResult>> run(const Registry& registry, const TrainRequest& request, TrainFiles& files) {
  RunOptions options{};
  options.jobs = request.jobs;
  options.keepRows = files.keepRows();
  options.interrupted = &watchForInterrupt();
  if (files.wantsVisits()) {
    options.visit = [&](const Life& life) { files.visit(life); };
    options.visitEvery = files.visitEvery();
  }
  if (request.resumed)
    options.make = [&](int) -> Result<std::unique_ptr<Life>> {
      auto resumed = resume(registry, request.resumed, request.limits);
      if (!resumed) return resumed.error();
      return std::move(resumed->life);
    };
  std::optional<ProgressLine> line;
  if (isatty(STDERR_FILENO))
    options.progress = [&](const Progress& p) {
      if (!line) line.emplace(request.configuration.lives);
      line->show(p);
    };
  return runLives(registry, request.configuration, options);
}

}  // namespace

int trainCommand(const Registry& registry, const TrainRequest& request) {
  const Configuration& configuration = request.configuration;
  auto files = TrainFiles::claim(request);
  if (!files) return fail(files.error());
  const auto environment = makeEnvironment(registry, configuration);
  if (!environment) return fail(environment.error());
  const auto lives = run(registry, request, *files);
  if (!lives) return fail(lives.error());

  // Whatever fails here, the rest is still reported.
  const Status written = files->finish(*lives, (*environment)->task().stepTime);
  const int printed = print(request.json ? resultAsJson(configuration, *lives) : resultAsTable(configuration, *lives));
  if (!written) return fail(written.error());
  if (printed != kDone) return printed;

  for (const LifeResult& life : *lives)
    if (!life.divergence.empty()) {
      const std::string which = configuration.lives > 1 ? fmt::format("life {}: ", life.life) : "";
      std::string message = which + life.divergence;
      if (request.save || request.checkpoint) message.replace(message.size() - 1, 1, "; nothing of it is saved.");
      return fail({message, ErrorKind::Diverged});
    }
  const auto complete =
      static_cast<int>(std::count_if(lives->begin(), lives->end(), [](const LifeResult& r) { return r.complete; }));
  if (complete < configuration.lives)
    return fail({fmt::format("interrupted; {} of {} lives are complete, the others end where they were.", complete,
                             configuration.lives),
                 ErrorKind::Interrupted});
  return kDone;
}

}  // namespace surefoot
