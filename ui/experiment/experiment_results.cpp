// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/experiment_results.h"

#include "core/basics/typed_json.h"
#include "core/files/limited_json.h"
#include "core/recipes/thesis_marks.h"

namespace surefoot {

namespace {
constexpr std::chrono::milliseconds kResultsPatience(40);  // wait this long, so that quick results show at once
}

ExperimentResults::ExperimentResults(const Registry& registry, QObject* parent) : QObject(parent), registry_(registry) {
  connect(&making_, &Background::busyChanged, this, [this] {
    if (making_.busy() || !cancelled_) return;
    cancelled_ = false;
    if (stale_) make();
  });
  connect(&making_, &Background::failed, this, [this](const QString& sentence) {
    if (std::exchange(trouble_, sentence) != sentence) Q_EMIT failed(sentence);
    if (stale_) make();
  });
}

void ExperimentResults::begin(std::vector<Claim> claims, const StoredPlan& plan) {
  cancelled_ = making_.busy();
  making_.cancel();
  claims_ = std::move(claims);
  seed_ = plan.seed;
  policies_.clear();
  for (const StoredCondition& c : plan.conditions) {
    const auto configuration = parseJson(c.configuration);
    if (configuration.is_object()) policies_[c.name] = textIn(configuration, "policy");
  }
  newest_.reset();
  trouble_.clear();
  wanted_.clear();
  shown_ = {};
  stale_ = false;
}

void ExperimentResults::show(std::shared_ptr<const LabView> view) {
  newest_ = std::move(view);
  make();
}

void ExperimentResults::want(std::size_t place, const FigureSpec& spec) {
  wanted_[place] = spec;
  if (newest_ && !shown_.figures.contains(spec.name)) make();
}

const Figure* ExperimentResults::figure(const std::string& name) const {
  const auto found = shown_.figures.find(name);
  return found == shown_.figures.end() ? nullptr : found->second.get();
}

std::string ExperimentResults::policyOf(const std::string& condition) const {
  const auto found = policies_.find(condition);
  return found == policies_.end() ? "" : found->second;
}

bool ExperimentResults::isComplete(const std::string& condition) const {
  if (!shown_.view) return false;
  const auto all = [&](const std::string& name) {
    for (const Evidence& e : shown_.view->evidence)
      if (e.name() == name) return static_cast<int>(e.lives.size()) + e.record.diverged >= e.record.condition.lives;
    return true;
  };
  for (const StoredCondition& c : shown_.view->findings.plan.conditions)
    if (c.name == condition) return all(condition) && all(c.reference);
  return true;
}

void ExperimentResults::judge(const Registry& registry, const std::vector<Claim>& claims, std::uint64_t seed,
                              Shown& shown, const std::atomic<bool>& interrupted) {
  for (const Evidence& e : shown.view->evidence) {
    shown.lives += static_cast<int>(e.lives.size()) + e.record.diverged;
    for (const StoredLife& life : e.record.lives) shown.falls += life.falls;
  }
  for (const Claim& claim : claims) {
    if (interrupted) return;
    if (auto judgement = surefoot::judge(registry, claim, shown.view->evidence, seed))
      shown.judgements.push_back(std::move(*judgement));
  }
  shown.thesis = thesisVerdicts(registry, claims, shown.view->evidence, seed);
}

void ExperimentResults::make() {
  if (making_.busy()) {
    stale_ = true;
    return;
  }
  stale_ = false;
  const bool same = newest_ == shown_.view;
  auto next = std::make_shared<Shown>(same ? shown_ : Shown{});
  next->view = newest_;
  making_.start(
      [&registry = registry_, claims = claims_, wanted = wanted_, seed = seed_, next,
       same](const std::atomic<bool>& interrupted) {
        if (!same) judge(registry, claims, seed, *next, interrupted);
        for (const auto& [place, spec] : wanted)
          if (!interrupted && !next->figures.contains(spec.name))
            next->figures[spec.name] = figureOf(registry, spec, *next->view, claims);
      },
      [this, next] {
        shown_ = std::move(*next);
        Q_EMIT changed();
        if (stale_) make();
      },
      kResultsPatience);
}

std::shared_ptr<const Figure> figureOf(const Registry& registry, const FigureSpec& spec, const LabView& view,
                                       const std::vector<Claim>& claims) {
  auto figure = makeFigure(registry, spec, view.evidence);
  if (!figure) return nullptr;
  markThesis(*figure, spec.measure, claims, view.evidence);
  return std::make_shared<const Figure>(std::move(*figure));
}

}  // namespace surefoot

#include "moc_experiment_results.cpp"
