// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>

#include "ui/language/language.h"

namespace surefoot {

/// The window's language while this lives; windows are made after it. Then English again.
struct Spoken {
  explicit Spoken(const char* code) { useLanguage(*qApp, QString::fromLatin1(code)); }
  ~Spoken() { useLanguage(*qApp, QStringLiteral("en")); }
  Spoken(const Spoken&) = delete;
  Spoken& operator=(const Spoken&) = delete;
};

}  // namespace surefoot
