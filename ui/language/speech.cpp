// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language/speech.h"

#include <QCoreApplication>

#include "ui/language/from_core.h"
#include "ui/language/language.h"
#include "ui/language/numbers.h"

namespace surefoot {

HandbookSpeech handbookInLanguage() {
  return {.code = languageInUse().toStdString(),
          .declared = [](const std::string& text) { return fromCore(text).toStdString(); },
          .formula = [](const std::string& text) { return fromCore(text).toStdString(); },
          .source = [](const std::string& text) { return sourceText(text).toStdString(); },
          .number = numbersInLanguage};
}

std::string lessonInLanguage(const std::string& english) {
  return QCoreApplication::translate("lessons", english.c_str()).toStdString();
}

std::string numbersInLanguage(const std::string& numbers) {
  return localNumbers(numbers).toStdString();
}

}  // namespace surefoot
