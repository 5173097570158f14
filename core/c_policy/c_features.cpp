// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/c_policy/c_features.h"

#include <fmt/format.h>

#include "core/basics/random.h"
#include "core/c_policy/c_text.h"

namespace surefoot {

namespace {

double numberIn(const Json& v, const char* key, double otherwise = 0.0) {
  return v.contains(key) && v[key].is_number() ? v[key].get<double>() : otherwise;
}

/// tile[i] ← the number of the tile of tiling i (core/features/tile_grid.h), or 0 is returned: nothing is on.
std::string tilesInC(const std::string& name, const Json& layout) {
  const int tilings = layout["tilings"];
  std::string text = fmt::format(
      "static int {0}_tiles(const double s[], uint64_t tile[]) {{\n"
      "  uint64_t i, position, stride = {1}u;\n  double step;\n"
      "  for (i = 0; i < {1}u; ++i) tile[i] = i;\n",
      name, tilings);
  for (std::size_t d = 0; d < layout["variables"].size(); ++d) {
    const Json& v = layout["variables"][d];
    const auto tiles = static_cast<std::uint64_t>(numberIn(v, "tiles"));
    text += fmt::format("  /* {} */\n", commentInC(v.value("variable", "")));
    for (const auto& [key, op] : {std::pair{"nothing_below", ">="}, {"nothing_above", "<="}})
      if (v.contains(key) && v[key].is_number())
        text += fmt::format("  if (!(s[{}] {} {})) return 0;\n", d, op, inC(v[key].get<double>()));
    text += fmt::format("  step = whole(s[{}] * {});\n", d, inC(numberIn(v, "steps_per_unit", 1.0)));
    const bool wraps = v.value("wraps", false);
    if (wraps) {
      const std::string cycle = inC(static_cast<double>(tiles * static_cast<std::uint64_t>(tilings)));
      text += fmt::format(
          "  if (!is_finite(step)) step = 0.0;\n  step -= whole(step / {0}) * {0};\n"
          "  position = (uint64_t)step;\n",
          cycle);
    } else {
      text += fmt::format(
          "  if (!(step >= {0})) step = {0};\n  if (step > {1}) step = {1};\n"
          "  position = (uint64_t)(step - {2});\n",
          inC(numberIn(v, "first_step")), inC(numberIn(v, "last_step")), inC(numberIn(v, "origin_step")));
    }
    text += fmt::format(
        "  for (i = 0; i < {0}u; ++i) tile[i] += (position + i * {1}u % {0}u) / {0}u{2} * stride;\n"
        "  stride *= {3}u;\n",
        tilings, static_cast<int>(numberIn(v, "displacement", 1.0)), wraps ? fmt::format(" % {}u", tiles) : "", tiles);
  }
  return text + "  (void)stride;\n  return 1;\n}\n";
}

/// A dense table: the number of the tile is the feature.
std::string denseInC(const std::string& name, int tilings) {
  return fmt::format(
      "static int {0}_features(const double s[], uint32_t x[], double value[]) {{\n"
      "  uint64_t tile[{1}];\n  int i;\n  (void)value;\n  if (!{0}_tiles(s, tile)) return 0;\n"
      "  for (i = 0; i < {1}; ++i) x[i] = (uint32_t)tile[i];\n  return {1};\n}}\n",
      name, tilings);
}

constexpr int kMostProbes = 64;  // HashedTileCoder::kMostProbes
constexpr std::uint64_t kFree = 0xffffffffu;

std::uint64_t homeOf(std::uint64_t tile, std::uint64_t slots) {
  return mix64(tile + 0x9e3779b97f4a7c15ULL) % slots;
}

/// [slot] the feature, as HashedTileCoder::setTiles fills them.
std::vector<std::uint64_t> slotsOf(std::span<const std::uint64_t> tiles, std::uint64_t memory) {
  std::vector<std::uint64_t> slots(memory, kFree);
  for (std::size_t feature = 0; feature < tiles.size(); ++feature) {
    std::uint64_t slot = homeOf(tiles[feature], memory);
    while (slots[slot] != kFree) slot = slot + 1 == memory ? 0 : slot + 1;
    slots[slot] = feature;
  }
  return slots;
}

/// A hashed table (core/features/hashed_tile_coder.h), as it lies. Tiles that were never visited get the numbers that
/// they would get.
std::string hashedInC(const std::string& name, int tilings, std::uint64_t memory,
                      std::span<const std::uint64_t> tiles) {
  std::string text = arrayInC("uint32_t", name + "_slot", std::span<const std::uint64_t>(slotsOf(tiles, memory)));
  text += arrayInC("uint64_t", name + "_tile", tiles);
  return text + fmt::format(R"(static int {0}_features(const double s[], uint32_t x[], double value[]) {{
  uint64_t tile[{1}];
  uint32_t next = {2}u;
  int i, probe;
  (void)value;
  if (!{0}_tiles(s, tile)) return 0;
  for (i = 0; i < {1}; ++i) {{
    const uint64_t home = mixed(tile[i] + 0x9e3779b97f4a7c15u) % {3}u;
    uint64_t slot = home;
    uint32_t feature = {0}_slot[home];
    for (probe = 0; probe < {4}; ++probe) {{
      const uint32_t here = {0}_slot[slot];
      if (here == 0xffffffffu || {0}_tile[here] == tile[i]) {{
        feature = here;
        break;
      }}
      if (++slot == {3}u) slot = 0;
    }}
    x[i] = feature;
    if (feature == 0xffffffffu) {{
      x[i] = next < {3}u - 1u ? next : {3}u - 1u;
      ++next;
    }}
  }}
  return {1};
}}
)",
                            name, tilings, tiles.size(), memory, kMostProbes);
}

