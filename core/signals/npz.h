// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays for NumPy: a zip archive of .npy files, version 1.0 (https://numpy.org/doc/stable/reference/generated/
// numpy.lib.format.html), as numpy.load reads it.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

/// A one-dimensional array of doubles as a .npy file.
std::string npyOf(std::span<const double> values);

struct NamedArray {
  std::string name;
  std::span<const double> values;
};

/// The bytes of an archive with an array for each name.
Result<std::string> npzOf(std::span<const NamedArray> arrays);

}  // namespace surefoot
