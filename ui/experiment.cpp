// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QThread>
#include <algorithm>
#include <thread>

#include "ui/symbol_text.h"

namespace surefoot {

namespace {
constexpr int kTick = 200;  // [ms]

/// Of the lives that are over.
std::int64_t fallsIn(const LabView& view) {
  std::int64_t falls = 0;
  for (const Evidence& e : view.evidence)
    for (const StoredLife& life : e.record.lives) falls += life.falls;
  return falls;
}
}  // namespace

Experiment::Experiment(const Registry& registry, std::vector<PlanSource> sources, QString folder, QObject* parent)
    : QObject(parent),
      registry_(registry),
      sources_(std::move(sources)),
      folder_(std::move(folder)),
      results_(registry) {
  connect(&results_, &ExperimentResults::changed, this, &Experiment::resultsChanged);
  connect(&opening_, &Background::busyChanged, this, &Experiment::stateChanged);
  connect(&timer_, &QTimer::timeout, this, &Experiment::tick);
}

std::vector<FigureSpec> Experiment::standardFigures(const StoredPlan& plan) const {
  const auto figure = [](const char* name, const char* title, const char* kind, const char* measure = "falls") {
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
      figure("falls", "Falls during learning", "bars"),
      figure("average-reward", "Average reward", "learning-curve"),
      figure("reward-against-falls", "Average reward against falls", "reward-against-falls"),
      figure("cumulative-falls", "Cumulative falls", "cumulative-falls"),
      figure("learning-time", "Learning time", "bars", "minutes"),
      figure("end-performance", "Falls per episode at the end", "bars", "end_performance")};
  const bool walks = std::any_of(plan.conditions.begin(), plan.conditions.end(), [&](const StoredCondition& c) {
    const auto configuration = nlohmann::json::parse(c.configuration, nullptr, false);
    if (!configuration.is_object()) return false;
    const auto entry =
        findEntry(registry_.environments, "environment", configuration.value("environment", std::string()));
    return entry && measureAt((*entry)->make()->task().measures, "distance").has_value();
  });
  if (!walks) return figures;
  figures.push_back(figure("distance", "Distance of a life", "bars", "distance"));
  figures.push_back(figure("greedy-distance", "Distance of a greedy test at the end", "bars", "greedy_distance"));
  figures.push_back(figure("greedy-footsteps", "Net footsteps of a greedy test", "bars", "greedy_net_footsteps"));
  return figures;
}

Result<Plan> Experiment::parse(const std::string& text) const {
  return parsePlan(registry_, text, path_.empty() ? "plan" : path_, {});
}

Status Experiment::run() {
  if (!plan_ || state_ == State::Running) return Done{};
  thread_.reset();
  if (storePath_.empty()) {
    if (!QDir().mkpath(folder_))
      return Error{tr("The results have no place: %1 cannot be made.").arg(folder_).toStdString()};
    storePath_ = placeForResults();
  }
  auto store = Store::missing(storePath_) ? Store::create(storePath_, stored_) : Store::openToWrite(storePath_);
  if (!store) return store.error();
  const int jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  thread_ = std::make_unique<LaboratoryThread>(registry_, *plan_, std::move(*store), jobs);
  running_.start();
  shareAtStart_ = share_;
  fallsAtStart_ = falls_;
  setState(State::Running);
  timer_.start(kTick);
  return Done{};
}

/// A new empty file, named by the time; another window may have taken the name in the same millisecond.
std::string Experiment::placeForResults() const {
  for (;;) {
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd-HHmmss-zzz"));
    QFile file(QDir(folder_).filePath(QStringLiteral("results-%1.sqlite").arg(stamp)));
    // What cannot be made at all is told by the store.
    if (file.open(QIODevice::WriteOnly | QIODevice::NewOnly) || !file.exists()) return file.fileName().toStdString();
    QThread::msleep(1);
  }
}

void Experiment::pause() {
  if (state_ != State::Running) return;
  thread_->stop();
}

void Experiment::reset() {
  if (plan_ && livesDone_ > 0) Q_EMIT leftBehind(toText(storePath_));
  timer_.stop();
  thread_.reset();
  view_.reset();
  results_.begin(results_.claims(), stored_);
  storePath_.clear();
  before_ = share_ = 0;
  livesDone_ = 0;
  falls_ = 0;
  setState(State::Ready);
}

void Experiment::take() {
  const LabProgress p = thread_->progress();
  livesDone_ = std::max(livesDone_, p.livesThere + p.work.livesDone);
  const double open = 1.0 - shareAtStart_;
  share_ = std::max(share_, shareAtStart_ + open * p.work.share);
  falls_ = fallsAtStart_ + p.work.falls;
  Q_EMIT progressed();
  if (auto view = thread_->view(); view && view != view_) {
    view_ = std::move(view);
    results_.show(view_);
  }
}

void Experiment::tick() {
  if (!thread_) return;
  const bool over = thread_->over();
  take();
  if (!over || results_.view() != view_) return;  // until the last results are shown, too
  timer_.stop();
  before_ = elapsed();
  const std::string trouble = thread_->trouble();
  const bool complete = thread_->complete();
  thread_.reset();
  if (complete) share_ = 1, livesDone_ = livesPlanned();
  if (view_) falls_ = fallsIn(*view_);  // without the lives that were given up
  setState(complete ? State::Complete : State::Paused);
  Q_EMIT progressed();
  if (!trouble.empty()) Q_EMIT failed(toText(trouble));
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

int Experiment::livesPlanned() const {
  int lives = 0;
  for (const StoredCondition& c : stored_.conditions) lives += c.lives;
  return lives;
}

double Experiment::elapsed() const {
  return before_ + (state_ == State::Running ? static_cast<double>(running_.elapsed()) * 1e-3 : 0.0);
}

std::optional<double> Experiment::left() const {
  const double done = share_ - shareAtStart_;
  if (state_ != State::Running || done < 0.01) return std::nullopt;
  return static_cast<double>(running_.elapsed()) * 1e-3 * (1.0 - share_) / done;
}

int Experiment::livesOf(const std::string& condition) const {
  if (view())
    for (const Evidence& e : view()->evidence)
      if (e.name() == condition) return static_cast<int>(e.lives.size()) + e.record.diverged;
  return 0;
}

}  // namespace surefoot
