// SPDX-License-Identifier: GPL-3.0-or-later
// Colour and marker of a policy, the same everywhere. A policy without a line in the table of policy_look.cpp gets one
// of the looks that are left, by its name.
#pragma once

#include <QColor>
#include <string_view>

class QPainter;
class QPointF;

namespace surefoot {

struct Theme;

enum class Marker { Circle, Triangle, Square, Diamond, Pentagon, Cross };

struct PolicyLook {
  QColor colour;
  Marker marker;
};

/// Of no policy (an empty name) as of greedy.
PolicyLook policyLook(std::string_view policy, const Theme& theme);

/// A policy's mark, 8 px wide, at the text scale; filled where it is in force.
void drawMarker(QPainter& painter, QPointF centre, const PolicyLook& look, bool filled);

}  // namespace surefoot
