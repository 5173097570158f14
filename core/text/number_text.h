// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that a person types: one rule for the command line, forms, dialogs, plans and lists, independent of the
// locale. The program reads all numbers that it prints: "−1.5", "1,000", "1e-06", "4.5e−04", "2 · 10⁻⁶", "9 min" where
// the unit is known.
//
// - The decimal point is a point; a comma separates thousands, and then stands before every three digits: 1,234.5.
// - A number with two possible meanings is refused, and both readings are named: "1,5" (1.5 or 15), "1.000,5".
// - Values of a list are separated by ; or blanks. Commas are allowed, too, where none of them can separate thousands:
//   "0.1,0,0" is a list, "1,000" is refused (1000, or 1 and 0).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

/// A number of a text: its value, or how else it can be read, or neither.
struct NumberText {
  bool good = false;
  double value = 0.0;
  std::string plain;                  ///< a good number: sign, digits, point, exponent and nothing else
  std::vector<std::string> readings;  ///< an ambiguous number: its readings, each written unambiguously
};

/// Reads one number, finite, with nothing before it, not even a blank, and nothing behind it but its unit.
NumberText readNumberText(std::string_view text, std::string_view unit = {});

/// The same; the error is a sentence with the name, the text, and the readings if there are several.
Result<double> parseNumber(std::string_view name, std::string_view text);

/// A whole number in a range, exact up to 2⁶⁴ − 1: digits, and commas of thousands.
Result<std::uint64_t> parseWhole(std::string_view name, std::string_view text, std::uint64_t low, std::uint64_t high);

/// A master seed from text: a whole number from 0 to 2⁶⁴ − 1.
Result<std::uint64_t> parseSeed(std::string_view name, std::string_view text);

/// The values of a list, each still as text.
Result<std::vector<std::string>> splitList(std::string_view name, std::string_view text);

/// A list of numbers; the error names which of them is none.
Result<std::vector<double>> parseNumbers(std::string_view name, std::string_view text);

/// "can be read as 1.5 or as 15; write the one that is meant".
std::string readingsText(const NumberText& number);

/// Ordinary minus signs and blanks, and no blanks at the ends.
std::string plainSigns(std::string_view text);

/// A bound of a range for a person: "−1,000,000", "0.000001", "10⁻⁹".
std::string boundText(double value);

}  // namespace surefoot
