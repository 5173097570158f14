// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Session that keeps lives which gave way to others, and brings them back.
#include <QFile>
#include <algorithm>

#include "ui/session/beginning.h"
#include "ui/session/session.h"

namespace surefoot {

namespace {
constexpr int kMostKept = 50;                       // lives
constexpr std::size_t kLeastMemory = 256u << 20;    // [bytes] that must be left
constexpr std::size_t kMostValuesThen = 16u << 20;  // [bytes] of values kept with falls
constexpr std::size_t kBeside = 8u << 20;           // [bytes] that curves and falls take, about
}  // namespace

std::optional<std::size_t> availableMemory() {
  QFile file(QStringLiteral("/proc/meminfo"));
  if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
  for (const QByteArray& line : file.readAll().split('\n')) {
    if (!line.startsWith("MemAvailable:")) continue;
    bool good = false;
    const qulonglong kilobytes = line.simplified().split(' ').value(1).toULongLong(&good);
    if (good) return kilobytes * 1024;
  }
  return std::nullopt;
}

/// Whether one of them is rather let go than another: what is saved, then that in which less was learned.
bool goesBefore(const KeptLife& one, const KeptLife& other) {
  if (one.unsaved() != other.unsaved()) return other.unsaved();
  return one.progress.steps < other.progress.steps;
}

/// Gives the life that runs way to another one, or to another one that was kept.
class AnotherLife final : public QUndoCommand {
 public:
  AnotherLife(Session& session, std::shared_ptr<KeptLife> kept)
      : QUndoCommand(Session::tr("the new life")),
        session_(session),
        kept_(std::move(kept)) {}
  void undo() override { exchange(false); }
  void redo() override {
    if (done_) exchange(true);
    done_ = true;  // the first time it was done already
  }
  const std::shared_ptr<KeptLife>& kept() const { return kept_; }

 private:
  void exchange(bool redo) {
    if (kept_->aside) {
      session_.exchange(kept_);
    } else {  // it had to make room
      setObsolete(true);
      session_.undoOnceMore(redo);
    }
  }

