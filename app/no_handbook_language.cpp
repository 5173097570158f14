// SPDX-License-Identifier: GPL-3.0-or-later
// In place of handbook_language.cpp where the program is built without Qt.
#include "app/reports/handbook_language.h"

namespace surefoot {

Status inLanguage(const std::string& code, const std::function<Status(const HandbookSpeech& speech)>& make) {
  if (code == "en") return make({});
  return Error{"--language: this program was built without its window (SUREFOOT_UI=OFF), which knows other languages."};
}

}  // namespace surefoot
