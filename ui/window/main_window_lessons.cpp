// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window about lessons: the page, and the way from a lesson to the Live page and back.
#include "ui/controls/message_bar.h"
#include "ui/lessons/lessons_page.h"
#include "ui/session/session.h"
#include "ui/style/symbol_text.h"
#include "ui/window/main_window.h"

namespace surefoot {

void MainWindow::makeLessons(const WindowSetup& setup) {
  lessons_ = new LessonsPage(session_.life().registry(), setup.lessons, setup.folder + QStringLiteral("/lessons"));
  pages_->addWidget(lessons_);
  connect(lessons_, &QStackedWidget::currentChanged, this, [this] {
    if (pages_->currentWidget() == lessons_) placeMessages();
  });
  connect(lessons_, &LessonsPage::refused, this, [this](const QString& sentence) { messages_->say(sentence); });
  connect(lessons_, &LessonsPage::told, this, [this](const QString& sentence) { messages_->tell(sentence); });
  connect(lessons_, &LessonsPage::beginAgainAsked, this,
          [this](const QString& sentence, const std::function<void()>& go) {
            messages_->ask(sentence, {{tr("Begin again"), go}});
          });
  connect(lessons_, &LessonsPage::statusChanged, this, [this](const QString& left, const QString& right) {
    lessonsLeft_ = left;
    lessonsRight_ = right;
    refreshStatus();
  });
  // The life of the Live page is kept for undo, as whenever another one begins.
  lessons_->setExplore([this](Configuration began, std::unique_ptr<Life> life) {
    auto made = std::make_shared<NewLives::Made>(NewLives::Made{std::move(began), std::move(life)});
    const auto make = [made](const std::atomic<bool>&) -> Result<NewLives::Made> { return std::move(*made); };
    const Status begun = session_.newLives().beginWhenMade(make, [this](const Status& s) {
      if (!s) return messages_->say(toText(s.error().message));
      setPage(0);
      messages_->tell(tr("This is the lesson's robot as it is now. The lesson waits on its page, where you were."));
    });
    static_cast<void>(static_cast<bool>(begun));  // it was told above
  });
}

}  // namespace surefoot
