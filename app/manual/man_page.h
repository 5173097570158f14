// SPDX-License-Identifier: GPL-3.0-or-later
// A manual page in man(7): headings, paragraphs and lists of terms. Any thread.
#pragma once

#include <string>
#include <string_view>

namespace surefoot {

class ManPage {
 public:
  /// `date`: "2026-11-30". `line`: what it is, without a full stop; it goes behind the name under NAME.
  ManPage(std::string_view name, int section, std::string_view date, std::string_view line);

  void heading(std::string_view title);
  void subheading(std::string_view title);
  void paragraph(std::string_view text);
  /// A command line, of which `bold` is to be typed as it stands and `rest` is to be filled in.
  void synopsis(std::string_view bold, std::string_view rest);
  /// A term and what stands of it. `bold` is to be typed as it stands, `rest` is to be filled in.
  void term(std::string_view bold, std::string_view rest, std::string_view text);
  /// Another line under the last term.
  void below(std::string_view text);

  const std::string& text() const { return text_; }

 private:
  void lines(std::string_view text);
  std::string text_;
};

}  // namespace surefoot
