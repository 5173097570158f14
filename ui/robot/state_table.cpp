// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robot/state_table.h"

#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "core/text/number_text.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {

constexpr double kHistogram = 68;

/// Three digits, as a person reads them.
QString numberText(double value) {
  const double size = std::abs(value);
  return fixedNumber(value, size >= 100 ? 0 : size >= 10 ? 1 : 2);
}

}  // namespace

StateTable::StateTable(QWidget* parent) : Painted(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("State"));
}

QSize StateTable::sizeHint() const {
  const int states = inspection_ ? static_cast<int>(inspection_->states.size()) : 6;
  const int endings = inspection_ ? static_cast<int>(inspection_->endings.size()) : 2;
  return scaled(QSize(424, static_cast<int>(top(states)) + 76 + 24 * endings));
}

void StateTable::setInspection(const EnvironmentInspection* inspection) {
  inspection_ = inspection;
  if (!inspection_ || chosen_ >= static_cast<int>(inspection_->states.size())) chosen_ = -1;
  updateGeometry();
  update();
}

void StateTable::paintEvent(QPaintEvent*) {
  ScaledPainter p(this);
  const Theme& t = themeOf(*this);
  p.fillRect(rect(), t.panel);
  if (!inspection_) return;
  p.setRenderHint(QPainter::Antialiasing);
  p.setFont(textFont(11, 500));
  p.setPen(t.ink);
  const double right = width() - 12;
  p.drawText(QRectF(12, 4, 120, 20), Qt::AlignLeft | Qt::AlignVCenter, tr("Variable"));
  const double often = histogramAt();
  p.drawText(QRectF(often - 120, 4, 110, 20), Qt::AlignRight | Qt::AlignVCenter, tr("observed"));
  p.drawText(QRectF(often, 4, kHistogram, 20), Qt::AlignLeft | Qt::AlignVCenter, tr("how often"));
  if (hasTiles()) p.drawText(QRectF(right - 68, 4, 68, 20), Qt::AlignRight | Qt::AlignVCenter, tr("tile"));
  p.setPen(QPen(t.hairline, 1));
  p.drawLine(QPointF(12, 28), QPointF(right, 28));
  for (int row = 0; row < static_cast<int>(inspection_->states.size()); ++row)
    drawRow(p, inspection_->states[static_cast<std::size_t>(row)], top(row), row == chosen_);
  drawEndings(p, top(static_cast<int>(inspection_->states.size())) + 8);
}

void StateTable::drawRow(QPainter& p, const SeenState& state, double y, bool chosen) const {
  const Theme& t = themeOf(*this);
  const double right = width() - 12;
  if (chosen) p.fillRect(QRectF(4, y, width() - 8, 28), t.fill);
  p.setFont(textFont(13));
  p.setPen(t.ink);
  const QString symbol = state.symbol == state.title ? QString() : toText(state.symbol);
  const double own = symbol.isEmpty() ? 0 : symbolWidth(p.font(), symbol) + 8;
  const double room = std::max(0.0, histogramAt() - 132 - own);
  const QString title = QFontMetricsF(p.font()).elidedText(toText(state.title), Qt::ElideRight, room);
  p.drawText(QRectF(12, y, room, 28), Qt::AlignLeft | Qt::AlignVCenter, title);
  p.setPen(t.quiet);
  drawSymbol(p, QRectF(20 + QFontMetricsF(p.font()).horizontalAdvance(title), y, own, 28), Qt::AlignLeft, symbol);
  // What does not hold what was seen is in caution, and underlined as what can be clicked: that writes what is
  // proposed.
  p.setPen(state.proposes() ? t.caution : t.ink);
  QFont numbers = textFont(13);
  numbers.setUnderline(state.proposes());
  p.setFont(numbers);
  const QString seen = tr("%1 … %2").arg(numberText(state.seenLow), numberText(state.seenHigh));
  p.drawText(QRectF(histogramAt() - 120, y, 110, 28), Qt::AlignRight | Qt::AlignVCenter,
             hasTiles() ? seen + QStringLiteral(" ") + toText(state.unit) : seen);
  p.setFont(textFont(13));
  drawHistogram(p, state, QRectF(histogramAt(), y + 5, kHistogram, 18));
  if (!hasTiles()) return;
  p.setPen(t.ink);
  p.drawText(QRectF(right - 68, y, 68, 28), Qt::AlignRight | Qt::AlignVCenter,
             numberText(state.width) + QStringLiteral(" ") + toText(state.unit));
}

void StateTable::drawHistogram(QPainter& p, const SeenState& state, const QRectF& where) const {
  const Theme& t = themeOf(*this);
  const int most = *std::max_element(state.bins.begin(), state.bins.end());
  const double step = where.width() / SeenState::kBins;
  p.fillRect(QRectF(where.left() + where.width() / 6, where.bottom() - 1, where.width() * 2 / 3, 1), t.quiet);
  for (std::size_t i = 0; i < SeenState::kBins && most > 0; ++i) {
    if (state.bins[i] == 0) continue;
    const double height = std::max(1.0, where.height() * std::sqrt(state.bins[i] / static_cast<double>(most)));
    const bool outside = i < SeenState::kBins / 6 || i >= SeenState::kBins - SeenState::kBins / 6;
    p.fillRect(QRectF(where.left() + static_cast<double>(i) * step, where.bottom() - height, step - 0.4, height),
               outside ? t.caution : t.quiet);
  }
}

