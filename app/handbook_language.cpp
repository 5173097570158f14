// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reports/handbook_language.h"

#include "app/headless_qt.h"
#include "ui/language/speech.h"

namespace surefoot {

Status inLanguage(const std::string& code, const std::function<Status(const HandbookSpeech& speech)>& make) {
  if (code == "en") return make({});
  const HeadlessQt qt;
  useLanguage(*qApp, QString::fromStdString(code));
  return make(handbookInLanguage());
}

}  // namespace surefoot
