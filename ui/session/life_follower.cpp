// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/life_follower.h"

#include <new>
#include <tuple>

#include "core/saved/q_file.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {

Result<NewLives::Made> readLife(const Registry& registry, const std::string& path) {
  try {
    const auto file = readQFile(path);
    if (!file) return file.error();
    if (const Status s = checkKind(**file, {"checkpoint"}); !s) return s.error();
    auto made = lifeOf(registry, *file);
    if (made) made->file->followed = true;
    return made;
  } catch (const std::bad_alloc&) {
    return fileError(path, QObject::tr("there is not enough memory for what it holds.").toStdString());
  }
}

/// The same life, lived further or less far; else another one was begun in this file.
bool isSame(const Configuration& a, const Configuration& b) {
  const auto all = [](const Configuration& c) {
    return std::tie(c.names.environment, c.names.preset, c.names.agent, c.names.features, c.names.policy, c.seed);
  };
  return all(a) == all(b);
}

}  // namespace

LifeFollower::LifeFollower(Session& session, QObject* parent) : QObject(parent), session_(session) {
  connect(&session_.life(), &RunningLife::replaced, this, &LifeFollower::lifeReplaced);
  for (auto signal : {&RunningLife::stateChanged, &RunningLife::valuesArrived})
    connect(&session_.life(), signal, this, &LifeFollower::watch);
  const auto becomesOwn = [this] {
    if (shown_ > 0 && !renewing_) stop();
  };
  connect(&session_.life(), &RunningLife::parameterChanged, this, becomesOwn);
  connect(&session_.life(), &RunningLife::policyChanged, this, becomesOwn);
}

void LifeFollower::follow(const std::string& path) {
  stop();
  const auto read = [this, path,
                     &registry = session_.life().registry()](const std::atomic<bool>&) -> Result<Following::Take> {
    auto life = readLife(registry, path);
    if (!life) return life.error();
    const auto made = std::make_shared<NewLives::Made>(std::move(*life));
    return Following::Take([this, made] { take(std::move(*made)); });
  };
  following_ = std::make_unique<Following>(path, Following::Look{.beside = {}, .isWritten = {}, .read = read});
  connect(following_.get(), &Following::looked, this, &LifeFollower::changed);
  Q_EMIT changed();
}

void LifeFollower::stop() {
  if (!following_) return;
  const QString name = following_->name();
  Following::end(std::move(following_), this);
  beginning_ = missed_ = false;
  session_.looking().setDemonstrating(false);
  const LifeFile file = session_.life().file();
  if (std::exchange(shown_, 0) > 0 && file.followed) {
    session_.life().setFile({{}, file.saved});
    Q_EMIT becameOnesOwn(name);
  }
  Q_EMIT changed();
}

void LifeFollower::goOn() {
  if (shown_ > 0) session_.life().setRunning(true);  // watch() does the rest
}

void LifeFollower::take(NewLives::Made made) {
  missed_ = beginning_;
  if (beginning_) return;
  shown_ > 0 && isSame(made.configuration, session_.life().began()) ? renew(std::move(made)) : begin(std::move(made));
}

void LifeFollower::begin(NewLives::Made made) {
  beginning_ = true;
  shown_ = 0;
  const std::int64_t steps = made.life->steps();
  const auto first = std::make_shared<NewLives::Made>(std::move(made));
  const auto make = [first](const std::atomic<bool>&) -> Result<NewLives::Made> { return std::move(*first); };
  const auto begun = [this, steps](const Status& s) {
    if (!std::exchange(beginning_, false) || !s) return;
    if (std::exchange(missed_, false)) following_->again();
    session_.life().setRunning(false);
    session_.looking().setDemonstrating(true);
    shown_ = session_.life().number();
    steps_ = steps;
    Q_EMIT changed();
  };
  static_cast<void>(static_cast<bool>(session_.newLives().beginWhenMade(make, begun)));
}

/// The same life, later: maps, charts and the state that is fixed on the maps stay as they were chosen.
void LifeFollower::renew(NewLives::Made made) {
  const std::vector<double> pinned = session_.looking().pinnedState();
  renewing_ = true;
  steps_ = made.life->steps();
  KnownLife next = session_.newLives().known(made);
  session_.history().renew(std::move(next), std::move(made.life));
  shown_ = session_.life().number();
  renewing_ = false;
  if (pinned.size() == session_.life().task().state.size()) session_.looking().pin(pinned);
}

/// Another life: one that was begun, or that undo brought back.
void LifeFollower::lifeReplaced() {
  const LifeFile file = session_.life().file();
  if (renewing_ || (beginning_ && file.followed)) return;
  if (file.followed) session_.life().setFile({{}, file.saved});  // it was followed once
  if (shown_ > 0 || beginning_) stop();
}

/// The life goes on here.
void LifeFollower::watch() {
  const RunningLife& life = session_.life();
  if (shown_ == 0 || renewing_ || life.number() != shown_) return;
  if (life.running() || (life.isShown() && life.snapshot().steps != steps_)) stop();
}

QString LifeFollower::text() const {
  if (!following_) return {};
  if (const QString trouble = following_->trouble(); !trouble.isEmpty()) return trouble;
  if (shown_ == 0) return tr("it is being read …");
  const RunningLife& life = session_.life();
  const bool over = life.isShown() && life.snapshot().finished;
  return QStringList{
      over ? tr("the life is complete")
           : tr("as of %1, %2").arg(following_->lastChange(), episodesText(life.progress().episodes)),
      session_.looking().hasViewer() ? tr("the body acts with its values, and learns nothing") : tr("it stands still")}
      .join(QStringLiteral(" · "));
}

}  // namespace surefoot

#include "moc_life_follower.cpp"