void StateTable::drawEndings(QPainter& p, double y) const {
  const Theme& t = themeOf(*this);
  const double right = width() - 12;
  const auto head = [&](const QString& text, const QString& rest) {
    p.setPen(QPen(t.hairline, 1));
    p.drawLine(QPointF(12, y), QPointF(right, y));
    p.setPen(t.quiet);
    p.setFont(textFont(11, 500));
    p.drawText(QRectF(12, y + 4, 90, 24), Qt::AlignLeft | Qt::AlignVCenter, text);
    p.setFont(textFont(13));
    p.setPen(t.ink);
    p.drawText(QRectF(104, y + 4, right - 104, 24), Qt::AlignRight | Qt::AlignVCenter,
               QFontMetricsF(p.font()).elidedText(rest, Qt::ElideRight, right - 104));
    y += 32;
  };
  QString actions = fromCore(inspection_->actions);  // without their names where there is no room
  if (QFontMetricsF(textFont(13)).horizontalAdvance(actions) > right - 104)
    actions = actions.section(QStringLiteral(": "), -1);
  head(tr("ACTIONS"), actions);
  head(tr("ENDINGS"), tr("%1 steps, %2 s at most")
                          .arg(countNumber(inspection_->stepLimit))
                          .arg(fixedNumber(inspection_->stepLimit * inspection_->stepTime, 0)));
  for (const SeenEnding& ending : inspection_->endings) {
    p.setPen(QPen(ending.fall ? t.fall : t.quiet, 1.5));
    p.setBrush(ending.fall ? QBrush(t.fall) : QBrush(Qt::NoBrush));
    p.drawEllipse(QPointF(18, y + 12), 4, 4);
    p.setPen(t.ink);
    p.drawText(QRectF(32, y, 90, 24), Qt::AlignLeft | Qt::AlignVCenter,
               fromCore(ending.name) + (ending.count > 0 ? tr("  ×%1").arg(ending.count) : QString()));
    p.setPen(t.quiet);
    const QString when = toText(ending.when);
    p.drawText(QRectF(120, y, right - 120, 24), Qt::AlignRight | Qt::AlignVCenter,
               QFontMetricsF(p.font()).elidedText(when, Qt::ElideRight, right - 120));
    y += 24;
  }
}

int StateTable::rowAt(double y) const {
  const int row = y < 32 ? -1 : static_cast<int>((y - 32) / 28);
  return inspection_ && row < static_cast<int>(inspection_->states.size()) ? row : -1;
}

void StateTable::choose(int row) {
  if (!inspection_ || row < 0 || row >= static_cast<int>(inspection_->states.size())) return;
  chosen_ = row;
  const SeenState& state = inspection_->states[static_cast<std::size_t>(row)];
  Q_EMIT lineAsked(state.rangeAt.line);
  update();
}

void StateTable::mousePressEvent(QMouseEvent* event) {
  const int row = rowAt(mouseAt(*event).y());
  if (row < 0) return;
  choose(row);
  const SeenState& state = inspection_->states[static_cast<std::size_t>(row)];
  if (isProposal(state, mouseAt(*event).x())) Q_EMIT rangeProposed(state);
}

bool StateTable::isProposal(const SeenState& state, double x) const {
  const double off = histogramAt() - x;
  return state.proposes() && off > -kHistogram && off < 120;
}

void StateTable::mouseMoveEvent(QMouseEvent* event) {
  const int row = rowAt(mouseAt(*event).y());
  if (row < 0) return unsetCursor(), setToolTip({});
  const SeenState& state = inspection_->states[static_cast<std::size_t>(row)];
  setCursor(isProposal(state, mouseAt(*event).x()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
  QString tip =
      tr("%1: range %2 … %3 in the file, %4 tiles")
          .arg(toText(state.title), numberText(state.low), numberText(state.high), QString::number(state.tiles));
  if (state.proposes())
    tip += tr("; a click on the numbers writes %1 … %2")
               .arg(numberText(state.proposedLow), numberText(state.proposedHigh));
  setToolTip(tipText(tip));
}

void StateTable::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Down) return choose(chosen_ + 1);
  if (event->key() == Qt::Key_Up) return choose(std::max(0, chosen_ - 1));
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && chosen_ >= 0 && inspection_) {
    const SeenState& state = inspection_->states[static_cast<std::size_t>(chosen_)];
    if (state.proposes()) Q_EMIT rangeProposed(state);
    return;
  }
  Painted::keyPressEvent(event);
}

}  // namespace surefoot

#include "moc_state_table.cpp"
