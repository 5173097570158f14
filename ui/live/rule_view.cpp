// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/rule_view.h"

#include <QAbstractTextDocumentLayout>
#include <QPainter>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextDocument>
#include <cmath>

#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/running/running_life.h"
#include "ui/session/editing.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {
constexpr int kPadding = 12, kGap = 5;   // [px]
constexpr int kNumber = 24, kText = 11;  // sizes of text [px]

QString oneDecimal(double value) {
  return fixedNumber(value, 1);
}

/// "γ^n*" and "R_t" with superscripts and subscripts; no line break inside them.
QString richText(const QString& text) {
  static const QRegularExpression high("\\^([^ )]+)"), low("([A-Za-z])_([a-z])");
  return text.toHtmlEscaped()
      .replace("(1 − ", "(1\u00A0−\u00A0")
      .replace(high, "<sup>\\1</sup>")
      .replace(low, "\\1<sub>\\2</sub>");
}
}  // namespace

RuleView::RuleView(RunningLife& life, Editing& editing, QWidget* parent)
    : Painted(parent),
      life_(life),
      editing_(editing),
      use_(new QPushButton(this)) {
  use_->setToolTip(tr("Sets TRL's threshold to the rule's number, rounded; Edit › Undo takes it back"));
  connect(use_, &QPushButton::clicked, this, &RuleView::use);
  for (const auto changed : {&RunningLife::valuesArrived, &RunningLife::configurationChanged, &RunningLife::replaced})
    connect(&life_, changed, this, &RuleView::refresh);
  refresh();
}

const RuleOfThumb* RuleView::rule() const {
  const ValueSnapshot* v = life_.values();
  return v && v->rule ? &*v->rule : nullptr;
}

void RuleView::use() {
  if (!rule()) return;
  static_cast<void>(static_cast<bool>(editing_.setParameter("policy.threshold", std::round(rule()->threshold))));
}

void RuleView::refresh() {
  const RuleOfThumb* r = rule();
  use_->setVisible(r != nullptr);
  if (r) {
    const double rounded = std::round(r->threshold);
    const QString text = tr("Set the threshold to %1").arg(countNumber(rounded));
    if (text != use_->text()) {
      use_->setText(text);
      use_->setAccessibleName(text);
    }
    resizeEvent(nullptr);
    use_->setEnabled(life_.configuration().parameters.get("policy.threshold") != rounded);
  }
  setAccessibleDescription(lines().join(' '));
  update();
}

QString RuleView::inForce() const {
  const std::string& policy = life_.configuration().names.policy;
  const QString threshold = countNumber(life_.threshold());
  if (policy == "trl") return tr("TRL's threshold in force: %1.").arg(threshold);
  const auto entry = findEntry(life_.registry().policies, "policy", policy);
  return tr("TRL's threshold is %1; it is not in force while the policy is %2.")
      .arg(threshold, fromCore(entry ? (*entry)->title : policy));
}

QStringList RuleView::lines() const {
  const RuleOfThumb* r = rule();
  if (!r) return {fromCore(whyNoRule(life_.task(), life_.configuration().parameters))};
  const RuleText text = textOf(*r);
  const bool timed = r->timeReward != 0;
  QStringList list = {localNumbers(text.threshold)};
  list << tr("%1 = %2 = %3").arg(toText(text.symbols), localNumbers(text.formula), localNumbers(text.threshold));
  if (r->goal)
    list << tr("R: reward of the goal; n*: mean transitions of the successful episodes while it learned%1 (thesis, "
               "eq. %2).")
                .arg(timed ? tr("; R_t: reward of every step") : QString(), timed ? "4.3" : "4.1");
  else
    list << tr("There is no goal. R: the highest reward of a step so far; n*: transitions of a footstep%1. The thesis "
               "expects this to serve and did not test it (section 4.5).")
                .arg(timed ? tr("; R_t: reward of every step") : QString());
  if (r->preLearned)
    list << tr("This life began with something learned; the limits are told of lives that begin from nothing.");
  else if (r->goal)
    list << tr("Lower limit %1, upper limit %2.")
                .arg(r->lower ? oneDecimal(*r->lower) : tr("not yet"),
                     r->upper ? oneDecimal(*r->upper) : tr("not yet"));
  return list << inForce();
}

void RuleView::resizeEvent(QResizeEvent*) {
  const QSize size = use_->sizeHint();
  const int padding = scaled(kPadding);
  const int top = stacked() ? QFontMetrics(scaledFont(kNumber, 500)).height() + scaled(8) : scaled(4);
  use_->setGeometry(stacked() ? padding : std::max(padding, QWidget::width() - padding - size.width()), top,
                    size.width(), size.height());
}

bool RuleView::stacked() const {
  const int number = QFontMetrics(scaledFont(kNumber, 500)).horizontalAdvance(lines().front());
  return rule() && number + use_->sizeHint().width() + 3 * scaled(kPadding) > QWidget::width();
}

void RuleView::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.fillRect(rect(), t.panel);
  const QStringList list = lines();
  const QFont text = textFont(kText);
  p.setFont(text);
  p.setPen(t.quiet);
  if (list.size() == 1) {
    p.drawText(rect().adjusted(kPadding, 0, -kPadding, 0), Qt::AlignCenter | Qt::TextWordWrap, list[0]);
    return;
  }
  const QFont large = textFont(kNumber, 500);
  const double number = std::max<double>(QFontMetricsF(large).height(), stacked() ? 0.0 : placeOf(*use_).height());
  p.setFont(large);
  p.setPen(t.trl);
  p.drawText(QRectF(kPadding, 4, width() - 2 * kPadding, number), Qt::AlignVCenter, list[0]);
  double y = std::max(number + 4, placeOf(*use_).bottom()) + kGap;
  for (qsizetype i = 1; i < list.size(); ++i) {
    QTextDocument words;
    words.setDocumentMargin(0);
    words.setDefaultFont(i == 1 ? textFont(kText, 500) : text);
    words.setTextWidth(width() - 2 * kPadding);
    words.setHtml(richText(list[i]));
    QAbstractTextDocumentLayout::PaintContext context;
    context.palette.setColor(QPalette::Text, i == 1 ? t.ink : t.quiet);
    p.save();
    p.translate(kPadding, y);
    words.documentLayout()->draw(&p, context);
    p.restore();
    y += words.size().height() + kGap;
  }
}

}  // namespace surefoot

#include "moc_rule_view.cpp"
