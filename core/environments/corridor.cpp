// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/corridor.h"

#include <string>

namespace surefoot {

void Corridor::draw(Scene& scene, double position, const char* leftEnd, const char* rightEnd) const {
  const double left = endsOutside ? first - 1 : first, right = endsOutside ? last + 1 : last;
  scene.clear();
  scene.focus = {(left + right) / 2, 0};
  scene.height = (right - left) / 4;
  scene.width = right - left + 2;
  scene.metres = false;
  const double floor = scene.height / 3;
  for (double x = left; x <= right; ++x)
    scene.shapes.push_back(
        Polygon{.points = {{x - 0.5, floor}, {x + 0.5, floor}, {x + 0.5, floor + 1}, {x - 0.5, floor + 1}},
                .fill = x < first || x > last ? Fill::Wash : Fill::None,
                .ink = Ink::Outline,
                .width = 1});
  scene.shapes.push_back(Label{{left, floor}, leftEnd, 0, 14, 0, Ink::Quiet});
  scene.shapes.push_back(Label{{right, floor}, rightEnd, 0, 14, 0, Ink::Quiet});
  for (int state = first; state <= last; ++state)
    scene.shapes.push_back(
        Label{{static_cast<double>(state), floor + 1}, std::to_string(state), 0, -10, 0, Ink::Quiet});
  scene.tip = {position, floor + 0.5};
  scene.shapes.push_back(Disc{scene.tip, 0.3, Fill::Solid, Ink::Body, 2});
}

}  // namespace surefoot