/// A table of states of whole numbers (core/features/table.h).
std::string tableInC(const std::string& name, const Json& layout) {
  std::string text = fmt::format(
      "static int {0}_features(const double s[], uint32_t x[], double value[]) {{\n"
      "  double at;\n  (void)value;\n  x[0] = 0;\n",
      name);
  double stride = 1.0;
  for (std::size_t d = 0; d < layout["variables"].size(); ++d) {
    const Json& v = layout["variables"][d];
    const double low = numberIn(v, "lowest"), high = numberIn(v, "highest");
    text += fmt::format(
        "  at = nearest(s[{0}]); /* {1} */\n  if (!(at >= {2})) at = {2};\n  if (at > {3}) at = {3};\n"
        "  x[0] += (uint32_t)(at - {2}) * {4}u;\n",
        d, commentInC(v.value("variable", "")), inC(low), inC(high), static_cast<std::uint64_t>(stride));
    stride *= high - low + 1;
  }
  return text + "  return 1;\n}\n";
}

/// Normalised Gaussians (core/features/radial_basis.h).
std::string radialInC(const std::string& name, const Json& layout, int& most) {
  std::string body;
  double stride = 1.0;
  int active = 1, widest = 1;
  for (std::size_t d = 0; d < layout["variables"].size(); ++d) {
    const Json& v = layout["variables"][d];
    const int block = v.value("block", 1);
    const double centres = numberIn(v, "centres", 1.0);
    body += fmt::format(
        "  count = {}_gaussians(s[{}], {}, {}, {}, {}, {}, {}, {}, {}, {}u, count, x, value); /* {} */\n", name, d,
        inC(numberIn(v, "first_centre")), inC(numberIn(v, "spacing", 1.0)), inC(numberIn(v, "width", 1.0)),
        inC(numberIn(v, "lowest")), inC(numberIn(v, "highest")), inC(centres), block, v.value("wraps", false) ? 1 : 0,
        static_cast<std::uint64_t>(stride), commentInC(v.value("variable", "")));
    stride *= centres;
    active *= block;
    widest = std::max(widest, block);
  }
  most = active;
  return fmt::format(
      R"(static int {1}_gaussians(double s, double first, double spacing, double width, double low, double high,
                        double centres, int block, int wraps, uint32_t stride, int count, uint32_t x[],
                        double value[]) {{
  double g[{0}], sum = 0.0, closest, begin;
  uint32_t offset[{0}];
  int k, j;
  if (!wraps || !is_finite(s)) {{
    if (!(s >= low)) s = low;
    if (s > high) s = high;
  }}
  closest = nearest((s - first) / spacing);
  begin = closest - (block - 1) / 2;
  if (!wraps && begin > centres - block) begin = centres - block;
  if (!wraps && begin < 0.0) begin = 0.0;
  for (k = 0; k < block; ++k) {{
    const double t = (s - (first + (begin + k) * spacing)) / width;
    const double number = begin + k - whole((begin + k) / centres) * centres;
    sum += g[k] = exponential(-0.5 * t * t);
    offset[k] = (uint32_t)number * stride;
  }}
  if (!(sum > 0.0)) {{
    double at = closest - begin;
    if (at < 0.0) at = 0.0;
    if (at > block - 1.0) at = block - 1.0;
    g[(int)at] = sum = 1.0;
  }}
  for (k = block - 1; k >= 0; --k) {{
    const double share = g[k] / sum;
    for (j = 0; j < count; ++j) {{
      value[k * count + j] = value[j] * share;
      x[k * count + j] = x[j] + offset[k];
    }}
  }}
  return count * block;
}}
static int {1}_features(const double s[], uint32_t x[], double value[]) {{
  int count = 1;
  x[0] = 0;
  value[0] = 1.0;
{2}  return count;
}}
)",
      widest, name, body);
}

}  // namespace

