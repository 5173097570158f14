// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/laboratory_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "app/process/interrupt.h"
#include "app/process/resources.h"
#include "app/requests/requests.h"
#include "core/recipes/recipe.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

void addOption(CLI::App& app, const std::string& name, std::optional<std::string>& value, const std::string& help,
               const std::string& type) {
  app.add_option_function<std::string>(
         name, [&value](const std::string& text) { value = text; }, help)
      ->type_name(type);
}

void addAssignments(CLI::App& app, std::vector<std::string>& assignments, const std::string& help) {
  app.add_option("--set", assignments, help)->type_name("KEY=VALUE")->expected(1)->allow_extra_args(false)->take_all();
}

LaboratoryLine::LaboratoryLine(CLI::App& app)
    : experiment_(app.add_subcommand("experiment", "run a plan of many conditions, all lives of each, into a store")),
      reproduce_(app.add_subcommand("reproduce", "the figures of the thesis, and what its claims come to")),
      export_(app.add_subcommand("export", "write a store's tables as CSV, or a policy as C")),
      merge_(app.add_subcommand("merge", "join the parts of an experiment that was run in shards")),
      statistics_(app.add_subcommand("statistics", "what a store of results shows, with intervals and tests")) {
  ExperimentOptions& o = experimentOptions_;
  experiment_->add_option("PLAN", o.plan, "a plan that comes with the program, by its name, or a file")->type_name("");
  experiment_->add_option("--out", o.out, "the store to write, which must not exist yet")
      ->type_name("FILE")
      ->capture_default_str();
  addOption(*experiment_, "--lives", o.lives, "lives a condition, in place of the plan's", "N");
  addOption(*experiment_, "--seed", o.seed, "master seed, in place of the plan's", "N");
  addOption(*experiment_, "--jobs", o.jobs, "threads [all cores]", "N");
  addOption(*experiment_, "--shard", o.shard, "do part I of N only, for `surefoot merge`", "I/N");
  addAssignments(*experiment_, o.assignments, "a parameter of every condition; may be repeated");
  experiment_->add_flag("--resume", o.resume, "do what is missing in the store; begin it if it is not there");
  experiment_->add_flag("--other-version", o.otherVersion,
                        "with --resume: even if a version lived it whose lives are others");
  experiment_->add_flag("--dry-run", o.dryRun, "tell what would be done");
  experiment_->add_flag("--json", o.json, "tell progress and result as lines of JSON");

  ReproduceOptions& r = reproduceOptions_;
  reproduce_->add_option("LIST", r.list, "figures and tables by the thesis's numbers, such as 4.6; or all")
      ->type_name("");
  reproduce_->add_option("--lives", r.lives, "lives a condition: thesis (as many as it lived) or a number")
      ->type_name("N")
      ->capture_default_str();
  reproduce_->add_option("--out", r.out, "the folder to write to; what is done there already is not done again")
      ->type_name("FOLDER")
      ->capture_default_str();
  reproduce_
      ->add_option(
          "--seed", r.seeds,
          "master seed, in place of the recipes'; several: all of it under each, and how stable the verdicts are")
      ->type_name("N …");
  addOption(*reproduce_, "--preset", r.preset, "every condition on this preset: thesis or lab", "NAME");
  addOption(*reproduce_, "--jobs", r.jobs, "threads [all cores]", "N");
  reproduce_->add_flag("--dry-run", r.dryRun, "tell what would be done, and about how long it takes");
  reproduce_->add_flag("--other-version", r.otherVersion,
                       "go on even if a version lived what is there whose lives are others");

  export_->add_option("FILE", exportOptions_.file, "a store of results, or a Q-function")->type_name("");
  addOption(*export_, "--csv", exportOptions_.csv,
            "of a store: the folder to write its tables to; its files must not exist yet", "FOLDER");
  export_->add_flag("--for-spreadsheets", exportOptions_.forSpreadsheets, "with a byte order mark, as Excel wants it");
  addOption(*export_, "--c", exportOptions_.c,
            "of a Q-function: its greedy policy as C99 that needs no library; the file must not exist yet", "FILE");
  export_->add_flag("--float", exportOptions_.floats, "tables of float, half as large");
  export_->add_flag("--self-test", exportOptions_.selfTest,
                    "compiled with -DPOLICY_SELF_TEST it checks itself in 1,000 states");

  merge_->add_option("PARTS", mergeOptions_.parts, "the stores of all shards")->type_name("");
  addOption(*merge_, "--out", mergeOptions_.out, "the store to write, which must not exist yet", "FILE");
  merge_->add_flag("--other-version", mergeOptions_.otherVersion, "even if the parts hold lives of several versions");

  statistics_->add_option("STORE", statisticsOptions_.store, "a store of results")->type_name("");
  CLI::Option* json = statistics_->add_flag("--json", statisticsOptions_.json, "as JSON");
  CLI::Option* csv = statistics_->add_flag("--csv", statisticsOptions_.csv, "as CSV, a row a condition");
  statistics_->add_flag("--latex", statisticsOptions_.latex, "as a table for LaTeX")->excludes(json)->excludes(csv);
  csv->excludes(json);
}