  Session& session_;
  std::shared_ptr<KeptLife> kept_;
  bool done_ = false;
};

void Session::adopt(std::unique_ptr<Life> life, std::shared_ptr<KeptLife> before) {
  const bool wasFinished = runFinished();
  const bool elsewhere = curvesIn_ != configuration_.names.environment;
  if (elsewhere) keepCurves(before);
  elsewhere ? curves_.forget() : curves_.archive();
  curvesIn_ = configuration_.names.environment;
  falls_.clear();
  numbers_ = {};
  valuesThen_.clear();
  file_ = {};
  progressKnown_ = {life->log().totals().episodes, life->steps()};
  bytesOfLife_ = life->agent().values().bytes();
  begun(ReplaceLife{.life = std::move(life), .back = {}, .before = before ? before->aside : nullptr});
  if (wasFinished) setRunning(true);
  if (before) keep(before);
}

/// Where another environment begins, the curves stay with the last life of this one that can be brought back.
void Session::keepCurves(std::shared_ptr<KeptLife> last) {
  for (auto other = kept_.rbegin(); !last && other != kept_.rend(); ++other)
    if (auto life = other->lock(); life && life->aside && life->curvesIn == curvesIn_) last = std::move(life);
  if (last) last->curves = curves_;
}

void Session::begun(ReplaceLife replacement) {
  hovered_.clear();
  pinned_.clear();
  fallsToCome_.clear();
  recording_.clear();
  backToLive();
  curves_.setBegan(beginningOf(began_));
  makeViewer();
  learner_->send(std::move(replacement));
  ++lifeSent_;
  // Until it has been heard of: the environment as it is set up.
  shown_ = {};
  shown_.state.assign(viewer_->environment().state().begin(), viewer_->environment().state().end());
  shown_.pose = viewer_->pose();
  shown_.q.assign(task().actions.size(), 0.0);
  Q_EMIT fallsArrived();
  Q_EMIT lifeReplaced();
}

Status Session::restart() {
  return beginAgain(configuration_);
}

Status Session::restartEmpty() {
  Configuration empty = configuration_;
  empty.start.reset();
  empty.beganWith = {};
  return beginAgain(std::move(empty));
}

QString Session::beginning() const {
  return QString::fromStdString(beginningOf(began_));
}

LifeProgress Session::progress() const {
  const Snapshot& s = snapshot();
  if (s.life != lifeSent_) return progressKnown_;
  return {s.totals.episodes, s.steps};
}

bool Session::learned() const {
  return progress().learnedSince({});
}

bool Session::unsaved() const {
  return progress().learnedSince(file_.saved);
}

void Session::setFile(LifeFile file) {
  file_ = std::move(file);
  Q_EMIT fileChanged();
}

/// Hashed tables grow while a life goes on.
std::size_t Session::bytesOfLife() const {
  const ValueSnapshot* newest = values();
  return std::max(bytesOfLife_, newest && newest->values ? newest->values->bytes() : 0);
}

bool Session::canKeep() const {
  const auto available = availableMemory();
  return bytesOfLife() <= mostKept_ && (!available || *available >= kLeastMemory);
}

/// What the window knows of the life that runs goes into it; the life itself follows when the thread comes to it.
std::shared_ptr<KeptLife> Session::putAside() {
  auto kept = std::make_shared<KeptLife>();
  kept->aside = std::make_shared<LifeAside>();
  kept->configuration = configuration_;
  kept->began = began_;
  kept->base = base_;
  kept->file = file_;
  kept->progress = progress();
  kept->lineage = lineage_;
  kept->curve = curves_.live().number;
  kept->curvesIn = curvesIn_;
  kept->falls = falls_;
  std::size_t values = 0;
  for (const auto& [number, then] : valuesThen_) values += then->bytes();
  if (values <= kMostValuesThen) kept->valuesThen = valuesThen_;
  kept->bytes = bytesOfLife();
  return kept;
}

/// A life in which nothing was learned yet is not missed.
std::shared_ptr<KeptLife> Session::putAsideIfLearned() {
  return learned() && keepsBefore_ ? putAside() : nullptr;
}

/// Of the lives that are kept the one to let go if so many lives and bytes come to them; nullptr: there is room.
std::shared_ptr<KeptLife> Session::withoutRoom(std::size_t more, int lives) const {
  std::size_t bytes = more;
  std::shared_ptr<KeptLife> least;
  for (const auto& other : kept_) {
    const auto life = other.lock();
    if (!life || !life->aside) continue;
    bytes += life->bytes + kBeside;
    ++lives;
    if (!least || goesBefore(*life, *least)) least = life;
  }
  return bytes > mostKept_ || lives > kMostKept ? least : nullptr;
}

void Session::keep(const std::shared_ptr<KeptLife>& kept) {
  std::erase_if(kept_, [](const auto& other) { return other.expired(); });
  while (const auto least = withoutRoom(kept->bytes + kBeside, 1)) letGo(*least);
  kept_.push_back(kept);
}

void Session::keepForUndo(std::shared_ptr<KeptLife> before) {
  if (!before) return;
  push(new AnotherLife(*this, std::move(before)));
  Q_EMIT lifeKept();
}

void Session::forgetChanges() {
  for (const auto& other : kept_)
    if (const auto life = other.lock(); life && life->aside) letGo(*life);
  undo_.clear();
}

/// Large tables are given back to the system on the learner's thread, so that the window does not wait for it.
void Session::letGo(KeptLife& kept) {
  learner_->send(Visit{[aside = std::exchange(kept.aside, nullptr)](const Life&) {}});
  kept.falls.clear();
  kept.valuesThen.clear();
  kept.curves.reset();
}

std::vector<std::shared_ptr<KeptLife>> Session::unsavedBefore() const {
  std::vector<std::shared_ptr<KeptLife>> list;
  for (const auto& other : kept_)
    if (auto life = other.lock(); life && life->unsaved()) list.push_back(std::move(life));
  return list;
}

/// A new command ends what could be made again; a life in it must not go with it, so undo goes by way of it.
void Session::push(QUndoCommand* command) {
  saveRedone();
  undo_.push(command);
}

void Session::beginMacro(const QString& text) {
  saveRedone();
  undo_.beginMacro(text);
}

void Session::saveRedone() {
  std::vector<std::shared_ptr<KeptLife>> lives;
  for (int i = undo_.index(); i < undo_.count(); ++i)
    if (const auto* another = dynamic_cast<const AnotherLife*>(undo_.command(i)); another && another->kept()->aside)
      lives.push_back(another->kept());
  for (auto& life : lives) undo_.push(new AnotherLife(*this, std::move(life)));
}

/// What was to be undone (or made again) is of no use any more; the next one is meant.
void Session::undoOnceMore(bool redo) {
  if (std::exchange(undoAgain_, true)) return;
  QMetaObject::invokeMethod(
      this,
      [this, redo] {
        undoAgain_ = false;
        redo ? undo_.redo() : undo_.undo();
      },
      Qt::QueuedConnection);
}

void Session::exchange(std::shared_ptr<KeptLife>& kept) {
  const std::shared_ptr<KeptLife> back = std::exchange(kept, putAside());
  const bool elsewhere = back->curvesIn != curvesIn_;
  if (elsewhere)
    kept->curves = std::move(curves_);
  else
    curves_.archive();
  began_ = std::move(back->began);
  configuration_ = std::move(back->configuration);
  base_ = std::move(back->base);
  lineage_ = back->lineage;
  curvesIn_ = back->curvesIn;
  if (elsewhere) curves_ = back->curves ? std::move(*back->curves) : RunCurves();
  curves_.bringBack(back->curve);
  falls_ = std::move(back->falls);
  valuesThen_ = std::move(back->valuesThen);
  numbers_ = {.episodes = back->progress.episodes,
              .falls = falls_.empty() ? 0 : falls_.back().number,
              .fallsByHand = 0,
              .steps = back->progress.steps};
  file_ = std::move(back->file);
  progressKnown_ = back->progress;
  bytesOfLife_ = back->bytes;
  begun(ReplaceLife{.life = {}, .back = std::exchange(back->aside, nullptr), .before = kept->aside});
  kept_.push_back(kept);  // both were there before
  Q_EMIT parametersReplaced();
  Q_EMIT configurationChanged();
  Q_EMIT lifeBroughtBack();
}

}  // namespace surefoot
