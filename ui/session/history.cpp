// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/history.h"

namespace surefoot {

namespace {

/// Replaces the life that runs by a kept one; undo and redo exchange the two.
class AnotherLife final : public QUndoCommand {
 public:
  AnotherLife(History& history, std::shared_ptr<KeptLife> kept)
      : QUndoCommand(History::tr("the new life")),
        history_(history),
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
      history_.exchange(kept_);
    } else {  // its life was dropped to free memory
      setObsolete(true);
      history_.undoOnceMore(redo);
    }
  }

  History& history_;
  std::shared_ptr<KeptLife> kept_;
  bool done_ = false;
};

/// Curves of earlier lives that were taken out of the charts.
class RemovedRuns final : public QUndoCommand {
 public:
  RemovedRuns(RunningLife& life, std::vector<int> numbers)
      : QUndoCommand(QObject::tr("Remove earlier runs")),
        life_(life),
        numbers_(std::move(numbers)) {}
  void undo() override {
    life_.curves().putBack(removed_);
    Q_EMIT life_.curvesChanged();
  }
  void redo() override {
    removed_ = life_.curves().remove(numbers_);
    Q_EMIT life_.curvesChanged();
  }

 private:
  RunningLife& life_;
  std::vector<int> numbers_;
  std::vector<RunCurve> removed_;
};

}  // namespace

void History::removeEarlierRuns(std::vector<int> numbers) {
  if (!numbers.empty()) push(new RemovedRuns(life_, std::move(numbers)));
}

/// A new command drops all commands that redo could repeat. Lives in them are moved within reach of undo first.
void History::push(QUndoCommand* command) {
  saveRedone();
  undo_.push(command);
}

void History::beginMacro(const QString& text) {
  saveRedone();
  undo_.beginMacro(text);
}

void History::saveRedone() {
  std::vector<std::shared_ptr<KeptLife>> lives;
  for (int i = undo_.index(); i < undo_.count(); ++i)
    if (const auto* another = dynamic_cast<const AnotherLife*>(undo_.command(i)); another && another->kept()->aside)
      lives.push_back(another->kept());
  for (auto& life : lives) undo_.push(new AnotherLife(*this, std::move(life)));
}

void History::undoOnceMore(bool redo) {
  if (std::exchange(undoAgain_, true)) return;
  QMetaObject::invokeMethod(
      this,
      [this, redo] {
        undoAgain_ = false;
        redo ? undo_.redo() : undo_.undo();
      },
      Qt::QueuedConnection);
}

void History::replace(KnownLife next, std::unique_ptr<Life> life, As as) {
  auto before = life_.learned() && keepsBefore_ ? putAside() : nullptr;  // a life that learned nothing is not kept
  next.lineage = before || as == As::Another ? ++lineages_ : life_.lineage();
  if (as == As::Another && !before && unsavedBefore().empty()) forgetChanges();
  next.progress = {life->log().totals().episodes, life->steps()};
  next.bytes = life->agent().values().bytes();
  const bool elsewhere = next.configuration.names.environment != life_.configuration().names.environment;
  const bool wasFinished = life_.finished();
  if (elsewhere) {
    moveCurves(before);
    life_.curves().forget();
  } else {
    life_.curves().archive();
  }
  looking_.setSeen({});
  if (before) keep(before);
  life_.replace(std::move(next), {.life = std::move(life), .back = {}, .before = before ? before->aside : nullptr});
  if (wasFinished) life_.setRunning(true);
  if (!before) return;
  push(new AnotherLife(*this, std::move(before)));
  Q_EMIT lifeKept();
}

void History::renew(KnownLife next, std::unique_ptr<Life> life) {
  next.lineage = life_.lineage();
  next.progress = {life->log().totals().episodes, life->steps()};
  next.falls = life->log().totals().falls;
  next.bytes = life->agent().values().bytes();
  looking_.setSeen({});
  life_.curves().setSeenBefore(life_.curves().live().points);  // a file without a log has only the newest point
  life_.replace(std::move(next), {.life = std::move(life), .back = {}, .before = nullptr});
}

void History::exchange(std::shared_ptr<KeptLife>& kept) {
  const std::shared_ptr<KeptLife> back = std::exchange(kept, putAside());
  const bool elsewhere = back->known.configuration.names.environment != kept->known.configuration.names.environment;
  if (elsewhere) {
    kept->curves = std::move(life_.curves());
    life_.curves() = back->curves ? std::move(*back->curves) : RunCurves();
  } else {
    life_.curves().archive();
  }
  life_.curves().bringBack(back->curve);
  looking_.setSeen(std::move(back->seen));
  kept_.push_back(kept);  // both were there before
  life_.replace(std::move(back->known),
                {.life = {}, .back = std::exchange(back->aside, nullptr), .before = kept->aside});
  Q_EMIT lifeBroughtBack();
}

}  // namespace surefoot

#include "moc_history.cpp"
