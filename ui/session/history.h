// SPDX-License-Identifier: GPL-3.0-or-later
// What undo brings back: changes, and lives that gave way to others. A life that has learned anything is kept when a
// new one begins: undo brings it back as it was, and redo the new one. Where there is no memory for this, the window
// is asked before.
#pragma once

#include <QObject>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <vector>

#include "ui/session/kept_life.h"
#include "ui/session/looking.h"
#include "ui/session/running_life.h"

namespace surefoot {

/// Memory that can still be had on this machine [bytes]; nothing where it does not tell.
std::optional<std::size_t> availableMemory();

class History final : public QObject {
  Q_OBJECT

 public:
  History(RunningLife& life, Looking& looking) : life_(life), looking_(looking) {}

  QUndoStack& undo() { return undo_; }
  /// Use this instead of undo().push(): a life that could be brought back by redo stays within reach of undo.
  void push(QUndoCommand* command);
  /// … and these instead of its own for what is undone in one go.
  void beginMacro(const QString& text);
  void endMacro() { undo_.endMacro(); }
  /// Curves of earlier lives are taken out of the charts, by their numbers; undo brings them back.
  void removeEarlierRuns(std::vector<int> numbers);
  /// What was to be undone (or made again) is of no use any more: the next one is, soon.
  void undoOnceMore(bool redo);

  /// Called before a life ends for good that was not saved; it ends when `goOn` is called. Not set: it ends. `kept`:
  /// one that is kept for undo, of which the memory is needed; nullptr: the one that runs.
  using GoOn = std::function<void()>;
  using Ask = std::function<void(const std::shared_ptr<KeptLife>& kept, const GoOn& goOn)>;
  void setAskBeforeEnding(Ask ask) { askBeforeEnding_ = std::move(ask); }
  const Ask& askBeforeEnding() const { return askBeforeEnding_; }
  /// Memory for lives that undo can bring back [bytes].
  void setMostKept(std::size_t bytes) { mostKept_ = bytes; }

  /// Calls `end`, which is about to replace the life that runs; asks first where something would be lost.
  void endOrAsk(std::function<void()> end);
  enum class As { SameAgain, Another };
  /// A new life takes the place of the one that runs. SameAgain: where nothing was learned yet, changes that were made
  /// to the one before can still be undone.
  void replace(KnownLife next, std::unique_ptr<Life> life, As as);

  /// Lives within reach of undo and redo of which something is not saved.
  std::vector<std::shared_ptr<KeptLife>> unsavedBefore() const;
  /// The life that gave way last, if it is kept.
  std::shared_ptr<KeptLife> lastKept() const { return kept_.empty() ? nullptr : kept_.back().lock(); }
  /// Exchanges the life that runs and one that is kept.
  void exchange(std::shared_ptr<KeptLife>& kept);

 Q_SIGNALS:
  void lifeKept();         ///< the life before is within reach of undo
  void lifeBroughtBack();  ///< … and was brought back by undo or redo

 private:
  bool canKeep() const;
  std::shared_ptr<KeptLife> withoutRoom(std::size_t more) const;
  std::shared_ptr<KeptLife> putAside() const;
  void keep(const std::shared_ptr<KeptLife>& kept);
  void moveCurves(std::shared_ptr<KeptLife> last);
  void letGo(KeptLife& kept);
  void forgetChanges();
  void saveRedone();

  RunningLife& life_;
  Looking& looking_;
  QUndoStack undo_;
  std::vector<std::weak_ptr<KeptLife>> kept_;
  std::uint64_t lineages_ = 1;
  std::size_t mostKept_ = 600u << 20;
  Ask askBeforeEnding_;
  bool undoAgain_ = false, keepsBefore_ = true;
};

}  // namespace surefoot
