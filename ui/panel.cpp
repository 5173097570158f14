// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panel.h"

#include <QAbstractButton>
#include <QPainter>

#include "ui/icons.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

namespace {

constexpr int kPadding = 12, kHeight = 32, kBaseline = 21, kButton = 24;

class FullSizeButton final : public QAbstractButton {
 public:
  explicit FullSizeButton(QWidget* parent) : QAbstractButton(parent) {
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    resize(kButton, kButton);
    setCursor(Qt::PointingHandCursor);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Theme& t = themeOf(*this);
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    if (underMouse()) {
      p.setPen(Qt::NoPen);
      p.setBrush(t.fill);
      p.drawRoundedRect(rect(), 4, 4);
    }
    if (hasFocus()) {
      p.setPen(QPen(t.accent, 2));
      p.setBrush(Qt::NoBrush);
      p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    }
    drawIcon(p, isChecked() ? Icon::NormalSize : Icon::FullSize, rect(), underMouse() ? t.ink : t.quiet);
  }
};

}  // namespace

PanelHeader::PanelHeader(const QString& title, bool canFill, QWidget* parent) : QWidget(parent), title_(title) {
  if (!canFill) return;
  button_ = new FullSizeButton(this);
  setFull(false);
  connect(button_, &QAbstractButton::clicked, this, &PanelHeader::fullSizeAsked);
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

void PanelHeader::setFull(bool full) {
  if (!button_) return;
  button_->setChecked(full);
  button_->setToolTip(full ? tr("Back to all panels") : tr("Give %1 the whole window").arg(title_));
  button_->setAccessibleName(button_->toolTip());
}

void PanelHeader::addWidget(QWidget* widget) {
  extra_ = widget;
  widget->setParent(this);
  resizeEvent(nullptr);
}

void PanelHeader::resizeEvent(QResizeEvent*) {
  int right = width() - 6;
  if (button_) {
    button_->move(right - kButton, (kHeight - kButton) / 2);
    right -= kButton + 4;
  }
  if (extra_) {
    extra_->adjustSize();
    extra_->move(right - extra_->width(), (kHeight - extra_->height()) / 2);
    const double title = kPadding + QFontMetricsF(textFont(13, 500)).horizontalAdvance(title_);
    extra_->setVisible(extra_->x() > title + 8);  // a panel that is too narrow shows its title
  }
}

void PanelHeader::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  p.fillRect(rect(), paper_ ? t.paper : t.panel);
  p.setPen(t.ink);
  p.setFont(textFont(13, 500));
  p.drawText(QPointF(kPadding, kBaseline), title_);
  const double x = kPadding + QFontMetricsF(p.font()).horizontalAdvance(title_) + 8;
  const double right = extra_ ? extra_->x() - 8 : button_ ? button_->x() - 4 : width() - kPadding;
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  if (symbolWidth(p.font(), note_) <= right - x) drawSymbol(p, x, kBaseline, note_);
}

Panel::Panel(const QString& title, const QString& name, QWidget* content, bool canFill, QWidget* parent)
    : QDockWidget(title, parent),
      header_(new PanelHeader(title, canFill, this)) {
  setObjectName(name);
  setTitleBarWidget(header_);
  setWidget(content);
  content->setAccessibleName(title);
}

}  // namespace surefoot