namespace {

/// "2/5"
Status readShard(const std::string& text, LabOptions& lab) {
  const auto slash = text.find('/');
  const auto bad = Error{
      fmt::format("--shard: \"{}\" is not allowed; it takes I/N, such as 1/5, with I from 1 to N.", shortened(text))};
  if (slash == std::string::npos) return bad;
  const auto i = parseCount("--shard", text.substr(0, slash), 100'000),
             n = parseCount("--shard", text.substr(slash + 1), 100'000);
  if (!i || !n || *i > *n) return bad;
  lab.shard = static_cast<int>(*i);
  lab.shards = static_cast<int>(*n);
  return Done{};
}

Status readJobs(const std::optional<std::string>& text, LabOptions& lab) {
  const auto jobs = text ? parseCount("--jobs", *text, 1024)
                         : Result<std::int64_t>(std::max(1u, std::thread::hardware_concurrency()));
  if (!jobs) return jobs.error();
  lab.jobs = static_cast<int>(*jobs);
  return Done{};
}

Result<Request> makeReproduceRequest(const ReproduceOptions& o) {
  if (o.list.empty())
    return Error{fmt::format("LIST: what to reproduce is needed: {}, or all.", fmt::join(shippedRecipes(), ", "))};
  ReproduceRequest request{.recipes = {}, .out = o.out};
  request.otherVersion = o.otherVersion;
  request.dryRun = o.dryRun;
  request.changes.preset = o.preset;
  auto recipes = findRecipes(o.list);
  if (!recipes) return recipes.error();
  request.recipes = std::move(*recipes);
  if (o.lives != "thesis") {
    const auto lives = parseCount("--lives", o.lives, 1'000'000);
    if (!lives) return lives.error();
    request.changes.lives = static_cast<int>(*lives);
  }
  for (const std::string& text : o.seeds) {
    const auto seed = parseSeed("--seed", text);
    if (!seed) return seed.error();
    if (std::find(request.seeds.begin(), request.seeds.end(), *seed) != request.seeds.end())
      return Error{fmt::format("--seed: {} is named twice.", *seed)};
    request.seeds.push_back(*seed);
  }
  if (const Status s = readJobs(o.jobs, request.lab); !s) return s.error();
  return Request(std::move(request));
}

Result<Request> makeExperimentRequest(const Registry& registry, const ExperimentOptions& o) {
  ExperimentRequest request{.out = o.out, .resume = o.resume, .dryRun = o.dryRun, .json = o.json};
  request.otherVersion = o.otherVersion;
  if (o.otherVersion && !o.resume) return Error{"--other-version: it goes with --resume."};
  if (o.plan.empty())
    return Error{fmt::format("PLAN: a plan is needed, a file or one of {}.", joinWords(shippedPlans(), "or"))};
  PlanChanges changes;
  changes.interrupted = &watchForInterrupt();
  const auto assignments = parseAssignments(o.assignments);
  if (!assignments) return assignments.error();
  changes.assignments = *assignments;
  if (o.lives) {
    const auto lives = parseCount("--lives", *o.lives, 1'000'000);
    if (!lives) return lives.error();
    changes.lives = static_cast<int>(*lives);
  }
  if (o.seed) {
    const auto seed = parseSeed("--seed", *o.seed);
    if (!seed) return seed.error();
    changes.seed = *seed;
  }
  if (const Status s = readJobs(o.jobs, request.lab); !s) return s.error();
  if (o.shard)
    if (const Status s = readShard(*o.shard, request.lab); !s) return s.error();
  const auto path = findPlan(o.plan);
  if (!path) return path.error();
  // Reads figures and claims, too: errors in them should be reported before the lives run.
  auto recipe = readRecipe(registry, *path, changes);
  if (!recipe) return recipe.error();
  request.plan = std::move(recipe->plan);
  return Request(std::move(request));
}

}  // namespace

std::optional<Result<Request>> LaboratoryLine::request(const Registry& registry) const {
  if (experiment_->parsed()) return makeExperimentRequest(registry, experimentOptions_);
  if (reproduce_->parsed()) return makeReproduceRequest(reproduceOptions_);
  if (export_->parsed()) return Result<Request>(exportOptions_);
  if (merge_->parsed()) return Result<Request>(mergeOptions_);
  if (statistics_->parsed()) return Result<Request>(statisticsOptions_);
  return std::nullopt;
}

}  // namespace surefoot
