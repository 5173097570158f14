// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot robustness`: how often what was learned falls, over pushes and models.
#include <fmt/format.h>
#include <unistd.h>

#include <thread>

#include "app/commands/commands.h"
#include "app/process/interrupt.h"
#include "app/reports/progress_line.h"
#include "app/requests/requests.h"
#include "core/files/whole_file.h"
#include "core/robustness/robustness_text.h"
#include "core/saved/q_file.h"

namespace surefoot {

namespace {

Result<std::vector<TriedFunction>> openTried(const Registry& registry, const RobustnessRequest& r) {
  if (r.file.empty()) return Error{"FILE: the name of a Q-function is needed, as `surefoot train --save` writes it."};
  std::vector<TriedFunction> tried;
  for (const std::string& path : {r.file, r.second}) {
    if (path.empty()) continue;
    auto file = readQFile(path);
    if (!file) return file.error();
    auto function = makeTried(registry, path, std::move(*file));
    if (!function) return function.error();
    tried.push_back(std::move(*function));
  }
  return tried;
}

Result<Robustness> triedOut(const Registry& registry, const RobustnessPlan& plan,
                            const std::vector<const TriedFunction*>& functions, int jobs) {
  std::optional<ProgressLine> line;
  std::function<void(double)> progress;
  if (isatty(STDERR_FILENO)) {
    progress = [&](double share) {
      if (!line) line.emplace();
      line->show(share, fmt::format("{} cells", plan.cells()));
    };
  }
  return tryOut(registry, plan, functions, jobs, &watchForInterrupt(), progress);
}

}  // namespace

int robustnessCommand(const Registry& registry, const RobustnessRequest& request) {
  const auto jobs = request.jobs ? parseCount("--jobs", *request.jobs, 1024)
                                 : Result<std::int64_t>(std::max(1u, std::thread::hardware_concurrency()));
  if (!jobs) return fail(jobs.error());
  const auto tried = openTried(registry, request);
  if (!tried) return fail(tried.error());
  std::vector<const TriedFunction*> functions;
  for (const TriedFunction& function : *tried) functions.push_back(&function);
  const auto plan = makeRobustnessPlan(registry, functions, request.question);
  if (!plan) return fail(plan.error());
  tell(plan->note);

  std::optional<WholeFile> csv;  // claimed before anything is lived
  if (request.csv) {
    auto created = WholeFile::createNew("--csv", *request.csv);
    if (!created) return fail(created.error());
    csv.emplace(std::move(*created));
  }
  const auto robustness = triedOut(registry, *plan, functions, static_cast<int>(*jobs));
  if (!robustness) return fail(robustness.error());
  if (csv)
    if (const Status s = csv->commit(robustnessAsCsv(*robustness)); !s) return fail(s.error());
  return print(request.json ? robustnessAsJson(*robustness) : robustnessAsTable(*robustness));
}

}  // namespace surefoot
