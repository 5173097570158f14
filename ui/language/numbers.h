// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as the screen shows them, in the language of the window. The core writes "1,234.5"; in Dutch and German that
// is "1 234,5", with a narrow blank: their point between thousands could be taken for that of a file. What is written
// to files never passes here.
#pragma once

#include <QString>
#include <string>

namespace surefoot {

/// Whether numbers have a comma where the core writes a point. Set once, with the language.
void setDecimalComma(bool comma);
bool decimalComma();

/// A text of the core with all of its numbers as the language writes them: "−45.0 (−55.1 … −32.0)".
QString localNumbers(QString text);
QString localNumbers(const std::string& text);

/// fixedText() and countText() (core/text/text.h) as the language writes them.
QString fixedNumber(double value, int decimals);
QString countNumber(double value);

/// What a person typed, as the core reads it. In a language with a decimal comma, a point is one, too: "0,5" and "0.5"
/// are the same. "1.250" could be meant as 1250; the core is given a text that it refuses and names both readings.
std::string typedNumber(const QString& text);

/// The same for a list, whose values are separated by ; or blanks, and for a range: "0..0,2:9".
std::string typedNumbers(const QString& text);

}  // namespace surefoot
