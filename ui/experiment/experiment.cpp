// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/experiment.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "core/basics/typed_json.h"
#include "core/files/limited_json.h"
#include "core/life/life_measures.h"

namespace surefoot {

Experiment::Experiment(const Registry& registry, std::vector<PlanSource> sources, QString folder, QObject* parent)
    : QObject(parent),
      registry_(registry),
      sources_(std::move(sources)),
      folder_(std::move(folder)),
      results_(registry) {
  connect(&results_, &ExperimentResults::changed, this, &Experiment::resultsChanged);
  connect(&results_, &ExperimentResults::failed, this, &Experiment::failed);
  connect(&opening_, &Background::busyChanged, this, &Experiment::stateChanged);
  connect(&opening_, &Background::failed, this, &Experiment::failed);
  connect(&timer_, &QTimer::timeout, this, &Experiment::tick);
}

std::vector<FigureSpec> Experiment::standardFigures(const StoredPlan& plan) const {
  const auto figure = [](const std::string& name, const std::string& title, const char* kind,
                         const std::string& measure = "falls") {
    return FigureSpec{.name = name,
                      .title = title,
                      .kind = kind,
                      .conditions = {},
                      .measure = measure,
                      .along = {},
                      .q = {},
                      .state = {}};
  };
  std::vector<FigureSpec> figures = {
      figure("falls", QT_TRANSLATE_NOOP("core", "Falls during learning"), "bars"),
      figure("average-reward", QT_TRANSLATE_NOOP("core", "Average reward"), "learning-curve"),
      figure("reward-against-falls", QT_TRANSLATE_NOOP("core", "Average reward against falls"), "reward-against-falls"),
      figure("cumulative-falls", QT_TRANSLATE_NOOP("core", "Cumulative falls"), "cumulative-falls"),
      figure("learning-time", QT_TRANSLATE_NOOP("core", "Learning time"), "bars", "minutes"),
      figure("end-performance", QT_TRANSLATE_NOOP("core", "Falls per episode at the end"), "bars", "end_performance")};
  std::set<std::string> environments;
  for (const StoredCondition& c : plan.conditions) {
    const auto configuration = parseJson(c.configuration);
    if (configuration.is_object()) environments.insert(textIn(configuration, "environment"));
  }
  for (const LifeMeasure& m : lifeMeasures(taskMeasuresOf(registry_, environments))) {
    std::string title = m.title;
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    figures.push_back(figure(m.name, title, "bars", m.name));
  }
  return figures;
}

Result<Plan> Experiment::parse(const std::string& text) const {
  return parsePlan(registry_, text, path_.empty() ? "plan" : path_, {});
}

void Experiment::choose(const std::string& condition) {
  if (condition == chosen_) return;
  chosen_ = condition;
  Q_EMIT chosenChanged();
}

void Experiment::setState(State state) {
  state_ = state;
  Q_EMIT stateChanged();
}

QString Experiment::whyNoResults() const {
  if (state_ == State::Following) return tr("Appears with the first lives.");
  if (!plan_) return tr("Choose a plan, and run it.");
  return state_ == State::Running ? tr("Appears with the first lives.") : tr("Appears when the plan runs.");
}

const ThesisVerdict* Experiment::thesisOn(const std::string& condition) const {
  const auto found = results_.thesis().find(condition);
  return found == results_.thesis().end() ? nullptr : &found->second;
}

bool Experiment::isInPercent(const std::string& id) const {
  for (const Claim& claim : results_.claims())
    if (claim.id == id)
      return claim.kind == "reduction" || claim.kind == "significant" || claim.kind == "no-difference" ||
             claim.kind == "extreme";
  return false;
}

std::optional<Figure> Experiment::figure(const FigureSpec& spec) const {
  if (!view()) return std::nullopt;
  const auto figure = figureOf(registry_, spec, *view(), results_.claims());
  return figure ? std::optional<Figure>(*figure) : std::nullopt;
}

int Experiment::livesOf(const std::string& condition) const {
  if (view())
    for (const Evidence& e : view()->evidence)
      if (e.name() == condition) return static_cast<int>(e.lives.size()) + e.record.diverged;
  return 0;
}

}  // namespace surefoot

#include "moc_experiment.cpp"
