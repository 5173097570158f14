// SPDX-License-Identifier: GPL-3.0-or-later
// What pages that are made from declarations have in common: text in a language, as Markdown.
#pragma once

#include "core/handbook/handbook_speech.h"
#include "core/parameters.h"

namespace surefoot {

/// Text in which no letter means anything to Markdown.
std::string plain(std::string_view text);

class PageWriter {
 public:
  explicit PageWriter(const HandbookSpeech& speech) : speech_(speech) {}

  /// A declared text in the language of the handbook.
  std::string said(const std::string& text) const { return plain(speech_.say(text)); }
  std::string heading(const std::string& text) const { return fmt::format("## {}\n\n", said(text)); }
  /// "a, b or c", each in the language.
  std::string list(const std::vector<std::string>& texts, const std::string& last) const;
  /// The least or the most that something can be.
  std::string bound(double value) const;
  /// What the glossary says of a method or a world, with the equation set apart; "": nothing.
  std::string meaning(std::string_view name) const;
  /// A heading, an anchor and a paragraph a parameter.
  std::string paragraph(const Parameters::Entry& entry) const;
  const HandbookSpeech& speech() const { return speech_; }

 private:
  const HandbookSpeech& speech_;
};

}  // namespace surefoot
