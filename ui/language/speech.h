// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that the core reads or makes as a whole, in the language of the window: the handbook and the lessons that come
// with the program. What stands in lessons is in resources/languages in the context "lessons", put there by `ninja
// languages`; a person's own lesson is in no list and stays as it is.
#pragma once

#include <string>

#include "core/handbook/handbook.h"

namespace surefoot {

/// For makeHandbook(). Window's thread.
HandbookSpeech handbookInLanguage();

/// For readLessonFile() and lessonsIn(). Window's thread.
std::string lessonInLanguage(const std::string& english);

/// Numbers of a lesson's text as the screen shows them. Any thread.
std::string numbersInLanguage(const std::string& numbers);

}  // namespace surefoot
