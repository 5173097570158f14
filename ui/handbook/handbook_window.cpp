// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/handbook/handbook_window.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QScreen>
#include <QShortcut>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <functional>

#include "ui/controls/hairline.h"
#include "ui/controls/link_button.h"
#include "ui/handbook/handbook_browser.h"
#include "ui/handbook/handbook_contents.h"
#include "ui/style/scale.h"
#include "ui/support/plain_text.h"

namespace surefoot {

HandbookWindow::HandbookWindow(Handbook handbook, const QString& pictures, QWidget* parent)
    : QWidget(parent, Qt::Window),
      handbook_(std::move(handbook)),
      contents_(new HandbookContents(handbook_)),
      browser_(new HandbookBrowser(handbook_, pictures)) {
  setWindowTitle(tr("Handbook"));
  auto* right = new QWidget;
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeBar());
  column->addWidget(new Hairline(Qt::Horizontal));
  column->addWidget(browser_, 1);
  column->addWidget(makeFind());
  auto* parts = new QSplitter;
  parts->setHandleWidth(1);
  parts->setChildrenCollapsible(false);
  parts->addWidget(contents_);
  parts->addWidget(right);
  parts->setStretchFactor(1, 1);
  auto* row = new QVBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(parts);
  whenScaled(this, [this, parts] {
    const QSize room = screen()->availableGeometry().size() * 0.9;
    resize(scaled({960, 680}).boundedTo(room));
    parts->setSizes({scaled(220), width() - scaled(220)});
  });
  connect(contents_, &HandbookContents::chosen, browser_, &HandbookBrowser::open);
  connect(contents_, &HandbookContents::searched, browser_, &HandbookBrowser::mark);
  connect(contents_, &HandbookContents::left, browser_, [this] { browser_->setFocus(Qt::OtherFocusReason); });
  connect(browser_, &QTextBrowser::sourceChanged, this, [this] { contents_->choose(browser_->page()); });
  addKeys();
}

void HandbookWindow::open(const QString& page) {
  if (page != browser_->page()) browser_->open(page);
  show();
  raise();
  activateWindow();
  browser_->setFocus(Qt::OtherFocusReason);
}

QWidget* HandbookWindow::makeBar() {
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  const auto button = [&](const QString& text, const QString& tip, auto slot, auto available) {
    auto* made = new LinkButton(text);
    made->setToolTip(tip);
    made->setEnabled(false);
    connect(made, &QToolButton::clicked, browser_, slot);
    connect(browser_, available, made, &QWidget::setEnabled);
    row->addWidget(made);
  };
  button(tr("‹ Back"), tr("The page before (Alt+←)"), &QTextBrowser::backward, &QTextBrowser::backwardAvailable);
  button(tr("Forward ›"), tr("The page after (Alt+→)"), &QTextBrowser::forward, &QTextBrowser::forwardAvailable);
  row->addStretch(1);
  auto* found = new LinkButton(tr("Find"));
  found->setToolTip(tr("A word on this page (Ctrl+F)"));
  connect(found, &QToolButton::clicked, this, [this] { showFind(true); });
  row->addWidget(found);
  whenScaled(bar, [row] {
    row->setContentsMargins(scaled({16, 6, 12, 6}));
    row->setSpacing(scaled(8));
  });
  return bar;
}

QWidget* HandbookWindow::makeFind() {
  find_ = new QLineEdit;
  find_->setPlaceholderText(tr("Find; Return: the next one, Escape: done"));
  find_->setAccessibleName(tr("Find on this page"));
  find_->hide();
  connect(find_, &QLineEdit::textEdited, this, [this] {
    browser_->moveCursor(QTextCursor::Start);
    find(false);
  });
  connect(find_, &QLineEdit::returnPressed, this, [this] { find(false); });
  whenScaled(find_, [this] { find_->setFont(scaledFont(13)); });
  return find_;
}

void HandbookWindow::showFind(bool shown) {
  find_->setVisible(shown);
  shown ? find_->setFocus(Qt::ShortcutFocusReason) : browser_->setFocus(Qt::OtherFocusReason);
  if (shown) find_->selectAll();
}

void HandbookWindow::find(bool backward) {
  const bool there = find_->text().isEmpty() || browser_->findNext(find_->text(), backward);
  find_->setToolTip(there ? QString() : tipText(tr("It does not stand on this page.")));
  find_->setAccessibleDescription(find_->toolTip());
  find_->setForegroundRole(there ? QPalette::Text : QPalette::PlaceholderText);
}

void HandbookWindow::addKeys() {
  const auto key = [this](const QKeySequence& keys, const std::function<void()>& what) {
    connect(new QShortcut(keys, this), &QShortcut::activated, this, what);
  };
  key(Qt::ALT | Qt::Key_Left, [this] { browser_->backward(); });
  key(Qt::ALT | Qt::Key_Right, [this] { browser_->forward(); });
  key(Qt::CTRL | Qt::Key_L, [this] { contents_->startSearch(); });
  key(QKeySequence::Find, [this] { showFind(true); });
  key(Qt::SHIFT | Qt::Key_Return, [this] { find(true); });
  key(Qt::CTRL | Qt::Key_W, [this] { close(); });
  key(Qt::Key_Escape, [this] { find_->isVisible() ? showFind(false) : static_cast<void>(close()); });
  key(Qt::CTRL | Qt::Key_Plus, [this] { Q_EMIT textSizeAsked(+1); });
  key(Qt::CTRL | Qt::Key_Equal, [this] { Q_EMIT textSizeAsked(+1); });
  key(Qt::CTRL | Qt::Key_Minus, [this] { Q_EMIT textSizeAsked(-1); });
  key(Qt::CTRL | Qt::Key_0, [this] { Q_EMIT textSizeAsked(0); });
}

}  // namespace surefoot

#include "moc_handbook_window.cpp"
