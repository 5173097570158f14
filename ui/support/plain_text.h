// SPDX-License-Identifier: GPL-3.0-or-later
// Texts from outside (names of files and conditions, titles of plans, error texts) in widgets that would take them for
// HTML or mnemonics. Labels are plain anyway (FlatStyle::polish); tooltips and menus go through here.
#pragma once

#include <QString>
#include <QStringList>

#include "core/glossary.h"
#include "core/parameters.h"

namespace surefoot {

/// The text as a tooltip shows it: to the letter, in lines that are not too long.
QString tipText(const QString& text);

/// The text of a menu's entry: "a&b" has no mnemonic.
QString menuText(QString text);

/// A parameter in lines: name, symbol, unit, range, formula and a sentence.
QStringList linesOf(const Parameter& parameter);

/// A word of the glossary in lines; its title stands first.
QStringList linesOf(const Word& word);

/// The tooltip of a choice by its name; `help` if the glossary has no word for it.
QString tipOf(const std::string& name, const std::string& help);

}  // namespace surefoot
