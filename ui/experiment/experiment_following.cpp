// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Experiment that looks at a store which another process writes.
#include <algorithm>

#include "core/files/read_file.h"
#include "core/plans/plan_time.h"
#include "core/store/store_lock.h"
#include "ui/experiment/experiment.h"
#include "ui/language/numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {

/// The same conditions and the same part of them; the number of lives may be another.
bool samePlan(const StoredPlan& a, const StoredPlan& b) {
  return checkSamePlan(a, b, "") && checkSameShard(a, b, "");
}

}  // namespace

void Experiment::follow(const std::string& path) {
  opening_.cancel();
  reset();
  Opened nothing{.text = {}, .path = path, .plan = {}, .stored = {}, .figures = {}, .claims = {}};
  takePlan(nothing);
  sinceFirstLife_.invalidate();
  const auto before = std::make_shared<Opened>();  // belongs to the thread that reads
  const auto read = [this, path, before](const std::atomic<bool>& interrupted) -> Result<Following::Take> {
    const auto store = Store::peek(path, &interrupted);
    if (!store) return store.error();
    auto opened = prepareStore(*store);
    if (!opened) return opened.error();
    if (!before->stored.conditions.empty() && samePlan(before->stored, opened->stored)) {
      opened->figures = before->figures;
      opened->claims = before->claims;
    } else {
      addRecipe(*opened, interrupted);
    }
    *before = *opened;
    const auto made = std::make_shared<Opened>(std::move(*opened));
    return Following::Take([this, made] { takeFollowed(std::move(*made)); });
  };
  following_ = std::make_unique<Following>(
      path, Following::Look{
                .beside = {"-wal", "-journal"}, .isWritten = [path] { return StoreLock::isHeld(path); }, .read = read});
  connect(following_.get(), &Following::looked, this, &Experiment::followed);
  setState(State::Following);
  Q_EMIT planChanged();
  Q_EMIT resultsChanged();
  Q_EMIT progressed();
}

/// Figures and claims of the recipe whose plan the store has, if it stands in the list.
void Experiment::addRecipe(Opened& opened, const std::atomic<bool>& interrupted) const {
  for (const PlanSource& source : sources_) {
    if (!source.recipe || source.title != opened.stored.title || interrupted) continue;
    const auto text = readText(source.path);
    if (!text) continue;
    auto recipe = prepareText(*text, source.path, interrupted);
    if (!recipe || !checkSamePlan(opened.stored, recipe->stored, opened.path)) continue;
    opened.figures = std::move(recipe->figures);
    opened.claims = std::move(recipe->claims);
    return;
  }
}

/// The store has grown, or there is another one in its place. While the plan is the same, so are the chosen figures,
/// the chosen row and where one has scrolled to.
void Experiment::takeFollowed(Opened opened) {
  const bool grown = view_ && samePlan(stored_, opened.stored) && opened.lives >= livesDone_;
  const bool news = grown && opened.lives > livesDone_;
  const std::string note = grown ? "" : opened.note;
  if (grown)
    stored_ = opened.stored;
  else
    takePlan(opened);
  takeView(opened);
  if (!grown) sinceFirstLife_.invalidate();
  if (news && !sinceFirstLife_.isValid()) {
    sinceFirstLife_.start();
    livesAtFirst_ = livesDone_;
  }
  if (!grown) Q_EMIT planChanged();
  results_.show(view_);
  Q_EMIT progressed();
  if (!note.empty()) Q_EMIT failed(toText(note));
}

void Experiment::stopFollowing() {
  if (!following_) return;
  Following::end(std::move(following_), this);
  if (!view_) path_.clear();
  setState(!view_ ? State::Ready : livesDone_ >= livesPlanned() ? State::Complete : State::Paused);
  Q_EMIT progressed();
}

QString Experiment::followingText() const {
  if (!following_) return {};
  if (const QString trouble = following_->trouble(); !trouble.isEmpty()) return trouble;
  if (!following_->isShown()) return tr("it is being read …");
  QStringList parts = {livesDone_ >= livesPlanned() ? tr("all lives are there")
                       : following_->isWritten()    ? tr("it is being written")
                                                    : tr("no process writes it now")};
  parts << (livesDone_ == 0 ? tr("no life is over yet")
                            : tr("%1 of %2").arg(countNumber(livesDone_), livesText(livesPlanned())));
  parts << tr("last change %1").arg(following_->lastChange());
  if (const auto rest = left()) parts << tr("about %1 left").arg(localNumbers(roundedTime(*rest / 60)));
  return parts.join(QStringLiteral(" · "));
}

}  // namespace surefoot
