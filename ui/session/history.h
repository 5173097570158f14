// SPDX-License-Identifier: GPL-3.0-or-later
// Undo and redo of changes, and of lives that were replaced. A life that has learned anything is kept when a new one
// begins: undo brings it back unchanged, and redo brings back the new one. If there is no memory for this, the window
// is asked before.
#pragma once

#include <QObject>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <vector>

#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/session/kept_life.h"

namespace surefoot {

/// Free memory of this machine [bytes]; nothing if the system does not tell it.
std::optional<std::size_t> availableMemory();

class History final : public QObject {
  Q_OBJECT

 public:
  History(RunningLife& life, Looking& looking) : life_(life), looking_(looking) {}

  QUndoStack& undo() { return undo_; }
  /// Use this instead of undo().push(): a life that could be brought back by redo stays within reach of undo.
  void push(QUndoCommand* command);
  /// Use these instead of undo()'s own, for several commands that are undone in one step.
  void beginMacro(const QString& text);
  void endMacro() { undo_.endMacro(); }
  /// Curves of earlier lives are taken out of the charts, by their numbers; undo brings them back.
  void removeEarlierRuns(std::vector<int> numbers);
  /// The command that was undone (or redone) is void: soon the next one is undone (or redone).
  void undoOnceMore(bool redo);

  /// Called before an unsaved life ends for good; it ends when `goOn` is called, or at once if nothing is set here.
  /// `kept`: a life that is kept for undo and whose memory is needed; nullptr: the life that runs.
  using GoOn = std::function<void()>;
  using Ask = std::function<void(const std::shared_ptr<KeptLife>& kept, const GoOn& goOn)>;
  void setAskBeforeEnding(Ask ask) { askBeforeEnding_ = std::move(ask); }
  const Ask& askBeforeEnding() const { return askBeforeEnding_; }
  /// Memory for lives that undo can bring back [bytes].
  void setMostKept(std::size_t bytes) { mostKept_ = bytes; }

  /// Calls `end`, which replaces the life that runs; asks first if something would be lost.
  void endOrAsk(std::function<void()> end);
  enum class As { SameAgain, Another };
  /// A new life replaces the one that runs. SameAgain: if the old life had learned nothing, its changes can still be
  /// undone.
  void replace(KnownLife next, std::unique_ptr<Life> life, As as);
  /// The life that runs, at a later moment (or an earlier one): nothing is kept, and it stays the same life.
  void renew(KnownLife next, std::unique_ptr<Life> life);

  /// Lives that undo or redo can bring back and that are not saved.
  std::vector<std::shared_ptr<KeptLife>> unsavedBefore() const;
  /// The life that was replaced last, if it is kept.
  std::shared_ptr<KeptLife> lastKept() const { return kept_.empty() ? nullptr : kept_.back().lock(); }
  /// Exchanges the life that runs and one that is kept.
  void exchange(std::shared_ptr<KeptLife>& kept);

 Q_SIGNALS:
  void lifeKept();         ///< the life before is within reach of undo
  void lifeBroughtBack();  ///< undo or redo has brought a life back

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
