// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace surefoot {

namespace {

constexpr std::array<QRgb, 9> kLight = {0x7F2A00, 0xB84A00, 0xE27A2E, 0xF6BD92, 0xF7F6F3,
                                        0xB9D4E8, 0x6AA5D0, 0x2470AE, 0x0A3A6B};
constexpr std::array<QRgb, 9> kDark = {0xFFD3B3, 0xF79A5E, 0xD5641C, 0x7A3A14, 0x262A30,
                                       0x1F4A6E, 0x2F7FB8, 0x6FB9EA, 0xD2ECFF};
constexpr std::array<QRgb, 9> kViridis = {0x440154, 0x472D7B, 0x3B528B, 0x2C728E, 0x21918C,
                                          0x28AE80, 0x5EC962, 0xADDC30, 0xFDE725};

QRgb interpolate(const std::array<QRgb, 9>& stops, double position) {
  const double p = std::clamp(position, 0.0, 1.0) * 8.0;
  const auto i = std::min<std::size_t>(static_cast<std::size_t>(p), 7);
  const double t = p - static_cast<double>(i);
  const auto mix = [&](int (*channel)(QRgb)) {
    return static_cast<int>(std::lround((1 - t) * channel(stops[i]) + t * channel(stops[i + 1])));
  };
  return qRgb(mix(qRed), mix(qGreen), mix(qBlue));
}

}  // namespace

QRgb divergingColour(double value, bool dark) {
  return interpolate(dark ? kDark : kLight, (value + 1.0) / 2.0);
}
QRgb viridisColour(double value) {
  return interpolate(kViridis, value);
}

}  // namespace surefoot
