// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot experiment`: a plan into a store.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "app/reports/progress_line.h"
#include "app/requests/requests.h"
#include "core/basics/typed_json.h"
#include "core/laboratory/plan_store.h"
#include "core/plans/plan_programs.h"

namespace surefoot {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// " at first, and up to 200, until every comparison is decided"; empty: the number is fixed.
std::string growthText(const PlanGrowth& growth) {
  if (const auto& d = growth.decided)
    return fmt::format(" at first, and up to {}, until every comparison is decided", d->atMost);
  if (const auto& s = growth.search)
    return fmt::format(" at first, {} in all for the search, and {} more of the best and its reference", s->budget,
                       s->fresh);
  return "";
}

/// Prints the work that would be done, one line per condition.
int tellPlan(const ExperimentRequest& request) {
  const Plan& plan = request.plan;
  if (request.json) {
    OrderedJson list = OrderedJson::array();
    for (const Condition& c : plan.conditions)
      list.push_back({{"name", c.name}, {"seed", c.configuration.seed}, {"text", c.text}});
    const OrderedJson all = {{"title", plan.title},
                             {"seed", plan.seed},
                             {"lives", plan.lives},
                             {"paired", plan.paired},
                             {"conditions", list}};
    return print(jsonText(all, 2) + "\n");
  }
  std::string text = fmt::format("{}\n{} conditions, {} lives each{}, seed {}\n", plan.title, plan.conditions.size(),
                                 plan.lives, growthText(plan.growth), plan.seed);
  for (const Condition& c : plan.conditions) text += fmt::format("  {}\n      {}\n", c.name, c.text);
  return print(text);
}

class Teller {
 public:
  explicit Teller(bool json) : json_(json) {}
  bool wanted() const { return json_ || isatty(STDERR_FILENO); }
  void show(const LabProgress& p) {
    const int done = p.livesThere + p.work.livesDone;
    if (json_) {
      const auto time = std::chrono::steady_clock::now();
      if (time - told_ < std::chrono::seconds(1)) return;
      told_ = time;
      const OrderedJson now = {{"event", "progress"},  {"share", p.work.share}, {"lives", done},
                               {"of", p.livesPlanned}, {"falls", p.work.falls}, {"steps", p.work.steps}};
      print(jsonText(now) + "\n");
      return;
    }
    if (!line_) line_.emplace();
    line_->show(p.work.share, fmt::format("{} of {} lives, {} falls", done, p.livesPlanned, p.work.falls));
  }

 private:
  bool json_;
  std::optional<ProgressLine> line_;
  std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
};

}  // namespace

int experimentCommand(const Registry& registry, const ExperimentRequest& request) {
  if (request.dryRun) return tellPlan(request);
  if (const Status s = checkPrograms(registry, request.plan); !s) return fail(s.error());
  const PlanStore place{.path = request.out,
                        .resume = request.resume,
                        .anyVersion = request.otherVersion,
                        .remedy = kOtherVersion,
                        .shard = request.lab.shard,
                        .shards = request.lab.shards,
                        .interrupted = &watchForInterrupt()};
  auto store = openPlanStore(registry, request.plan, place);
  if (!store) return fail(store.error());
  tellNote(*store);

  LabOptions lab = request.lab;
  lab.interrupted = &watchForInterrupt();
  Result<LabResult> result = Error{};
  {
    Teller teller(request.json);
    if (teller.wanted()) lab.progress = [&](const LabProgress& p) { teller.show(p); };
    result = runPlan(registry, request.plan, *store, lab);
  }
  if (!result) return fail(result.error());
  const auto hash = store->contentHash();
  if (!hash) return fail(hash.error());
  int code = kDone;
  const OrderedJson done = {{"event", "done"},
                            {"store", request.out},
                            {"lives", result->livesThere},
                            {"of", result->livesPlanned},
                            {"complete", result->complete()},
                            {"pre_learnings_at_cap", result->preLearningsAtCap},
                            {"kept_in_hand", result->livesKept},
                            {"found", result->found},
                            {"content_hash", fmt::format("{:016x}", *hash)}};
  if (request.json)
    code = print(jsonText(done) + "\n");
  else
    code = print(fmt::format("{}: {} of {} lives, content {:016x}\n", request.out, result->livesThere,
                             result->livesPlanned, *hash));
  for (const std::string& sentence : result->found)
    if (code == kDone && !request.json) code = print(sentence + ".\n");
  if (code != kDone) return code;
  if (result->preLearningsAtCap > 0)
    std::fprintf(stderr,
                 "surefoot: %d Q-functions did not reach the reward of their pre-learning before its cap; they are "
                 "used as they are.\n",
                 result->preLearningsAtCap);
  if (!result->keeping) std::fprintf(stderr, "surefoot: %s\n", result->keeping.error().message.c_str());
  if (!result->complete())
    return fail({fmt::format("interrupted; {} of {} lives are in {}{}, and --resume does the rest.", result->livesThere,
                             result->livesPlanned, request.out,
                             result->livesKept > 0 ? ", those in hand are kept beside it" : ""),
                 ErrorKind::Interrupted});
  return kDone;
}

}  // namespace surefoot
