// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that the core declares (titles, helps, meanings, names of values) in the language of the window. The core knows
// no Qt and writes English; what it declares stands in resources/languages in the context "core", put there by
// `ninja languages`. A text that is not there, as those of a person's own robot, is shown as it is.
#pragma once

#include <QString>
#include <string>

#include "core/parameters.h"

namespace surefoot {

/// A declared text. One that is composed is translated by its parts: "Q⁺ Pole angle, from".
QString fromCore(const std::string& text);

/// Where something comes from: "thesis, section 4.1; Sutton & Barto 2018, section 2.2" with the language's words.
QString sourceText(const std::string& source);

/// "a number from 0 to 1": allowedValues() (core/parameters.h) with names and numbers of the language.
QString allowedText(const Parameter& parameter);

/// A value of a parameter as the screen shows it: a number, or the name of a choice.
QString valueText(const Parameter& parameter, double value);

}  // namespace surefoot
