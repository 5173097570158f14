// SPDX-License-Identifier: GPL-3.0-or-later
// A small picture of a lesson: its environment, drawn by the strokes of the world.
#pragma once

#include <QPainter>

#include "core/lessons/lesson.h"
#include "ui/style/theme.h"

namespace surefoot {

void drawLessonPicture(QPainter& painter, const QRectF& where, const Registry& registry, const Lesson& lesson,
                       const Theme& theme);

}  // namespace surefoot
