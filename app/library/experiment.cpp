// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <atomic>
#include <thread>

#include "app/library/description.h"
#include "app/library/handle.h"
#include "app/library/ours.h"
#include "app/process/resources.h"
#include "core/basics/typed_json.h"
#include "core/environment_library.h"
#include "core/environment_programs.h"
#include "core/laboratory/laboratory.h"
#include "core/laboratory/plan_store.h"
#include "core/plans/plan.h"
#include "core/plans/plan_programs.h"

using namespace surefoot;

namespace {

using Progress = int (*)(void*, const surefoot_progress*);

struct Wanted {
  Plan plan{};
  PlanStore place{};
  LabOptions lab{};
};

Result<Plan> planOf(const Registry& registry, const std::string& plan, const PlanChanges& changes) {
  if (plan.find('\n') != std::string::npos) return parsePlan(registry, plan, "plan", changes);
  const auto path = findPlan(plan);
  if (!path) return path.error();
  return readPlan(registry, *path, changes);
}

Result<Wanted> wantedOf(const Registry& registry, const std::string& plan, const char* options) {
  const auto json =
      parseDescription(options, "options", {"out", "lives", "seed", "jobs", "resume", "parameters", "programs"});
  if (!json) return json.error();
  Wanted wanted;
  const auto out = textOf(*json, "out"), lives = numberOf(*json, "lives"), seed = numberOf(*json, "seed"),
             jobs = numberOf(*json, "jobs");
  const auto resume = flagOf(*json, "resume"), programs = flagOf(*json, "programs");
  for (const auto* text : {&out, &lives, &seed, &jobs})
    if (!*text) return text->error();
  for (const auto* flag : {&resume, &programs})
    if (!*flag) return flag->error();
  if (!*out || (*out)->empty()) return Error{"out: the file of the store is needed."};
  wanted.place = {.path = **out, .resume = *resume};
  PlanChanges changes;
  const auto texts = assignmentsIn(json->value("parameters", nlohmann::json()));
  if (!texts) return texts.error();
  auto assignments = parseAssignments(*texts);
  if (!assignments) return assignments.error();
  changes.assignments = std::move(*assignments);
  if (*lives) {
    const auto count = parseCount("lives", **lives, 1'000'000);
    if (!count) return count.error();
    changes.lives = static_cast<int>(*count);
  }
  if (*seed) {
    const auto number = parseSeed("seed", **seed);
    if (!number) return number.error();
    changes.seed = *number;
  }
  wanted.lab.jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  if (*jobs) {
    const auto count = parseCount("jobs", **jobs, 1024);
    if (!count) return count.error();
    wanted.lab.jobs = static_cast<int>(*count);
  }
  auto read = planOf(registry, plan, changes);
  if (!read) return read.error();
  wanted.plan = std::move(*read);
  if (*programs)
    for (const Condition& c : wanted.plan.conditions) allowProgram(registry, c.configuration);
  return wanted;
}

Result<std::string> runIt(const Registry& registry, Wanted& wanted, Progress progress, void* user) {
  if (const Status s = checkPrograms(registry, wanted.plan); !s) return s.error();
  auto store = openPlanStore(registry, wanted.plan, wanted.place);
  if (!store) return store.error();
  std::atomic<bool> stop{false};
  wanted.lab.interrupted = &stop;
  if (progress)
    wanted.lab.progress = [&](const LabProgress& p) {
      const surefoot_progress now{.share = p.work.share,
                                  .lives = p.livesThere + p.work.livesDone,
                                  .of = p.livesPlanned,
                                  .falls = p.falls,
                                  .steps = p.work.steps};
      if (progress(user, &now) != 0) stop = true;
    };
  const auto result = runPlan(registry, wanted.plan, *store, wanted.lab);
  if (!result) return result.error();
  const auto hash = store->contentHash();
  if (!hash) return hash.error();
  if (!result->complete())
    return Error{fmt::format("interrupted; {} of {} lives are in {}; with \"resume\" the rest is done.",
                             result->livesThere, result->livesPlanned, wanted.place.path),
                 ErrorKind::Interrupted};
  const OrderedJson done = {{"store", wanted.place.path},
                            {"lives", result->livesThere},
                            {"of", result->livesPlanned},
                            {"complete", true},
                            {"content_hash", fmt::format("{:016x}", *hash)},
                            {"found", result->found}};
  return jsonText(done);
}

}  // namespace

surefoot_status surefoot_experiment(const char* plan, const char* options,
                                    int (*progress)(void* user, const surefoot_progress* progress), void* user,
                                    const char** json) {
  return call([&]() -> Status {
    thread_local std::string told;
    const auto registry = ourRegistry();
    if (!registry) return registry.error();
    const auto text = given(plan, "plan");
    if (!text) return text.error();
    auto wanted = wantedOf(**registry, *text, options);
    if (!wanted) return wanted.error();
    auto done = runIt(**registry, *wanted, progress, user);
    if (!done) return done.error();
    told = std::move(*done);
    if (json) *json = told.c_str();
    return Done{};
  });
}
