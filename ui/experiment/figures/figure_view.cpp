// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/figures/figure_view.h"

#include <QHelpEvent>
#include <QPaintEvent>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>

#include "ui/language/from_core.h"
#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

FigureView::FigureView(Figure figure, QWidget* parent)
    : Painted(parent),
      painter_(std::move(figure)),
      scroll_(new QScrollBar(Qt::Horizontal, this)) {
  setMouseTracking(true);
  setAccessibleName(shownName(fromCore(painter_.figure().title).toStdString()));
  scroll_->setAccessibleName(tr("Bars that have no room"));
  connect(scroll_, &QScrollBar::valueChanged, this, qOverload<>(&QWidget::update));
  layOut();
}

void FigureView::setFigure(Figure figure, const QString& words) {
  const bool same = figure.name == painter_.figure().name && painter_.isPart();
  const auto part = painter_.time();
  painter_ = FigurePainter(std::move(figure));
  painter_.setChosen(chosen_);
  painter_.setTitleShown(titleShown_);
  if (same) painter_.setTime(part);
  painter_.setReading(reading_);
  words_ = words;
  setAccessibleName(painter_.figure().title.empty() ? words
                                                    : shownName(fromCore(painter_.figure().title).toStdString()));
  layOut();
  update();
}

void FigureView::setChosen(const std::string& condition) {
  chosen_ = condition;
  painter_.setChosen(condition);
  update();
}

void FigureView::setTitleShown(bool shown) {
  titleShown_ = shown;
  painter_.setTitleShown(shown);
  layOut();
}

QSizeF FigureView::drawn() const {
  return QSizeF(width(), height() - (scroll_->isVisibleTo(this) ? placeOf(*scroll_).height() : 0));
}

void FigureView::layOut() {
  const int most = exporting_ ? 0 : static_cast<int>(painter_.mostScroll(size()));
  scroll_->setVisible(most > 0);
  scroll_->setRange(0, most);
  scroll_->setPageStep(std::max(1, width() / 2));
  scroll_->setSingleStep(40);
  const int high = scroll_->sizeHint().height();
  scroll_->setGeometry(0, QWidget::height() - high, QWidget::width(), high);
}

void FigureView::resizeEvent(QResizeEvent*) {
  layOut();
}

bool FigureView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && usesKey(static_cast<QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
  if (event->type() != QEvent::ToolTip || curves()) return QWidget::event(event);  // curves are read at the line
  const auto* help = static_cast<QHelpEvent*>(event);
  const QString text =
      words_.isEmpty() ? painter_.textAt(QPointF(help->pos()) / textSize(), drawn(), scroll_->value()) : QString();
  if (text.isEmpty())
    QToolTip::hideText();
  else
    QToolTip::showText(help->globalPos(), tipText(text), this);
  return true;
}

void FigureView::paintEvent(QPaintEvent*) {
  ScaledPainter p(this);
  const Theme& t = themeOf(*this);
  if (words_.isEmpty()) return painter_.paint(p, t, drawn(), exporting_ ? 0 : scroll_->value());
  p.fillRect(rect(), t.panel);
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  p.drawText(rect().adjusted(12, 0, -12, 0), Qt::AlignCenter | Qt::TextWordWrap, words_);
}

Status FigureView::save(const std::string& path) {
  return saveFigure(figure(), themeOf(*this), path);
}

std::string FigureView::asCsv() const {
  return figure().series.empty() && !figure().scene ? "" : figureAsCsv(figure());
}

void FigureView::prepareExport(bool exporting) {
  if (exporting == exporting_) return;
  exporting_ = exporting;
  painter_.setTitleShown(exporting || titleShown_);
  painter_.setReading(exporting ? std::nullopt : reading_);
  if (exporting) before_ = QWidget::size();
  resize(exporting ? scaled(painter_.fullSize().toSize()).expandedTo(QWidget::size()) : before_);
  layOut();
}

}  // namespace surefoot

#include "moc_figure_view.cpp"
