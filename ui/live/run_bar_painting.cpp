// SPDX-License-Identifier: GPL-3.0-or-later
// How the toolbar is laid out in the room it has, and drawn.
#include <QAbstractButton>
#include <QPainter>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/controls/combo.h"
#include "ui/controls/slider.h"
#include "ui/language/numbers.h"
#include "ui/live/run_bar.h"
#include "ui/running/running_life.h"
#include "ui/session/editing.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {
constexpr int kButton = 32;  // [px], with texts of the usual size
}

std::vector<RunBar::Word> RunBar::counter(int fold) const {
  if (!life_.task().canFall) return {{tr("episodes"), 11, 400, false, 7}, {texts_.episodes, 24, 500, false, 0}};
  std::vector<Word> words;
  if (fold < kEpisodes) words = {{tr("episodes"), 11, 400, false, 6}, {texts_.episodes, 13, 500, false, 20}};
  words.push_back({tr("falls"), 11, 400, false, 7});
  words.push_back({texts_.falls, 24, 500, true, 0});
  return words;
}

int RunBar::counterWidth(int fold) const {
  double width = 0;
  for (const Word& w : counter(fold)) width += symbolWidth(textFont(w.pixels, w.weight), w.text) + textScale() * w.gap;
  return static_cast<int>(std::ceil(width));
}

/// Places everything but the counter. The boxes share `spare` beyond their least widths. Returns the right end.
int RunBar::place(int fold, int spare) {
  const double k = textScale();
  const auto px = [k](double usual) { return static_cast<int>(std::lround(k * usual)); };
  const int middle = height() / 2;
  int x = 8;
  const auto put = [&](QWidget* w, int gap) {
    const QSize size = placeOf(*w).size().toSize();
    w->move(scaled(x), scaled(middle - size.height() / 2));
    x += size.width() + gap;
  };
  for (std::size_t i = 0; i < 3; ++i) put(buttons_[i], 8);
  x += 16;
  const bool pace = fold < kPace;
  pace_->setVisible(pace);
  paceLabel_ = factorLabel_ = 0;
  if (pace) {
    if (fold < kPaceWord) x += px(40);
    const int length = fold < kPaceWord ? px(106) : px(72);
    Painted::place(*pace_, {x, middle - 12, length, 24});
    x += length + 6;
    paceLabel_ = x;
    x += px(40);
  }
  put(buttons_[3], 8);
  if (fold < kFactor) {
    factorLabel_ = x;
    x += px(60);
  }
  x += 8;
  const int least = fold < kShortBoxes ? px(100) : px(64);
  const auto wanted = [&](const QComboBox* combo) {  // for all of its text
    const double name = symbolWidth(textFont(13), combo->currentText()) + (combo == policy_ ? px(20) : 0);
    const int usual = (combo == policy_ ? 116 : 132) - (fold < kPaceWord ? 0 : 20);
    return std::clamp(static_cast<int>(name) + px(46), px(usual), px(280));
  };
  int need = 0;
  for (const QComboBox* combo : {task_, agent_, policy_}) need += std::max(0, wanted(combo) - least);
  const double share = fold < kBoxes ? 1.0 : std::clamp(spare / std::max(1.0, static_cast<double>(need)), 0.0, 1.0);
  for (QComboBox* combo : {task_, agent_, policy_}) {
    const int w = least + static_cast<int>(share * std::max(0, wanted(combo) - least));
    Painted::place(*combo, {x, middle - px(kButton) / 2, w, px(kButton)});
    x += w + 8;
  }
  meaning_->resize(scaled({24, 28}));
  x -= 6;
  put(meaning_, 8);
  return x;
}

void RunBar::layOut() {
  counterWidth_ = counterWidth(kNothing);
  for (fold_ = kNothing; fold_ < kFolds; ++fold_) {
    const int spare = width() - 12 - counterWidth(fold_) - place(fold_, 0);
    if (spare < 0 && fold_ + 1 < kFolds) continue;
    place(fold_, std::max(0, spare));
    break;
  }
  update();
}

void RunBar::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  const double k = textScale();
  ScaledPainter p(this);
  p.fillRect(rect(), t.panel);
  p.fillRect(lowerEdge(), t.hairline);
  for (const double x : {placeOf(*buttons_[2]).right() + 13, placeOf(*task_).x() - 10})
    p.fillRect(QRectF(x, height() / 4, 1, height() / 2), t.hairline);
  const QRectF line(0, 0, width(), height());
  p.setFont(textFont(13));
  p.setPen(t.quiet);
  if (fold_ < kPaceWord)
    drawSymbol(p, line.adjusted(0, 0, placeOf(*pace_).x() - 6 - width(), 0), Qt::AlignRight, tr("Pace"));
  p.setPen(t.ink);
  const double pace = life_.pace();
  if (paceLabel_ > 0)
    drawSymbol(p, line.adjusted(paceLabel_, 0, 0, 0), Qt::AlignLeft,
               QStringLiteral("%1×").arg(pace < 9.95 && pace != 1.0 ? fixedNumber(pace, 1) : fixedNumber(pace, 0)));
  if (factorLabel_ > 0) drawSymbol(p, line.adjusted(factorLabel_, 0, 0, 0), Qt::AlignLeft, texts_.factor);

  // Falls large; from the right: "episodes", its number, "falls", its number.
  double right = width() - 12;
  const double baseline = height() / 2.0 + 6 * k;
  for (const Word& w : counter(fold_)) {
    p.setFont(textFont(w.pixels, w.weight));
    p.setPen(w.falls ? t.fallText : w.weight > 400 ? t.ink : t.quiet);
    right = std::floor(right - symbolWidth(p.font(), w.text));
    drawSymbol(p, right, baseline, w.text);
    right -= k * w.gap;
  }
}

}  // namespace surefoot
