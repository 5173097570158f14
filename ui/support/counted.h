// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with what they count: "1 episode", "12,345 episodes". The source has the plural; the singular stands with the
// languages, that of English, too (resources/languages).
#pragma once

#include <QObject>
#include <algorithm>
#include <limits>

#include "ui/language/numbers.h"

namespace surefoot {

/// The number by which tr() chooses a form.
inline int forms(std::int64_t number) {
  return static_cast<int>(std::clamp<std::int64_t>(number, 0, std::numeric_limits<int>::max()));
}

/// A text that tr() chose, with the number for its %1.
inline QString counted(std::int64_t number, const QString& text) {
  return text.arg(countNumber(static_cast<double>(number)));
}

inline QString episodesText(std::int64_t number) {
  return counted(number, QObject::tr("%1 episodes", nullptr, forms(number)));
}

inline QString livesText(std::int64_t number) {
  return counted(number, QObject::tr("%1 lives", nullptr, forms(number)));
}

inline QString fallsText(std::int64_t number) {
  return counted(number, QObject::tr("%1 falls", nullptr, forms(number)));
}

inline QString stepsText(std::int64_t number) {
  return counted(number, QObject::tr("%1 steps", nullptr, forms(number)));
}

}  // namespace surefoot
