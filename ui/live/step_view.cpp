// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/step_view.h"

#include <QPainter>
#include <cmath>

#include "ui/language/numbers.h"
#include "ui/live/maps/map_choice.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr int kUpdateEvery = 150;  // [ms]

QString number(double v) {
  return fixedNumber(v, std::abs(v) < 99.95 ? 2 : 0);
}

/// The same number after a sign; negative ones in brackets: "(−2.69)".
QString bracketed(double v) {
  return v < 0 ? QStringLiteral("(%1)").arg(number(v)) : number(v);
}

/// "Q", "Q⁺", "Q⁻"
QString nameOf(const std::string& estimate) {
  return estimate == "positive"   ? QStringLiteral("Q⁺")
         : estimate == "negative" ? QStringLiteral("Q⁻")
                                  : QStringLiteral("Q");
}

}  // namespace

StepView::StepView(RunningLife& life, Looking& looking, QWidget* parent)
    : Painted(parent),
      life_(life),
      looking_(looking) {
  sinceUpdate_.start();
  connect(&looking_, &Looking::frame, this, &StepView::nextFrame);
}

void StepView::nextFrame() {
  if (!isVisible() || sinceUpdate_.elapsed() < kUpdateEvery) return;
  sinceUpdate_.restart();
  shown_ = life_.snapshot();
  setAccessibleDescription(sentences().join(' '));
  update();
}

QStringList StepView::sentences() const {
  const Task& task = life_.task();
  QStringList list;
  if (life_.turbo() && life_.running())
    return {tr("In turbo thousands of steps pass between two pictures. Turn it off to follow a single one.")};
  if (shown_.learned.empty() || shown_.stateBefore.size() != task.state.size() || shown_.actionBefore == kNoAction ||
      static_cast<std::size_t>(shown_.actionBefore) >= task.actions.size())
    return {tr("What the last step taught appears here. Press “.” for a single step.")};
  QStringList state;
  for (std::size_t d = 0; d < task.state.size(); ++d)
    state << QStringLiteral("%1 %2").arg(symbolOf(task.state[d]),
                                         fixedNumber(shown_.stateBefore[d], task.state[d].whole ? 0 : 2));
  const QString action = actionNameOf(task, static_cast<std::size_t>(shown_.actionBefore)),
                unit = toText(task.actionUnit);
  list << tr("In S = (%1) it chose A = %2.")
              .arg(state.join(QStringLiteral(", ")), unit.isEmpty() ? action : action + ' ' + unit);
  for (const NamedStep& n : shown_.learned) {
    const double delta = n.step.delta(), moved = n.stepSize * delta;
    const QString q = nameOf(n.name);
    list << tr("δ = R + γ %1(S′, A′) − %1(S, A) = %2 + %3 − %4 = %5")
                .arg(q, number(n.step.reward), bracketed(n.step.next), bracketed(n.step.before), number(delta));
    if (std::abs(delta) < 0.005)
      list << tr("Just as expected: %1 stays as it is.").arg(q);
    else
      list << (delta > 0 ? tr("Better than expected: %1(S, A) goes up by α δ = %2, to %3.")
                         : tr("Worse than expected: %1(S, A) goes down by %2, to %3."))
                  .arg(q, number(std::abs(moved)), number(n.step.before + moved));
  }
  const double lambda = shown_.learned.front().traceDecay;
  const double gamma = life_.configuration().parameters.get("agent.discount");
  if (lambda > 0)
    list << tr("The trace carries the surprise back along the way: each step before gets %1 of it (γ λ = %2 · %3).")
                .arg(fixedNumber(gamma * lambda, 2), fixedNumber(gamma, 2), fixedNumber(lambda, 2));
  else
    list << tr("λ is 0: no step before learns from it.");
  return list;
}

void StepView::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.fillRect(rect(), t.panel);
  const QStringList list = sentences();
  if (list.size() == 1) {
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    p.drawText(rect().adjusted(12, 0, -12, 0), Qt::AlignCenter | Qt::TextWordWrap, list[0]);
    return;
  }
  double y = 8;
  for (const QString& sentence : list) {
    const bool equation = sentence.startsWith(QStringLiteral("δ"));
    p.setFont(textFont(13, equation ? 500 : 400));
    p.setPen(equation ? t.ink : t.quiet);
    const QFontMetricsF metrics(p.font());
    if (symbolWidth(p.font(), sentence) <= width() - 24) {
      drawSymbol(p, QRectF(12, y, width() - 24, 22), Qt::AlignLeft, sentence);
      y += 24;
    } else {
      const QRectF where(12, y + 2, width() - 24, 60);
      QString plain = sentence;
      p.drawText(where, Qt::TextWordWrap, plain.remove(QChar(0x0307)));
      y += metrics.boundingRect(where, Qt::TextWordWrap, plain).height() + 6;
    }
  }
}

}  // namespace surefoot

#include "moc_step_view.cpp"
