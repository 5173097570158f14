// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot reproduce`: the thesis's figures and claims.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "app/commands/commands.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "app/process/resources.h"
#include "app/reports/figures.h"
#include "app/reports/progress_line.h"
#include "app/reports/reproduction.h"
#include "app/reports/stability.h"
#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "core/plans/plan_time.h"

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

/// Whether any condition of a recipe is on the preset that was asked for.
bool isOnPreset(const Recipe& recipe, const std::string& preset) {
  const auto& all = recipe.plan.conditions;
  return std::any_of(all.begin(), all.end(),
                     [&](const Condition& c) { return c.configuration.names.preset == preset; });
}

/// A recipe that varies what the preset holds, too, has two equal conditions on it: of several recipes it is left out.
bool isLeftOut(const Result<Recipe>& recipe, const ReproduceRequest& request) {
  if (recipe || !request.changes.preset || request.recipes.size() < 2) return false;
  std::fprintf(stderr, "surefoot: left out on the preset %s: %s\n", request.changes.preset->c_str(),
               recipe.error().message.c_str());
  return true;
}

/// Prints what would be done and about how long it takes, a line a recipe.
int tell(const Registry& registry, const ReproduceRequest& request) {
  std::string text;
  double minutes = 0;
  for (const std::string& path : request.recipes) {
    const auto recipe = readRecipe(registry, path, request.changes);
    if (isLeftOut(recipe, request)) continue;
    if (!recipe) return fail(recipe.error());
    if (request.changes.preset && !isOnPreset(*recipe, *request.changes.preset)) continue;
    const auto content = readText(path);
    if (!content) return fail(content.error());
    const auto file = parsePlanFile(*content, path);
    if (!file) return fail(file.error());
    const double own = minutesFor(registry, *file, request.lab.jobs, request.changes.lives);
    minutes += own;
    text += fmt::format("{}: {}; {} conditions, {} lives each, about {}\n", recipe->name, recipe->plan.title,
                        recipe->plan.conditions.size(), recipe->plan.lives, roundedTime(own));
  }
  const std::size_t seeds = std::max<std::size_t>(1, request.seeds.size());
  minutes *= static_cast<double>(seeds);
  return print(text + fmt::format("In all about {}{}, within a factor of two.\n", roundedTime(minutes),
                                  seeds > 1 ? fmt::format(" for {} master seeds", seeds) : ""));
}

/// All recipes under one master seed, with their report in `folder`.
class Reproduction {
 public:
  Reproduction(const Registry& registry, const ReproduceRequest& request)
      : registry_(registry),
        request_(request),
        lab_(request.lab) {
    lab_.interrupted = &watchForInterrupt();
  }

  /// An exit code; kDone: `done` has the results.
  int under(const PlanChanges& changes, const std::string& folder, std::vector<Reproduced>& done) {
    if (const Status s = checkReportPlace(folder); !s) return fail(s.error());
    for (const std::string& path : request_.recipes) {
      if (changes.preset) {
        const auto recipe = readRecipe(registry_, path, changes);
        if (isLeftOut(recipe, request_)) continue;
        if (!recipe) return fail(recipe.error());
        if (!isOnPreset(*recipe, *changes.preset)) continue;
      }
      std::optional<ProgressLine> line;
      if (isatty(STDERR_FILENO)) tellProgress(line, done.size() + 1);
      auto result = reproduce(registry_, path, folder, changes, lab_, request_.otherVersion,
                              [&](const Figure& figure, const std::string& own) { return drawer_.draw(figure, own); });
      line.reset();
      if (!result) return fail(result.error());
      if (const int code = print(verdictsOf(*result)); code != kDone) return code;
      done.push_back(std::move(*result));
    }
    if (const Status s = writeReport(done, folder, FigureDrawer::canDraw()); !s) return fail(s.error());
    return print(fmt::format("{0}/report.html, {0}/report.md, {0}/claims.json\n", folder));
  }

 private:
  void tellProgress(std::optional<ProgressLine>& line, std::size_t recipe) {
    line.emplace();
    lab_.progress = [this, &line, recipe](const LabProgress& p) {
      line->show(p.work.share, fmt::format("recipe {} of {}: {} of {} lives", recipe, request_.recipes.size(),
                                           p.livesThere + p.work.livesDone, p.livesPlanned));
    };
  }

  const Registry& registry_;
  const ReproduceRequest& request_;
  LabOptions lab_;
  FigureDrawer drawer_;
};

}  // namespace

int reproduceCommand(const Registry& registry, const ReproduceRequest& request) {
  if (const auto& preset = request.changes.preset) {
    std::vector<std::string> names;
    for (const auto& p : registry.presets) names.push_back(p.name);
    if (std::find(names.begin(), names.end(), *preset) == names.end())
      return fail(Error{"--" + unknownName("preset", *preset, names).message, ErrorKind::Usage});
  }
  if (request.dryRun) return tell(registry, request);
  Reproduction reproduction(registry, request);
  std::vector<OfSeed> seeds;
  for (const std::uint64_t seed : request.seeds) seeds.push_back({seed, {}});
  if (seeds.empty()) seeds.push_back({});
  for (OfSeed& of : seeds) {
    PlanChanges changes = request.changes;
    if (!request.seeds.empty()) changes.seed = of.seed;
    const std::string folder = seeds.size() > 1 ? fmt::format("{}/seed-{}", request.out, of.seed) : request.out;
    if (const int code = reproduction.under(changes, folder, of.recipes); code != kDone) return code;
  }
  if (!FigureDrawer::canDraw())
    std::fprintf(stderr, "surefoot: no figures were drawn: that needs the program with its window (Qt).\n");
  if (seeds.size() < 2) return kDone;
  for (const auto& [name, text] :
       {std::pair("stability.md", stabilityAsMarkdown(seeds)), std::pair("stability.json", stabilityAsJson(seeds))})
    if (const Status s = writeWhole("--out", request.out + "/" + name, text); !s) return fail(s.error());
  return print(fmt::format("{0}/stability.md, {0}/stability.json\n", request.out));
}

}  // namespace surefoot
