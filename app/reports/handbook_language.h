// SPDX-License-Identifier: GPL-3.0-or-later
// The handbook's other languages, if the program was built with its window, whose texts they are.
#pragma once

#include <functional>
#include <string>

#include "core/basics/result.h"
#include "core/handbook/handbook_speech.h"

namespace surefoot {

/// Makes something of the handbook's speech in a language ("en", "nl", "de"), which is there while `make` runs.
Status inLanguage(const std::string& code, const std::function<Status(const HandbookSpeech& speech)>& make);

}  // namespace surefoot
