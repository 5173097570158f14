// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/panel.h"

#include <QPainter>
#include <QScrollArea>
#include <cmath>

#include "ui/controls/header_button.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/help.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {

constexpr int kSide = 12, kHeader = 32, kBaseline = 21;  // [px], with texts of the usual size

}  // namespace

PanelHeader::PanelHeader(const QString& title, bool canFill, QWidget* parent)
    : Painted(parent),
      title_(title),
      close_(new HeaderButton(Icon::Close, Icon::Close, this)) {
  close_->setToolTip(tipText(tr("Close %1; the View menu brings it back").arg(title_)));
  close_->setAccessibleName(close_->toolTip());
  close_->hide();
  connect(close_, &QAbstractButton::clicked, this, &PanelHeader::closeAsked);
  if (!canFill) return;
  button_ = new HeaderButton(Icon::FullSize, Icon::NormalSize, this);
  setFull(false);
  connect(button_, &QAbstractButton::clicked, this, &PanelHeader::fullSizeAsked);
}

namespace {

/// The part of a note that has room: all of it, or its first parts, but never half a word.
QString wholeParts(const QString& note, const QFont& font, double room) {
  QString part = note;
  while (!part.isEmpty() && symbolWidth(font, part) > room) {
    const auto end = std::max({part.lastIndexOf(';'), part.lastIndexOf(':'), part.lastIndexOf(',')});
    part = part.left(std::max<qsizetype>(end, 0));
  }
  return part;
}

}  // namespace

int PanelHeader::usualHeight() {
  return kHeader;
}

double PanelHeader::titleEnd() const {
  return kSide + QFontMetricsF(textFont(13, 500)).horizontalAdvance(title_);
}

void PanelHeader::setTitle(const QString& title) {
  if (title == title_) return;
  title_ = title;
  update();
}

void PanelHeader::setNote(const QString& note) {
  if (note == note_) return;
  note_ = note;
  update();
}

void PanelHeader::setHelp(const QString& page) {
  if (!help_) help_ = new HelpButton(title_, this);
  setHelpPage(*this, page);
  if (extra_) orderTabs();
  resizeEvent(nullptr);
}

void PanelHeader::setFull(bool full) {
  if (!button_) return;
  button_->setChecked(full);
  button_->setToolTip(tipText(full ? tr("Back to all panels") : tr("Give %1 the whole window").arg(title_)));
  button_->setAccessibleName(button_->toolTip());
}

void PanelHeader::setFloating(bool floating) {
  floating_ = floating;
  close_->setVisible(floating);
  if (button_) button_->setVisible(!floating);
  resizeEvent(nullptr);
  update();
}

void PanelHeader::addWidget(QWidget* widget) {
  extra_ = widget;
  widget->setParent(this);
  orderTabs();
  resizeEvent(nullptr);
}

/// From left to right: the widget's controls, then the buttons.
void PanelHeader::orderTabs() {
  QWidgetList order;
  for (QWidget* next = extra_; next == extra_ || extra_->isAncestorOf(next); next = next->nextInFocusChain())
    if (next->focusPolicy() & Qt::TabFocus && next->window() == window()) order << next;
  for (QAbstractButton* button : {help_, button_, close_})
    if (button) order << button;
  QWidget* before = close_;  // it stands before the panel's content, and moves behind the others last
  for (QWidget* next : order) {
    setTabOrder(before, next);
    before = next;
  }
}

bool PanelHeader::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) resizeEvent(nullptr);  // of the widget, whose font may have changed
  return Painted::event(event);
}

void PanelHeader::resizeEvent(QResizeEvent*) {
  int right = width() - 6;
  constexpr int kButton = HeaderButton::kSide;
  for (QAbstractButton* button : {close_, button_, help_})
    if (button && !button->isHidden()) {
      place(*button, {right - kButton, (height() - kButton) / 2, kButton, kButton});
      right -= kButton;
    }
  right -= 4;
  if (!extra_) return;
  const int room = right - static_cast<int>(titleEnd()) - 8;
  if (auto* folding = dynamic_cast<Folding*>(extra_)) folding->fold(scaled(room));
  extra_->adjustSize();
  extra_->move(scaled(right) - extra_->width(), (QWidget::height() - extra_->height()) / 2);
  extra_->setVisible(extra_->width() <= scaled(room));  // a panel that is too narrow shows its title
}

void PanelHeader::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.fillRect(rect(), floating_ ? t.fill : paper_ ? t.paper : t.panel);
  p.setPen(t.ink);
  p.setFont(textFont(13, 500));
  const double baseline = kBaseline;
  p.drawText(QPointF(kSide, baseline), title_);
  const double x = titleEnd() + 8;
  double right = width() - kSide;
  for (const QAbstractButton* button : {close_, button_, help_})
    if (button && !button->isHidden()) right = placeOf(*button).x() - 4;
  if (extra_ && !extra_->isHidden()) right = placeOf(*extra_).x() - 8;
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  drawSymbol(p, x, baseline, wholeParts(note_, p.font(), right - x));
}

Panel::Panel(const QString& title, const QString& name, QWidget* content, bool canFill, QWidget* parent)
    : QDockWidget(title, parent),
      header_(new PanelHeader(title, canFill, this)) {
  setObjectName(name);
  setTitleBarWidget(header_);
  setAttribute(Qt::WA_StyledBackground);  // with a frame while it floats
  setWidget(content);
  content->setAccessibleName(title);
  setHelpPage(*this, QStringLiteral("panel-") + name);
  header_->setHelp(helpPageOf(this));
  connect(header_, &PanelHeader::closeAsked, this, &QWidget::close);
  connect(this, &QDockWidget::topLevelChanged, header_, &PanelHeader::setFloating);
}

QWidget* Panel::view() const {
  auto* area = qobject_cast<QScrollArea*>(widget());
  return area && area->widget() ? area->widget() : widget();
}

}  // namespace surefoot

#include "moc_panel.cpp"