namespace {

struct Helper {
  const char *name, *text;
};

constexpr Helper kHelpers[] = {
    {"is_finite(", R"(static int is_finite(double x) { return x - x == 0.0; }
)"},
    {"whole(", R"(/* The greatest whole number that is not above x. */
static double whole(double x) {
  if (x > -4503599627370496.0 && x < 4503599627370496.0) {
    const double cut = (double)(int64_t)x;
    return cut > x ? cut - 1.0 : cut;
  }
  return x;
}
)"},
    {"nearest(", R"(/* The nearest whole number; halves go away from 0. */
static double nearest(double x) {
  if (x > -4503599627370496.0 && x < 4503599627370496.0) {
    const double cut = (double)(int64_t)x;
    if (x - cut >= 0.5) return cut + 1.0;
    return x - cut <= -0.5 ? cut - 1.0 : cut;
  }
  return x;
}
)"},
    {"exponential(", R"(/* e to the x, for x <= 0: x = k ln 2 + r, the Taylor polynomial for r, times 2 to the k. */
static double exponential(double x) {
  static const double inverse_factorial[14] = {
      1.0 / 6227020800.0, 1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0,
      1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0};
  double r, k, sum = 0.0, factor = 1.0;
  int i, power;
  if (x != x) return x;
  if (x < -745.2) return 0.0;
  power = (int)(x * 1.4426950408889634074 + (x < 0.0 ? -0.5 : 0.5));
  k = power;
  r = (x - k * 6.93147180369123816490e-01) - k * 1.90821492927058770002e-10;
  for (i = 0; i < 14; ++i) sum = sum * r + inverse_factorial[i];
  for (; power < 0; ++power) factor *= 0.5;
  return sum * factor;
}
)"},
    {"mixed(", R"(/* SplitMix64's output function (Steele, Lea & Flood 2014). */
static uint64_t mixed(uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}
)"}};

}  // namespace

std::string helpersInC(const std::string& text) {
  std::string helpers;
  for (const Helper& helper : kHelpers)
    if (text.find(helper.name) != text.npos) helpers += helper.text;
  return helpers;
}

Result<CFeatures> featuresInC(const std::string& name, const Json& layout, std::span<const std::uint64_t> tiles) {
  const std::string kind = layout.is_object() ? layout.value("kind", "") : "";
  CFeatures f;
  if (kind == "tile-coder" || kind == "hashed-tile-coder") {
    f.most = layout["tilings"];
    f.text = tilesInC(name, layout);
    const auto memory = static_cast<std::uint64_t>(numberIn(layout, "memory"));
    f.text += memory > 0 ? hashedInC(name, f.most, memory, tiles) : denseInC(name, f.most);
    f.tableBytes = 4.0 * static_cast<double>(memory) + 8.0 * static_cast<double>(tiles.size());
  } else if (kind == "table") {
    f.text = tableInC(name, layout);
  } else if (kind == "radial-basis") {
    f.binary = false;
    f.text = radialInC(name, layout, f.most);
  } else {
    return Error{"features of the kind \"" + kind + "\" cannot be written in C."};
  }
  return f;
}

}  // namespace surefoot
