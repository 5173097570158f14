// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with what they count: "1 episode", "12,345 episodes".
#pragma once

#include <QObject>

#include "core/text/text.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

/// One of the two texts, with the number for its %1.
inline QString counted(std::int64_t number, const QString& one, const QString& many) {
  return (number == 1 ? one : many).arg(toText(countText(static_cast<double>(number))));
}

inline QString episodesText(std::int64_t number) {
  return counted(number, QObject::tr("%1 episode"), QObject::tr("%1 episodes"));
}

inline QString livesText(std::int64_t number) {
  return counted(number, QObject::tr("%1 life"), QObject::tr("%1 lives"));
}

inline QString fallsText(std::int64_t number) {
  return counted(number, QObject::tr("%1 fall"), QObject::tr("%1 falls"));
}

}  // namespace surefoot
