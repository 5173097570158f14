// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ValueMaps for the examined state: keys, words and drawing.
#include <QAccessible>
#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <tuple>

#include "core/features/tile_layout.h"
#include "core/values_of_state.h"
#include "ui/language/numbers.h"
#include "ui/live/maps/value_maps.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

// The arrow keys are shortcuts of the program; while the map has the focus they move its cursor.
bool ValueMaps::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down ||
        (key == Qt::Key_Escape && !looking_.examined().empty())) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void ValueMaps::moveCursor(int columns, int rows) {
  if (!any_) return;
  const QRectF unit(0, 0, 1, 1);
  const double w = 1.0 / big_.columns(), h = 1.0 / big_.rows();
  const auto& from = looking_.examined().empty() ? looking_.shown().state : looking_.examined();
  QPointF at = big_.toPixel(life_.task(), from, unit) + QPointF(columns * w, rows * h);
  at = {std::clamp(at.x(), w / 2, 1 - w / 2), std::clamp(at.y(), h / 2, 1 - h / 2)};
  looking_.examine(big_.stateAt(life_.task(), at, unit));
}

void ValueMaps::keyPressEvent(QKeyEvent* event) {
  const int far = event->modifiers() & Qt::ShiftModifier ? 5 : 1;
  switch (event->key()) {
    case Qt::Key_Left:
      return moveCursor(-far, 0);
    case Qt::Key_Right:
      return moveCursor(far, 0);
    case Qt::Key_Up:
      return moveCursor(0, -far);
    case Qt::Key_Down:
      return moveCursor(0, far);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (looking_.examined().empty()) return;
      if (event->modifiers() & Qt::ControlModifier) return Q_EMIT placeAsked(looking_.examined());
      return looking_.pin(looking_.examined());
    case Qt::Key_Escape:
      looking_.examine(std::nullopt);
      return looking_.pin(std::nullopt);
    default:
      QWidget::keyPressEvent(event);
  }
}

QString ValueMaps::spoken() const {
  const std::vector<double>& state = looking_.examined();
  const ValueSnapshot* v = life_.values();
  const Task& task = life_.task();
  if (state.size() != task.state.size() || !v) return {};
  QStringList words;
  for (std::size_t d = 0; d < state.size(); ++d)
    words << QStringLiteral("%1 %2").arg(symbolOf(task.state[d]), fixedNumber(state[d], task.state[d].whole ? 0 : 2));
  if (looking_.valuesShown()->familiarity(state) < kFamiliar)
    return words.join(QStringLiteral("  ")) + tr(", never visited");
  ValuesOfState here;
  here.evaluate(*looking_.valuesShown(), state);
  std::vector<double> greedy(here.q.size());
  policy_->greedy(here.view(), greedy);  // as the maps: under the caution in force
  const auto best = static_cast<std::size_t>(std::max_element(greedy.begin(), greedy.end()) - greedy.begin());
  QString risk;
  if (!here.risk.empty()) risk = tr(",  risk %1 %").arg(fixedNumber(100 * std::clamp(here.risk[best], 0.0, 1.0), 1));
  const bool cautious = here.q[best] < *std::max_element(here.q.begin(), here.q.end());
  const QString action = actionNameOf(task, best);
  return tr("%1:  Q %2 for %3%5,  %4 visits")
      .arg(words.join(QStringLiteral("  ")), fixedNumber(here.q[best], 1),
           cautious ? tr("%1, under caution").arg(action) : action, countNumber(looking_.valuesShown()->visits(state)),
           risk);
}

QString ValueMaps::reached() const {
  const ValueSnapshot* v = life_.values();
  if (looking_.examined().size() != life_.task().state.size() || !v || !v->layouts.is_object()) return {};
  for (const auto& layout : v->layouts)
    if (const auto tiles = TileLayout::fromJson(layout))
      return tr("outlined: the %1 tiles of this state").arg(tiles->tilings());
  return {};
}

void ValueMaps::speak() {
  const QString text = spoken();
  if (text == accessibleDescription()) return;
  setAccessibleDescription(text);
  QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
  QAccessible::updateAccessibility(&changed);
}

// The tiles that an update in the state under the cursor would reach: all of Q⁺'s (or Q's) and all of Q⁻'s.
void ValueMaps::drawFootprints(QPainter& p, const Geometry& g, const Theme& t) const {
  const std::vector<double>& state = looking_.examined();
  const ValueSnapshot* v = life_.values();
  if (state.size() != life_.task().state.size() || !v || !v->layouts.is_object()) return;
  p.save();
  p.setRenderHint(QPainter::Antialiasing, false);
  p.setBrush(Qt::NoBrush);
  for (const auto& [name, layout] : v->layouts.items()) {
    if (name == "potential" || (name == "risk" && !risky())) continue;
    const auto tiles = TileLayout::fromJson(layout);
    if (!tiles) continue;
    std::vector<QRectF> squares = {g.big};
    if (split() && valued()) squares = {name == "positive" ? g.upper : g.lower};
    if (name == "risk") squares = {g.upper};
    QColor colour = t.ink;
    colour.setAlphaF(std::clamp(3.0f / static_cast<float>(tiles->tilings()), 0.12f, 0.8f));
    p.setPen(QPen(colour, 1));
    for (const QRectF& square : squares) {
      p.setClipRect(square);
      for (int i = 0; i < tiles->tilings(); ++i) {
        std::vector<double> low = state, high = state;
        for (const int axis : {choice_.x, choice_.y}) {
          const auto d = static_cast<std::size_t>(axis);
          std::tie(low[d], high[d]) = tiles->tileAt(d, i, state[d]);
        }
        QRectF tile(big_.toPixel(life_.task(), low, square), big_.toPixel(life_.task(), high, square));
        if (slice_.strip()) tile.setTop(square.top() + 1 + i), tile.setBottom(square.bottom() - 1 - i);
        p.drawRect(tile);
      }
    }
  }
  p.restore();
}

/// The text about the state under the cursor, over the half of the map without the cursor.
void ValueMaps::drawReading(QPainter& p, const Geometry& g, const Theme& t) const {
  const QString words = spoken();
  if (words.isEmpty()) return;
  QStringList lines = words.split(QStringLiteral(":  "));
  if (const QString tiles = reached(); !tiles.isEmpty()) lines << tiles;
  p.setFont(textFont(11));
  const double k = textScale(), line = QFontMetricsF(p.font()).height() + 1;
  double wide = 0;
  for (const QString& l : lines) wide = std::max(wide, symbolWidth(p.font(), l));
  const QSizeF size(std::min(wide + 12 * k, width() - 8.0), line * static_cast<double>(lines.size()) + 6 * k);
  const bool upper = big_.toPixel(life_.task(), looking_.examined(), g.big).y() < g.square.center().y();
  const double left = std::clamp(g.square.left() + 4, 4.0, std::max(4.0, width() - size.width() - 4));
  const QRectF box({left, upper ? g.square.bottom() - size.height() - 4 : g.square.top() + 4}, size);
  p.setPen(QPen(t.outline, 1));
  p.setBrush(t.panel);
  p.drawRoundedRect(box, 3, 3);
  for (qsizetype i = 0; i < lines.size(); ++i) {
    p.setPen(i + 1 < lines.size() || lines.size() == 1 ? t.ink : t.quiet);
    drawSymbol(p, QRectF(box.left() + 6 * k, box.top() + 3 * k + line * static_cast<double>(i), size.width(), line),
               Qt::AlignLeft, lines[i]);
  }
}

}  // namespace surefoot
