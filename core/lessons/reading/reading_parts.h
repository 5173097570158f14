// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a lesson's file that several steps and questions have: conditions, texts with numbers, amounts, actions.
#pragma once

#include "core/environment.h"
#include "core/lessons/lesson.h"
#include "core/text/translate.h"

namespace surefoot {

class ReadingParts {
 public:
  ReadingParts(const Registry& registry, const Lesson& lesson, const Task& task, LessonWords& words,
               std::vector<Complaint>& complaints, const Translate& translate)
      : registry_(registry),
        lesson_(lesson),
        task_(task),
        words_(words),
        complaints_(complaints),
        translate_(translate) {}

  /// Texts of the file in the reader's language; "" and nothing where there are none.
  std::string said(TomlReader& reader, std::string_view key) { return translated(translate_, reader.text(key)); }
  std::string neededSaid(TomlReader& reader, std::string_view key);
  std::vector<std::string> allSaid(TomlReader& reader, std::string_view key);

  /// The text of a condition or of a number, compiled; complaints have their place in the file.
  std::optional<LessonCondition> condition(TomlReader& reader, const TomlNode& table, std::string_view key,
                                           ValueKind wanted);
  std::vector<LessonCondition> conditions(TomlReader& reader, const TomlNode& table, std::string_view key);
  /// Markdown without pictures and HTML, with numbers in braces, of at most kMostWords words in English.
  LessonText text(TomlReader& reader, const TomlNode& table, std::string_view key);
  std::optional<LessonAmount> amount(TomlReader& reader, std::string_view key);
  LessonActions actions(TomlReader& reader, std::string_view key);

  LessonWords& words() { return words_; }
  std::vector<Complaint>& complaints() { return complaints_; }

 private:
  std::optional<LessonCondition> compiled(const std::string& text, TextPlace at, std::string_view key,
                                          ValueKind wanted);
  void action(const TomlNode& table, LessonActions& all);
  LessonAction setting(TomlReader& reader, const std::string& text);
  void checkName(TomlReader& reader, const std::string& key, const std::string& name);

  const Registry& registry_;
  const Lesson& lesson_;
  const Task& task_;
  LessonWords& words_;
  std::vector<Complaint>& complaints_;
  const Translate& translate_;
};

}  // namespace surefoot
