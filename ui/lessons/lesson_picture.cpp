// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_picture.h"

#include <algorithm>

#include "core/basics/random.h"
#include "core/scene.h"
#include "ui/style/scene_painter.h"

namespace surefoot {

void drawLessonPicture(QPainter& p, const QRectF& where, const Registry& registry, const Lesson& lesson,
                       const Theme& t) {
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.setClipRect(where);
  p.fillRect(where, t.paper);
  const auto environment = makeEnvironment(registry, lesson.start);
  if (environment) {
    Random random(1);
    (*environment)->reset(random);
    Scene scene;
    (*environment)->draw((*environment)->pose(), scene);
    if (where.height() < 60)
      std::erase_if(scene.shapes, [](const Shape& s) { return std::holds_alternative<Label>(s); });
    const double above = scene.height, width = std::max(scene.width, 1.2 * above);
    const double scale = std::min(0.84 * where.height() / above, 0.9 * where.width() / width);
    const double floor = where.center().y() + above * scale / 2;
    const auto toPixel = [&](Point at) {
      return QPointF(where.center().x() + (at.x - scene.focus.x) * scale, floor - at.y * scale);
    };
    ScenePainter painter(p, t, false, toPixel, scale);
    painter.setStrokes(std::clamp(above * scale / 240, 0.3, 1.0));
    painter.setBounds(where);
    paintScene(scene, painter);
    if (scene.metres) {
      p.setPen(QPen(t.ink, where.height() < 60 ? 1 : 1.5));
      p.drawLine(QPointF(where.left(), floor), QPointF(where.right(), floor));
    }
  }
  p.restore();
}

}  // namespace surefoot
