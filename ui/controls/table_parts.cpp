// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/table_parts.h"

#include <QHeaderView>
#include <QPainter>
#include <QStyle>
#include <algorithm>
#include <cmath>

#include "ui/language/numbers.h"
#include "ui/style/policy_look.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

double signWidth(const QFont& font) {
  return 1.5 * QFontMetricsF(font).height();
}

/// A tick, a ring or a cross.
void drawVerdict(QPainter& p, QPointF c, double r, Verdict verdict, const Theme& t) {
  p.setPen(QPen(verdict == Verdict::Undecided ? t.caution : t.ink, scaled(1.8)));
  p.setBrush(Qt::NoBrush);
  if (verdict == Verdict::Undecided) p.drawEllipse(c, r, r);
  if (verdict == Verdict::Agrees)
    p.drawPolyline(QPolygonF{{c.x() - r, c.y()}, {c.x() - r / 3, c.y() + r * 0.8}, {c.x() + r * 1.1, c.y() - r * 0.9}});
  if (verdict != Verdict::Differs) return;
  p.drawLine(c + QPointF(-r, -r), c + QPointF(r, r));
  p.drawLine(c + QPointF(-r, r), c + QPointF(r, -r));
}

QString superscript(int number) {
  static const QString kDigits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString out = number < 0 ? QStringLiteral("⁻") : QString();
  for (const QChar digit : QString::number(std::abs(number))) out += kDigits[digit.digitValue()];
  return out;
}

}  // namespace

void SignDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  if (!index.data(kPolicyRole).isValid() && !index.data(kVerdictRole).isValid()) return;
  const double space = QFontMetricsF(option->font).horizontalAdvance(' ');
  option->text.prepend(QString(static_cast<int>(std::ceil(signWidth(option->font) / space)), ' '));
}

void SignDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyledItemDelegate::paint(painter, option, index);
  const Theme& t = themeOf(option.palette);
  const double x = option.rect.left() + 0.6 * QFontMetricsF(option.font).height() + scaled(2);
  const QPointF centre(x, option.rect.center().y() + 0.5);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  if (const QVariant verdict = index.data(kVerdictRole); verdict.isValid())
    drawVerdict(*painter, centre, 0.3 * QFontMetricsF(option.font).height(), static_cast<Verdict>(verdict.toInt()), t);
  painter->translate(centre);
  painter->scale(textSize(), textSize());
  if (const QVariant policy = index.data(kPolicyRole); policy.isValid())
    drawMarker(*painter, {}, policyLook(policy.toString().toStdString(), t), option.state & QStyle::State_Selected);
  painter->restore();
}

void setUpTable(QTableWidget& table, const QStringList& heads) {
  table.setColumnCount(static_cast<int>(heads.size()));
  table.setHorizontalHeaderLabels(heads);
  table.verticalHeader()->hide();
  table.setItemDelegate(new SignDelegate(&table));
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setShowGrid(false);
  table.setFrameShape(QFrame::NoFrame);
  table.setWordWrap(false);
  table.setTabKeyNavigation(false);
  table.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table.setVerticalScrollMode(QAbstractItemView::ScrollPerItem);  // no row is cut under the heads
  QHeaderView& header = *table.horizontalHeader();
  header.setHighlightSections(false);
  header.setSectionResizeMode(QHeaderView::Interactive);
  header.setMinimumSectionSize(16);
  header.setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
  whenScaled(&table, [&table] {
    table.verticalHeader()->setDefaultSectionSize(QFontMetrics(scaledFont(13)).height() + scaled(12));
    table.horizontalHeader()->setFont(scaledFont(11, 500));
    for (int row = 0; row < table.rowCount(); ++row)
      for (int column = 0; column < table.columnCount(); ++column)
        if (auto* item = table.item(row, column)) item->setFont(scaledFont(13, item->font().weight()));
  });
  table.horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

QTableWidgetItem* put(QTableWidget& table, int row, int column, const QString& text, bool strong, bool left) {
  auto* item = table.item(row, column);
  if (!item) table.setItem(row, column, item = new QTableWidgetItem);
  item->setText(text);
  item->setTextAlignment((left ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  item->setFont(scaledFont(13, strong ? 500 : 400));
  return item;
}

void spreadColumns(QTableWidget& table) {
  const int columns = table.columnCount(), width = table.viewport()->width();
  // The margins beside a cell's text, as the style sets them, and 2 px for rounding.
  const int margins = 2 * (table.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &table) + 1) + 2;
  std::vector<int> wanted;
  int sum = 0, shown = 0;
  for (int c = 0; c < columns; ++c) {
    wanted.push_back(0);
    if (table.isColumnHidden(c)) continue;
    int need = table.horizontalHeader()->sectionSizeHint(c);
    for (int row = 0; row < table.rowCount(); ++row)
      if (const auto* item = table.item(row, c)) {
        const QFontMetrics metrics(item->font());
        const bool sign = item->data(kPolicyRole).isValid() || item->data(kVerdictRole).isValid();
        need = std::max(need, metrics.horizontalAdvance(item->text()) + margins +
                                  (sign ? static_cast<int>(signWidth(item->font())) : 0));
      }
    wanted.back() = need;
    sum += need;
    ++shown;
  }
  if (sum > width) {  // a long name is cut rather than a number
    const int least = QFontMetrics(scaledFont(13)).averageCharWidth() * 14;
    const int given = std::min(sum - width, std::max(0, wanted[0] - least));
    wanted[0] -= given;
    sum -= given;
  }
  const int rest = std::max(0, width - sum);
  for (int c = 0, place = 0; c < columns; ++c) {
    if (table.isColumnHidden(c)) continue;
    table.setColumnWidth(c, wanted[static_cast<std::size_t>(c)] + rest / shown + (place++ < rest % shown ? 1 : 0));
  }
}

QString pText(double p) {
  if (std::isnan(p)) return QStringLiteral("–");
  if (p < 1e-10) return QStringLiteral("< 10⁻¹⁰");
  if (p >= 0.995) return QStringLiteral("1.0");
  if (p >= 0.001) return fixedNumber(p, p >= 0.0995 ? 2 : 3).mid(1);
  int power = static_cast<int>(std::floor(std::log10(p)));
  double digits = p / std::pow(10.0, power);
  if (digits >= 9.95) digits = 1, ++power;
  return QStringLiteral("%1 · 10%2").arg(fixedNumber(digits, 1), superscript(power));
}

QString verdictText(Verdict verdict) {
  return verdict == Verdict::Agrees    ? QObject::tr("agrees")
         : verdict == Verdict::Differs ? QObject::tr("differs")
                                       : QObject::tr("undecided");
}

}  // namespace surefoot

#include "moc_table_parts.cpp"
