// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/action_rows.h"

#include <fmt/format.h>

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "ui/colour_map.h"
#include "ui/learning_charts.h"
#include "ui/map_choice.h"
#include "ui/session.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

namespace {
constexpr int kUpdateEvery = 66;                     // [ms]: numbers that change faster cannot be read
constexpr double kBar = 12, kHead = 32, kFoot = 34;  // [px]
constexpr const char* kShown[] = {"epsilon-greedy", "trl", "softmax"};
}  // namespace

ActionRows::ActionRows(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  rebuild();
  sinceUpdate_.start();
  connect(&session_, &Session::frame, this, &ActionRows::nextFrame);
  connect(&session_, &Session::valuesArrived, this, qOverload<>(&ActionRows::update));  // the threshold, as the maps
  connect(&session_, &Session::configurationChanged, this, &ActionRows::rebuild);
}

void ActionRows::rebuild() {
  columns_.clear();
  for (const char* name : kShown) {
    auto policy = makePolicy(session_.registry(), name, session_.configuration().parameters);
    if (!policy) continue;
    const auto entry = findEntry(session_.registry().policies, "policy", name);
    columns_.push_back({name, toText((*entry)->title), std::move(*policy), {}});
  }
  low_ = std::min(session_.task().lowestReturn, 0.0);
  high_ = std::max(session_.task().highestReturn, low_ + 1.0);
  q_.clear();
  nextFrame();
}

void ActionRows::nextFrame() {
  if (!isVisible() || (sinceUpdate_.isValid() && sinceUpdate_.elapsed() < kUpdateEvery && !q_.empty())) return;
  sinceUpdate_.restart();
  if (session_.shown().q.empty()) return;
  takeValues();
  const LifeTime time = session_.lifeTime();
  for (Column& column : columns_) {
    column.policy->advance(time);
    column.pi.resize(q_.size());
    column.policy->probabilities(q_, column.pi);
  }
  sumLevels();
  update();
}

/// Of the live state, or of that which is looked at on the map.
void ActionRows::takeValues() {
  const Shown& shown = session_.shown();
  const std::vector<double>& state = session_.examined();
  const ValueSnapshot* v = session_.values();
  chosen_ = kNoAction;
  if (state.size() != session_.task().state.size() || !v) {
    q_ = shown.q;
    positive_ = shown.qPositive;
    negative_ = shown.qNegative;
    chosen_ = shown.action;
    return;
  }
  const auto n = static_cast<std::size_t>(v->values->actions());
  q_.resize(n);
  session_.valuesShown()->evaluate(state, Layer::Sum, q_);
  for (auto* part : {&positive_, &negative_}) part->resize(session_.valuesShown()->split() ? n : 0);
  if (!session_.valuesShown()->split()) return;
  session_.valuesShown()->evaluate(state, Layer::Positive, positive_);
  session_.valuesShown()->evaluate(state, Layer::Negative, negative_);
}

std::string ActionRows::asCsv() const {
  const auto& variables = session_.task().actionVariables;
  std::string csv = "action";
  for (const ActionVariable& v : variables) csv += "," + v.key;
  csv += positive_.empty() ? ",q" : ",q,q_positive,q_negative";
  for (const Column& column : columns_) csv += "," + column.name;
  csv += '\n';
  for (std::size_t a = 0; a < q_.size(); ++a) {
    csv += fmt::format("{}", session_.task().actions[a]);
    for (std::size_t j = 0; j < variables.size(); ++j)
      csv += fmt::format(",{:.9g}", variables[j].levels[levelOf(session_.task(), a, j)]);
    csv += fmt::format(",{:.9g}", q_[a]);
    if (!positive_.empty()) csv += fmt::format(",{:.9g},{:.9g}", positive_[a], negative_[a]);
    for (const Column& column : columns_) csv += fmt::format(",{:.9g}", column.pi[a]);
    csv += '\n';
  }
  return q_.empty() ? "" : csv;
}

ActionRows::Geometry ActionRows::geometry() const {
  const double w = width(), n = std::max<double>(1, static_cast<double>(session_.task().actions.size()));
  Geometry g{};
  g.top = kHead;
  g.row = std::clamp((height() - kHead - kFoot) / n, 16.0, 32.0);
  g.bottom = g.top + n * g.row;
  g.label = 59;
  g.first = std::round(0.428 * w);
  g.qLeft = 76;
  g.qRight = g.first - 55;
  g.qNumber = g.first - 25;
  g.pitch = (w - g.first) / 3.0;
  g.number = g.pitch - 22;
  g.bar = g.number - 41;
  return g;
}

