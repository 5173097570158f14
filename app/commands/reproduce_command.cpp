// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot reproduce`: the thesis's figures and claims.
#include <fmt/format.h>
#include <unistd.h>

#include "app/commands/commands.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "app/process/resources.h"
#include "app/reports/figures.h"
#include "app/reports/progress_line.h"
#include "app/reports/reproduction.h"

namespace surefoot {

namespace {

/// The verdicts on a recipe's claims.
std::string verdictsOf(const Reproduced& r) {
  std::string text = fmt::format("{}: {} ({})\n", r.name, r.title, durationText(r.seconds));
  const auto add = [&](const std::vector<Judgement>& judgements, const char* preset) {
    for (const Judgement& j : judgements)
      text += fmt::format("  {:<5}{:<10} {}{}\n", j.id, nameOf(j.verdict), j.says, preset);
  };
  add(r.judgements, "");
  add(r.onLabPreset, " (lab preset)");
  return text;
}

}  // namespace

int reproduceCommand(const Registry& registry, const ReproduceRequest& request) {
  LabOptions lab = request.lab;
  lab.interrupted = &watchForInterrupt();
  if (const Status s = checkReportPlace(request.out); !s) return fail(s.error());
  FigureDrawer drawer;
  std::vector<Reproduced> done;
  for (const std::string& path : request.recipes) {
    std::optional<ProgressLine> line;
    if (isatty(STDERR_FILENO)) {
      line.emplace();
      lab.progress = [&](const LabProgress& p) {
        line->show(p.work.share, fmt::format("recipe {} of {}: {} of {} lives", done.size() + 1, request.recipes.size(),
                                             p.livesThere + p.work.livesDone, p.livesPlanned));
      };
    }
    auto result =
        reproduce(registry, path, request.out, request.changes, lab, request.otherVersion,
                  [&](const Figure& figure, const std::string& folder) { return drawer.draw(figure, folder); });
    line.reset();
    if (!result) return fail(result.error());
    if (const int code = print(verdictsOf(*result)); code != kDone) return code;
    done.push_back(std::move(*result));
  }
  if (const Status s = writeReport(done, request.out, FigureDrawer::canDraw()); !s) return fail(s.error());
  if (!FigureDrawer::canDraw())
    std::fprintf(stderr, "surefoot: no figures were drawn: that needs the program with its window (Qt).\n");
  return print(fmt::format("{0}/report.html, {0}/report.md, {0}/claims.json\n", request.out));
}

}  // namespace surefoot
