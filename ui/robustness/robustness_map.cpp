// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robustness/robustness_map.h"

#include <QKeyEvent>
#include <QScrollArea>
#include <algorithm>
#include <cmath>

#include "core/robustness/robustness_text.h"
#include "ui/controls/view_menu.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/support/announce.h"

namespace surefoot {

namespace {
constexpr QSize kUsualSize(960, 340), kLeastSize(480, 220);  // [px]
constexpr int kHead = 44, kFoot = 46;                        // [px] above and below the cells
constexpr double kLeastRow = 22, kMostRow = 40, kMostCell = 88, kMostLabels = 280, kBetween = 24;
}  // namespace

RobustnessMap::RobustnessMap(QWidget* parent) : Painted(parent) {
  setAccessibleName(tr("Falls over pushes and models"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  new ViewMenu(*this);
  whenScaled(this, [this] { updateGeometry(); });
}

void RobustnessMap::show(std::shared_ptr<const Robustness> robustness) {
  robustness_ = std::move(robustness);
  chosen_.reset();
  updateGeometry();
  update();
}

int RobustnessMap::leastHeight() const {
  const double rows = robustness_ ? static_cast<double>(robustness_->plan.models.size()) : 0.0;
  return std::max(kLeastSize.height(), static_cast<int>(std::ceil(kHead + kFoot + rows * kLeastRow)));
}

QSize RobustnessMap::minimumSizeHint() const {
  return scaled({kLeastSize.width(), leastHeight()});
}

QSize RobustnessMap::sizeHint() const {
  return scaled({kUsualSize.width(), std::max(kUsualSize.height(), leastHeight())});
}

QRectF RobustnessMap::Layout::map(std::size_t function) const {
  const double wide = cell * static_cast<double>(columns);
  return {labels + static_cast<double>(function) * (wide + between), kHead, wide, row * static_cast<double>(rows)};
}

QRectF RobustnessMap::Layout::at(std::size_t function, std::size_t model, std::size_t push) const {
  const QRectF all = map(function);
  const double x = all.left() + cell * static_cast<double>(push), y = all.top() + row * static_cast<double>(model);
  // Whole pixels: cells meet without a seam.
  return QRectF(QPointF(std::round(x), std::round(y)), QPointF(std::round(x + cell), std::round(y + row)));
}

RobustnessMap::Layout RobustnessMap::layOut() const {
  const RobustnessPlan& plan = robustness_->plan;
  Layout l{.columns = plan.pushes.size(), .rows = plan.models.size()};
  const QFontMetricsF metrics(textFont(13));
  double longest = QFontMetricsF(textFont(11)).horizontalAdvance(tr("push, N s"));
  for (const TriedModel& model : plan.models)
    longest = std::max(longest, metrics.horizontalAdvance(fromCore(model.title)));
  l.labels = std::min({std::ceil(longest) + 12, kMostLabels, width() * 0.3});
  const auto maps = static_cast<double>(plan.functions.size());
  l.between = kBetween;
  const double room = width() - l.labels - (maps - 1) * l.between;
  l.cell = std::min(kMostCell, room / (maps * static_cast<double>(l.columns)));
  l.row = std::clamp((height() - kHead - kFoot) / static_cast<double>(l.rows), kLeastRow, kMostRow);
  return l;
}

std::optional<RobustnessMap::Chosen> RobustnessMap::cellAt(QPointF at) const {
  if (!robustness_) return std::nullopt;
  const Layout l = layOut();
  for (std::size_t f = 0; f < robustness_->plan.functions.size(); ++f) {
    const QRectF all = l.map(f);
    if (!all.contains(at)) continue;
    return Chosen{std::min(l.rows - 1, static_cast<std::size_t>((at.y() - all.top()) / l.row)),
                  std::min(l.columns - 1, static_cast<std::size_t>((at.x() - all.left()) / l.cell))};
  }
  return std::nullopt;
}

void RobustnessMap::choose(std::optional<Chosen> cell) {
  if (cell == chosen_) return;
  chosen_ = cell;
  update();
  Q_EMIT chosen();
}

QStringList RobustnessMap::spoken() const {
  if (!robustness_ || !chosen_) return {};
  const RobustnessPlan& plan = robustness_->plan;
  const auto [model, push] = *chosen_;
  QStringList lines;
  for (std::size_t f = 0; f < plan.functions.size(); ++f) {
    const Tally& tally = robustness_->at(f, model, push);
    const auto of = [](std::int64_t count) { return countNumber(static_cast<double>(count)); };
    QString line = f == 0
                       ? tr("%1, push %2 N s: ")
                             .arg(fromCore(plan.models[model].title), localNumbers(QString::number(plan.pushes[push])))
                       : tr("beside it: ");
    const Interval share = plan.canFall ? tally.fallen() : tally.succeeded();
    const auto percent = [](double part) { return fixedNumber(100 * part, 0); };
    line +=
        (plan.canFall ? tr("%1 of %2 fell, %3 % (95 %: %4 … %5 %)") : tr("%1 of %2 succeeded, %3 % (95 %: %4 … %5 %)"))
            .arg(of(plan.canFall ? tally.falls : tally.successes), of(tally.trials), percent(share.value),
                 percent(share.low), percent(share.high));
    if (plan.canFall && plan.canSucceed) line += tr("; %1 succeeded").arg(of(tally.successes));
    if (tally.flewApart > 0) line += tr("; %1 flew apart").arg(of(tally.flewApart));
    if (f > 0 && robustness_->differ(model, push)) line += tr("; the intervals have nothing in common");
    lines << line;
  }
  return lines;
}

void RobustnessMap::move(int columns, int rows) {
  if (!robustness_) return;
  const auto moved = [](std::size_t from, int by, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(from) + by, 0, static_cast<int>(count) - 1));
  };
  const RobustnessPlan& plan = robustness_->plan;
  const Chosen from = chosen_.value_or(Chosen{});
  choose(chosen_ ? Chosen{moved(from.model, rows, plan.models.size()), moved(from.push, columns, plan.pushes.size())}
                 : from);
  showChosen();
  announce(*this, spoken().join(QStringLiteral("; ")));
}

/// Scrolls to the chosen cell.
void RobustnessMap::showChosen() {
  const QRectF cell = layOut().at(0, chosen_->model, chosen_->push);
  const QRect place = QRectF(cell.topLeft() * textSize(), cell.size() * textSize()).toAlignedRect();
  for (QWidget* w = parentWidget(); w; w = w->parentWidget())
    if (auto* area = qobject_cast<QScrollArea*>(w)) {
      const QPoint middle = mapTo(area->widget(), place.center());
      return area->ensureVisible(middle.x(), middle.y(), place.width(), place.height());
    }
}

void RobustnessMap::mouseMoveEvent(QMouseEvent* event) {
  choose(cellAt(mouseAt(*event)));
}

void RobustnessMap::leaveEvent(QEvent*) {
  if (!hasFocus()) choose(std::nullopt);
}

void RobustnessMap::focusInEvent(QFocusEvent* event) {
  Painted::focusInEvent(event);
  if (event->reason() != Qt::MouseFocusReason && !chosen_) move(0, 0);
  update();
}

// The arrow keys are shortcuts of the program; while the map has the focus they choose a cell.
bool RobustnessMap::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void RobustnessMap::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return move(-1, 0);
    case Qt::Key_Right:
      return move(1, 0);
    case Qt::Key_Up:
      return move(0, -1);
    case Qt::Key_Down:
      return move(0, 1);
    default:
      QWidget::keyPressEvent(event);
  }
}

std::string RobustnessMap::asCsv() const {
  return robustness_ ? robustnessAsCsv(*robustness_) : std::string();
}

void RobustnessMap::prepareExport(bool exporting) {
  exporting_ = exporting;  // without the cell that happens to be chosen
}

}  // namespace surefoot

#include "moc_robustness_map.cpp"
