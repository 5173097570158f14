// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/basics/portable_math.h"
#include "physics/robot/world/checked.h"
#include "physics/robot/world/number_parts.h"

namespace surefoot {

namespace {

/// Heights of steps or bumps: uniform from 0 to `height`, from the ground's own seed.
std::vector<Point> roughGround(const GroundSpec& spec, CheckedNumbers& number) {
  const std::string where = "[ground]";
  const double step = number(spec.length, where, "length", 1e-3, 1e4, "m");
  const double height = number(spec.height, where, "height", 0, 100, "m");
  const double from = number.at(spec.from, where, "from"), to = number.at(spec.to, where, "to");
  const auto seed = static_cast<std::uint64_t>(number(spec.seed, where, "seed", 0, 1e9));
  if (!(from < to)) number.complain(spec.place, "[ground]: from must lie left of to.");
  const double count = (to - from) / step;
  if (!(count >= 1 && count <= 1999)) {
    number.complain(spec.place,
                    fmt::format("[ground]: from, to and length make {:.0f} pieces; allowed is 1 … 1,999.", count));
    return {};
  }
  constexpr double kEnd = 500;  // [m]
  std::vector<Point> line = {{std::min(-kEnd, from - 1), 0}, {from, 0}};
  Random random(seed);
  double last = 0.0;
  for (int i = 1; i <= static_cast<int>(count); ++i) {
    const double x = from + i * step, y = random.uniform(0.0, height);
    if (spec.kind == GroundSpec::Kind::Steps) line.push_back({x - 0.001 * step, last});
    line.push_back({x, y});
    last = y;
  }
  line.push_back({to + step, 0});
  line.push_back({std::max(kEnd, to + step + 1), 0});
  return line;
}

}  // namespace

void laidGround(const GroundSpec& spec, RobotNumbers& numbers, CheckedNumbers& number) {
  numbers.hasGround = spec.kind != GroundSpec::Kind::None;
  numbers.groundFriction = number(spec.friction, "[ground]", "friction", 0, 1000);
  if (spec.kind == GroundSpec::Kind::Steps || spec.kind == GroundSpec::Kind::Bumps)
    numbers.ground = roughGround(spec, number);
  for (const FormulaPair& point : spec.points) numbers.ground.push_back(number.at(point, "[ground]", "points"));
  for (std::size_t i = 1; i < numbers.ground.size(); ++i)
    if (numbers.ground[i].x - numbers.ground[i - 1].x < 1e-6)
      return number.complain(spec.place, "[ground]: its points go from left to right, each right of the last.");
}

}  // namespace surefoot