double ActionRows::xOf(double value, const Geometry& g) const {
  return g.qLeft + (g.qRight - g.qLeft) * (std::clamp(value, low_, high_) - low_) / (high_ - low_);
}

void ActionRows::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  p.fillRect(rect(), t.panel);
  p.setRenderHint(QPainter::Antialiasing);
  if (!session_.task().actionVariables.empty()) return levels_.empty() ? void() : drawLevels(p, t);
  const Geometry g = geometry();
  drawHead(p, t, g);
  if (q_.empty()) return;
  if (chosen_ != kNoAction) {
    const double highlight = g.top + (static_cast<double>(q_.size()) - 1 - chosen_) * g.row;
    p.setPen(Qt::NoPen);
    p.setBrush(t.fill);
    p.drawRoundedRect(QRectF(4, highlight + 2, width() - 8, g.row - 4), 4, 4);
  }
  drawScales(p, t, g);
  for (std::size_t a = 0; a < q_.size(); ++a) drawRow(p, t, g, a);
  drawThreshold(p, t, g);
}

void ActionRows::drawHead(QPainter& p, const Theme& t, const Geometry& g) const {
  const Task& task = session_.task();
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  p.drawText(QPointF(12, 20), task.actionUnit.empty()
                                  ? toText(task.actionTitle)
                                  : QStringLiteral("%1, %2").arg(toText(task.actionTitle), toText(task.actionUnit)));
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  p.drawText(QRectF(g.qNumber - 40, 6, 40, 20), Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("Q"));
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double x = g.first + g.pitch * static_cast<double>(i);
    const bool inForce = columns_[i].name == session_.configuration().names.policy;
    drawMarker(p, {x + 4, 15.5}, policyLook(columns_[i].name, t), inForce);
    p.setFont(textFont(13, inForce ? 500 : 400));
    p.setPen(t.ink);
    p.drawText(QPointF(x + 15, 20), columns_[i].title);
    if (!inForce) continue;
    const double end = x + 15 + QFontMetricsF(p.font()).horizontalAdvance(columns_[i].title) + 5;
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    const double room = (i + 1 < columns_.size() ? x + g.pitch : width()) - end - 10;
    if (QFontMetricsF(p.font()).horizontalAdvance(tr("in force")) < room) p.drawText(QPointF(end, 20), tr("in force"));
  }
}

void ActionRows::drawScales(QPainter& p, const Theme& t, const Geometry& g) const {
  p.setFont(textFont(11));
  const double step = niceAbove((high_ - low_) / 4.0001);
  for (double v = std::ceil(low_ / step) * step; v <= high_; v += step) {
    const double x = std::round(xOf(v, g)) + 0.5;
    p.setPen(QPen(v == 0 ? t.outline : t.hairline, 1));
    p.drawLine(QPointF(x, g.top), QPointF(x, g.bottom));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(x - 30, g.bottom + 4, 60, 16), Qt::AlignHCenter, toText(countText(v)));
  }
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double x0 = g.first + g.pitch * static_cast<double>(i);
    for (const int percent : {0, 1, 10, 100}) {  // a square-root axis: the exploring few per cent are what differs
      const double x = std::round(x0 + g.bar * std::sqrt(percent / 100.0)) + 0.5;
      p.setPen(QPen(percent == 0 ? t.outline : t.hairline, 1));
      p.drawLine(QPointF(x, g.top), QPointF(x, g.bottom));
      p.setPen(t.quiet);
      const bool room = percent >= 10 || g.bar > (percent == 1 ? 90 : 40);
      if (room) drawSymbol(p, QRectF(x - 30, g.bottom + 4, 60, 16), Qt::AlignHCenter, QString::number(percent));
    }
    drawSymbol(p, QRectF(x0 + g.number - 20, g.bottom + 4, 20, 16), Qt::AlignRight, QStringLiteral("%"));
  }
}

