// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reports/reproduction.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "app/process/interrupt.h"
#include "app/requests/requests.h"
#include "core/files/whole_file.h"
#include "core/recipes/thesis_marks.h"

namespace surefoot {

namespace {

namespace fs = std::filesystem;

/// Runs the missing lives of a plan into a store, and reads all results and the hash of its content.
Result<std::vector<Evidence>> runAndRead(const Registry& registry, const Plan& plan, const StoredPlan& stored,
                                         const std::string& path, const LabOptions& lab, bool otherVersion,
                                         std::string& content) {
  auto store = Store::missing(path) ? Store::create(path, stored) : Store::openToWrite(path, &watchForInterrupt());
  if (!store) return store.error();
  const auto there = store->plan();
  if (!there) return there.error();
  if (const Status s = checkSamePlan(*there, stored, path); !s) return s.error();
  if (!plan.growth && there->conditions[0].lives != plan.lives)
    return Error{fmt::format("{}: it holds {} lives a condition and {} are asked for; name another folder.", path,
                             there->conditions[0].lives, plan.lives),
                 ErrorKind::File};
  const auto lives = store->lives();
  if (!lives) return lives.error();
  if (const Status s = checkLivesVersion(*lives, path); !s && !otherVersion) return orOtherVersion(s.error());
  const auto result = runPlan(registry, plan, *store, lab);
  if (!result) return result.error();
  if (!result->keeping) std::fprintf(stderr, "surefoot: %s\n", result->keeping.error().message.c_str());
  if (!result->complete())
    return Error{fmt::format("interrupted; {} of {} lives are in {}, and the same command goes on.", result->livesThere,
                             result->livesPlanned, path),
                 ErrorKind::Interrupted};
  const auto hash = store->contentHash();
  if (!hash) return hash.error();
  content = fmt::format("{:016x}", *hash);
  return readEvidence(registry, *store);
}

Result<std::vector<Judgement>> judgeAll(const Registry& registry, const Recipe& recipe,
                                        const std::vector<Evidence>& evidence) {
  std::vector<Judgement> judgements;
  for (const Claim& claim : recipe.claims) {
    auto judgement = judge(registry, claim, evidence, recipe.plan.seed);
    if (!judgement) return Error{recipe.name + ".toml: " + judgement.error().message};
    judgements.push_back(std::move(*judgement));
  }
  return judgements;
}

}  // namespace

Result<Reproduced> reproduce(const Registry& registry, const std::string& recipePath, const std::string& folder,
                             const PlanChanges& changes, const LabOptions& lab, bool otherVersion,
                             const std::function<Status(const Figure&, const std::string& folder)>& draw) {
  const auto start = std::chrono::steady_clock::now();
  const auto recipe = readRecipe(registry, recipePath, changes);
  if (!recipe) return recipe.error();
  const std::string own = (fs::path(folder) / recipe->name).string();
  std::error_code failed;
  fs::create_directories(own, failed);
  if (failed) return Error{fmt::format("--out: {} cannot be made: {}.", own, failed.message()), ErrorKind::File};

  const auto stored = planToStore(registry, recipe->plan);
  if (!stored) return stored.error();
  std::string content;
  const auto evidence =
      runAndRead(registry, recipe->plan, *stored, own + "/results.sqlite", lab, otherVersion, content);
  if (!evidence) return evidence.error();
  Reproduced done{.name = recipe->name,
                  .title = recipe->plan.title,
                  .preset = changes.preset.value_or("thesis"),
                  .content = content,
                  .lives = recipe->plan.lives,
                  .conditions = static_cast<int>(evidence->size())};
  for (const FigureSpec& spec : recipe->figures) {
    auto figure = makeFigure(registry, spec, *evidence);
    if (!figure) return Error{recipe->name + ".toml: " + figure.error().message};
    markThesis(*figure, spec.measure, recipe->claims, *evidence);
    if (const Status s = writeWhole("--out", own + "/" + figure->name + ".csv", figureAsCsv(*figure)); !s)
      return s.error();
    if (const Status s = draw(*figure, own); !s) return s.error();
    done.figures.push_back(recipe->name + "/" + figure->name);
    done.captions.push_back(figure->title);
  }
  done.table = conditionsTable(findingsOf(*stored, *evidence), *evidence, recipe->table);
  auto judgements = judgeAll(registry, *recipe, *evidence);
  if (!judgements) return judgements.error();
  done.judgements = std::move(*judgements);

  if (recipe->calibrated() && !changes.preset) {
    const auto onLab = onLabPreset(registry, recipePath, changes);
    if (!onLab) return onLab.error();
    const auto labStored = planToStore(registry, onLab->plan);
    if (!labStored) return labStored.error();
    const auto labEvidence =
        runAndRead(registry, onLab->plan, *labStored, own + "/results-lab.sqlite", lab, otherVersion, done.labContent);
    if (!labEvidence) return labEvidence.error();
    auto labJudgements = judgeAll(registry, *onLab, *labEvidence);
    if (!labJudgements) return labJudgements.error();
    done.onLabPreset = std::move(*labJudgements);
    for (const Claim& claim : onLab->claims) done.calibrated.push_back(claim.id);
  }
  if (const Status s = writeWhole("--out", own + "/claims.json", claimsAsJson({done})); !s) return s.error();
  done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return done;
}

}  // namespace surefoot
