// SPDX-License-Identifier: GPL-3.0-or-later
// The language of a handbook. Written pages are taken from the folder of that language; what is made from declarations
// goes through these functions. Without them it is English.
#pragma once

#include <fmt/format.h>

#include "core/text/translate.h"

namespace surefoot {

struct HandbookSpeech {
  std::string code = "en";  ///< FOLDER/de/01-first-steps.md stands for FOLDER/01-first-steps.md, where it is there
  Translate declared{};     ///< titles, helps, meanings, and the sentences of the made pages, with {0}, {1} for parts
  Translate formula{};      ///< formulas, in which there may be words
  Translate source{};       ///< "thesis, section 4.1"
  Translate number{};       ///< "1,234.5"

  std::string say(const std::string& text) const { return translated(declared, text); }
  /// A sentence with its parts, which are ready to be shown.
  template <class... Parts>
  std::string say(const std::string& sentence, const Parts&... parts) const {
    return fmt::format(fmt::runtime(translated(declared, sentence)), parts...);
  }
};

}  // namespace surefoot