void ActionRows::drawRow(QPainter& p, const Theme& t, const Geometry& g, std::size_t action) const {
  const double middle = g.top + (static_cast<double>(q_.size() - action) - 0.5) * g.row;
  const bool chosen = static_cast<int>(action) == chosen_;
  const auto number = [&](double right, const std::string& text, bool strong) {
    p.setFont(textFont(13, strong ? 500 : 400));
    p.setPen(strong ? t.ink : t.quiet);
    drawSymbol(p, QRectF(right - 60, middle - 10, 60, 20), Qt::AlignRight, toText(text));
  };
  p.setPen(t.ink);
  p.setFont(textFont(13, chosen ? 500 : 400));
  drawSymbol(p, QRectF(g.label - 50, middle - 10, 50, 20), Qt::AlignRight, actionNameOf(session_.task(), action));

  const double zero = xOf(0, g), x = xOf(q_[action], g);
  p.setPen(Qt::NoPen);
  const auto bar = [&](double value) {
    p.setBrush(QColor::fromRgb(divergingColour(value >= 0 ? 0.5 : -0.5, t.dark)));
    p.drawRect(QRectF(std::min(zero, xOf(value, g)), middle - kBar / 2, std::abs(xOf(value, g) - zero), kBar));
  };
  if (positive_.empty()) {
    bar(q_[action]);
  } else {
    bar(positive_[action]);
    bar(negative_[action]);
  }
  p.setBrush(t.ink);
  p.drawRect(QRectF(x - 1.25, middle - 9, 2.5, 18));
  number(g.qNumber, fixedText(q_[action], std::abs(q_[action]) < 99.95 ? 1 : 0), true);

  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const bool inForce = columns_[i].name == session_.configuration().names.policy;
    const double x0 = g.first + g.pitch * static_cast<double>(i);
    QColor colour = policyLook(columns_[i].name, t).colour;
    if (!inForce) colour.setAlphaF(0.55f);
    p.setPen(Qt::NoPen);
    p.setBrush(colour);
    p.drawRect(QRectF(x0, middle - kBar / 2, g.bar * std::sqrt(columns_[i].pi[action]), kBar));
    const double percent = 100 * columns_[i].pi[action];
    number(x0 + g.number, fixedText(percent, percent >= 0.005 && percent < 0.095 ? 2 : 1), inForce);
  }
}

void ActionRows::drawThreshold(QPainter& p, const Theme& t, const Geometry& g) const {
  if (session_.configuration().names.policy != "trl") return;
  const double x = xOf(session_.threshold(), g);
  QPen pen(t.trl, 2, Qt::CustomDashLine, Qt::FlatCap);
  pen.setDashPattern({3, 2});
  p.setPen(pen);
  p.drawLine(QPointF(x, g.top - 4), QPointF(x, g.bottom));
  const QString beyond = session_.threshold() > high_  ? QStringLiteral(" ›")
                         : session_.threshold() < low_ ? QStringLiteral(" ‹")
                                                       : QString();
  const QString text = tr("threshold %1").arg(toText(countText(session_.threshold()))) + beyond;
  p.setFont(textFont(11, 500));
  const double w = QFontMetricsF(p.font()).horizontalAdvance(text) + 10;
  const QRectF flag(std::clamp(x - w / 2, 64.0, g.qNumber - 16 - w), 9, w, 17);
  p.setPen(Qt::NoPen);
  p.setBrush(t.trlStrong);
  p.drawRoundedRect(flag, 3, 3);
  p.setPen(t.dark ? t.paper : QColor(Qt::white));
  drawSymbol(p, flag, Qt::AlignHCenter, text);
}

bool ActionRows::onThreshold(const QPointF& at) const {
  const Geometry g = geometry();
  return session_.configuration().names.policy == "trl" && levels_.empty() &&
         std::abs(at.x() - xOf(session_.threshold(), g)) < 6 && at.y() > 6 && at.y() < g.bottom;
}

void ActionRows::mousePressEvent(QMouseEvent* event) {
  dragging_ = event->button() == Qt::LeftButton && onThreshold(event->position());
}

void ActionRows::mouseMoveEvent(QMouseEvent* event) {
  setCursor(dragging_ || onThreshold(event->position()) ? Qt::SplitHCursor : Qt::ArrowCursor);
  if (!dragging_) return;
  const Geometry g = geometry();
  const double share = std::clamp((event->position().x() - g.qLeft) / (g.qRight - g.qLeft), 0.0, 1.0);
  const double value = std::round(low_ + share * (high_ - low_));
  if (value != session_.threshold())
    static_cast<void>(static_cast<bool>(session_.setParameter("policy.threshold", value)));
}

void ActionRows::mouseReleaseEvent(QMouseEvent*) {
  dragging_ = false;
}

}  // namespace surefoot
