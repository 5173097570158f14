// SPDX-License-Identifier: GPL-3.0-or-later
// What the window draws around the picture of the world.
#include <algorithm>

#include "ui/controls/preferences.h"
#include "ui/language/from_core.h"
#include "ui/live/world/world_view.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/running/task_words.h"
#include "ui/style/policy_look.h"
#include "ui/style/scene_painter.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/keyboard.h"

namespace surefoot {

namespace {
constexpr double kCaption = 26;  // [px] with two worlds: the caption with this world's policy and agent
}  // namespace

void WorldView::measure() {
  if (picture_.plain)
    picture_.readOuts.clear();
  else
    picture_.readOuts = life_.environment().readOuts(looking_.shown().pose);
  const bool both = beside_ && beside_->isVisible() && beside_->picture_.measured();
  picture_.measure(size(), captionHeight(), both ? &beside_->picture_ : nullptr);
}

double WorldView::captionHeight() const {
  return beside_ && beside_->isVisible() ? kCaption * textScale() : 0;
}

void WorldView::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.fillRect(rect(), t.paper);
  if (picture_.scene.shapes.empty()) return;
  measure();
  p.setRenderHint(QPainter::Antialiasing);
  p.save();  // at any zoom, the read-outs stay free
  p.setClipRect(picture_.room());
  picture_.paintGround(p, t, !reducedMotion());
  drawGhost(p, t);
  picture_.paintBody(p, t, looking_.shown().flash && !reducedMotion());
  drawSpring(p, t);
  p.restore();
  picture_.paintReadOuts(p, t);
  drawCaption(p, t);
  if (picture_.plain && looking_.playback()) drawChoice(p, t);
  if (ring_) drawFocusRing(p, *this);
}

// The body as it would stand in the state under the cursor on a map.
void WorldView::drawGhost(QPainter& p, const Theme& t) const {
  const std::vector<double>& state = looking_.examined();
  if (state.size() != life_.task().state.size()) return;
  const auto pose = life_.environment().poseAt(state);
  if (pose.empty()) return;
  Scene ghost;
  life_.environment().draw(pose, ghost);
  p.setOpacity(0.28);
  const double dx = picture_.scene.focus.x - ghost.focus.x;  // the ghost stands where the body stands
  ScenePainter painter(
      p, t, false,
      [&](Point at) {
        return picture_.toPixel({at.x + dx, at.y});
      },
      picture_.pixelsPerMetre());
  painter.setStrokes(picture_.strokes());
  for (const Shape& shape : ghost.shapes)
    if (!std::holds_alternative<Label>(shape)) std::visit(painter, shape);
  p.setOpacity(1.0);
}

void WorldView::drawSpring(QPainter& p, const Theme& t) const {
  if (!hand_) return;
  p.setPen(QPen(t.accent, 1.5, Qt::DashLine));
  p.drawLine(picture_.toPixel(picture_.scene.tip), *hand_);
  p.setBrush(t.accent);
  p.setPen(Qt::NoPen);
  p.drawEllipse(*hand_, 4, 4);
}

/// With two worlds, the caption says which one this is, and shows its policy and agent.
void WorldView::drawCaption(QPainter& p, const Theme& t) const {
  if (captionHeight() == 0) return;
  const double k = textScale(), baseline = 18 * k;
  const Names& names = life_.configuration().names;
  const auto& registry = life_.registry();
  const auto title = [](const auto& entry, const std::string& name) {
    return fromCore(entry ? (*entry)->title : name);
  };
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  double x = 12;
  drawSymbol(p, x, baseline, which_);
  x += symbolWidth(p.font(), which_) + 14 * k;
  drawMarker(p, {x, baseline - 4.5 * k}, policyLook(names.policy, t), true);
  p.setFont(textFont(13));
  drawSymbol(p, x + 9 * k, baseline,
             title(findEntry(registry.policies, "policy", names.policy), names.policy) + QStringLiteral(", ") +
                 title(findEntry(registry.agents, "agent", names.agent), names.agent));
}

/// In a replay: whether the action that is carried out now was the best by what the robot knew then.
void WorldView::drawChoice(QPainter& p, const Theme& t) const {
  const Shown* chosen = looking_.whenChosen();
  const Task& task = life_.task();
  if (!chosen || !chosen->explores || chosen->action < 0) return;
  const auto action = static_cast<std::size_t>(chosen->action);
  if (action >= task.actions.size()) return;
  QString words = *chosen->explores ? tr("taken at random") : tr("taken as the best");
  // A combination of several is too long to be read here; its parts are drawn at the joints.
  const bool isNumber = task.actionVariables.empty() && task.actionNames.empty();
  if (task.actionVariables.empty()) words += QStringLiteral(": ") + actionNameOf(task, action);
  if (isNumber) words += ' ' + toText(task.actionUnit);
  p.setFont(textFont(13, 500));
  p.setPen(*chosen->explores ? t.fallText : t.ink);
  drawSymbol(p, 12, height() - 12, words);
}

}  // namespace surefoot
