// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/actions/action_key.h"

#include <QPainter>

#include "ui/language/from_core.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/style/colour_map.h"
#include "ui/style/policy_look.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {
constexpr double kSample = 14;  // a sample with its space [px]
const QString kPositive = QStringLiteral("Q⁺"), kNegative = QStringLiteral("Q⁻");
}  // namespace

ActionKey::ActionKey(RunningLife& life, Looking& looking, QWidget* parent)
    : Painted(parent),
      life_(life),
      looking_(looking) {
  connect(&life_, &RunningLife::configurationChanged, this, &ActionKey::refresh);
  connect(&life_, &RunningLife::valuesArrived, this, &ActionKey::refresh);
  connect(&life_, &RunningLife::replaced, this, &ActionKey::refresh);
  refresh();
}

void ActionKey::refresh() {
  std::vector<Item> items;
  if (!life_.task().actionVariables.empty()) {
    const std::string& now = life_.configuration().names.policy;
    for (const auto& entry : life_.registry().policies)
      if (entry.name == now || (entry.name != "greedy" && entry.name != "mellowmax"))
        items.push_back({fromCore(entry.title), entry.name, entry.name == now});
  } else if (!looking_.shown().qPositive.empty()) {
    items = {{kNegative, "", false}, {kPositive, "", false}, {QStringLiteral("Q"), "", false}};
  }
  if (items == items_) return;
  items_ = std::move(items);
  updateGeometry();
  if (auto* header = qobject_cast<PanelHeader*>(parentWidget())) header->layOutExtra();
  update();
}

double ActionKey::widthOf(const Item& item) const {
  return textScale() * kSample + symbolWidth(textFont(11, item.strong ? 500 : 400), item.text);
}

QSize ActionKey::sizeHint() const {
  return scaled({widthWith(gap_), 20});
}

int ActionKey::widthWith(double gap) const {
  double width = 0;
  for (const Item& item : items_) width += widthOf(item) + textScale() * gap;
  return static_cast<int>(width);
}

void ActionKey::fold(int room) {
  gap_ = scaled(widthWith(kUsualGap)) <= room ? kUsualGap : kLeastGap;
  updateGeometry();
}

void ActionKey::drawSample(QPainter& p, QPointF at, const Item& item, const Theme& t) const {
  if (!item.policy.empty()) return drawMarker(p, at, policyLook(item.policy, t), item.strong);
  const double k = textScale();
  p.setPen(Qt::NoPen);
  if (item.text == kPositive || item.text == kNegative) {
    p.setBrush(QColor::fromRgb(divergingColour(item.text == kPositive ? 0.5 : -0.5, t.dark)));
    p.drawRect(QRectF(at.x() - 4 * k, at.y() - 4 * k, 9 * k, 9 * k));
  } else {
    p.setBrush(t.ink);
    p.drawRect(QRectF(at.x() + 2 * k, at.y() - 5 * k, 2.5 * k, 11 * k));
  }
}

void ActionKey::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  double x = 0;
  for (const Item& item : items_) {
    drawSample(p, {x + 5 * textScale(), height() / 2.0}, item, t);
    p.setFont(textFont(11, item.strong ? 500 : 400));
    p.setPen(item.strong ? t.ink : t.quiet);
    drawSymbol(p, QRectF(x + textScale() * kSample, 0, width(), height()), Qt::AlignLeft, item.text);
    x += widthOf(item) + textScale() * gap_;
  }
}

}  // namespace surefoot

#include "moc_action_key.cpp"
