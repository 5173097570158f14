// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QThread>
#include <algorithm>
#include <thread>

#include "core/files/read_file.h"
#include "core/laboratory/thesis_marks.h"
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

bool isStore(const std::string& path) {
  const auto head = readHead(path, 15);
  return head && *head == "SQLite format 3";
}
}  // namespace

Experiment::Experiment(const Registry& registry, std::vector<PlanSource> sources, QString folder, QObject* parent)
    : QObject(parent),
      registry_(registry),
      sources_(std::move(sources)),
      folder_(std::move(folder)) {
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

Status Experiment::readText(const std::string& text, const std::string& path) {
  auto plan = parsePlan(registry_, text, path, {});
  if (!plan) return plan.error();
  auto stored = planToStore(registry_, *plan);
  if (!stored) return stored.error();
  std::vector<FigureSpec> figures = standardFigures(*stored);
  std::vector<Claim> claims;
  if (text.find("[[figure]]") != std::string::npos) {
    if (auto recipe = readRecipe(registry_, path, {})) {
      figures.insert(figures.end(), recipe->figures.begin(), recipe->figures.end());
      claims = std::move(recipe->claims);
    }
  }
  reset();
  text_ = text;
  title_ = plan->title;
  plan_ = std::move(*plan);
  stored_ = std::move(*stored);
  figures_ = std::move(figures);
  claims_ = std::move(claims);
  return Done{};
}

Status Experiment::open(const std::string& path) {
  if (isStore(path)) return openStore(path);
  const auto text = surefoot::readText(path);
  if (!text) return text.error();
  if (const Status s = readText(*text, path); !s) return s;
  path_ = path;
  Q_EMIT planChanged();
  Q_EMIT resultsChanged();
  return Done{};
}

Result<Plan> Experiment::parse(const std::string& text) const {
  return parsePlan(registry_, text, path_.empty() ? "plan" : path_, {});
}

Status Experiment::setText(const std::string& text) {
  if (const Status s = readText(text, path_.empty() ? "plan" : path_); !s) return s;
  Q_EMIT planChanged();
  Q_EMIT resultsChanged();
  return Done{};
}

Status Experiment::openStore(const std::string& path) {
  const auto store = Store::open(path);
  if (!store) return store.error();
  auto view = viewOf(*store);
  if (!view) return view.error();
  reset();
  plan_.reset();
  text_.clear();
  claims_.clear();
  path_ = storePath_ = path;
  view_ = std::make_shared<const LabView>(std::move(*view));
  stored_ = view_->findings.plan;
  title_ = stored_.title;
  figures_ = standardFigures(stored_);
  livesDone_ = 0;
  for (const Evidence& e : view_->evidence) livesDone_ += static_cast<int>(e.lives.size()) + e.record.diverged;
  falls_ = fallsIn(*view_);
  share_ = livesPlanned() > 0 ? static_cast<double>(livesDone_) / livesPlanned() : 0;
  setState(view_->findings.complete ? State::Complete : State::Paused);
  Q_EMIT planChanged();
  Q_EMIT resultsChanged();
  Q_EMIT progressed();
  return Done{};
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
    Q_EMIT resultsChanged();
  }
}

void Experiment::tick() {
  if (!thread_) return;
  const bool over = thread_->over();
  take();
  if (!over) return;
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

std::vector<Judgement> Experiment::judgements() const {
  std::vector<Judgement> list;
  if (!view_ || !plan_) return list;
  for (const Claim& claim : claims_)
    if (auto judgement = judge(registry_, claim, view_->evidence, plan_->seed)) list.push_back(std::move(*judgement));
  return list;
}

bool Experiment::isInPercent(const std::string& id) const {
  for (const Claim& claim : claims_)
    if (claim.id == id)
      return claim.kind == "reduction" || claim.kind == "significant" || claim.kind == "no-difference" ||
             claim.kind == "extreme";
  return false;
}

std::optional<Figure> Experiment::figure(const FigureSpec& spec) const {
  if (!view_) return std::nullopt;
  auto figure = makeFigure(registry_, spec, view_->evidence, stored_.seed);
  if (figure) markThesis(*figure, spec.measure, claims_, view_->evidence);
  return figure ? std::optional<Figure>(std::move(*figure)) : std::nullopt;
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
  if (view_)
    for (const Evidence& e : view_->evidence)
      if (e.name() == condition) return static_cast<int>(e.lives.size()) + e.record.diverged;
  return 0;
}

}  // namespace surefoot
