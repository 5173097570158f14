// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/limited_toml.h"

#include <fmt/format.h>

namespace surefoot {

namespace {

/// Steps through a text, past comments and strings.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  Status check() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        skipComment();
      } else if (c == '"' || c == '\'') {
        skipString(c);
      } else {
        ++at_;
        if (!count(c)) return tooMuch(c);
      }
    }
    return Done{};
  }

 private:
  /// False: one level or one part of a key too many.
  bool count(char c) {
    if (c == '\n') ++line_;
    if (c == '.') return ++parts_ <= kDeepestToml;
    if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}') parts_ = 1;
    if (c == '[' || c == '{') return ++depth_ <= kDeepestToml;
    if ((c == ']' || c == '}') && depth_ > 0) --depth_;
    return true;
  }
  void skipComment() {
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
  }
  void skipString(char quote) {
    const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
    const bool lines = text_.substr(at_).starts_with(three);
    at_ += lines ? 3 : 1;
    while (at_ < text_.size()) {
      if (lines ? text_.substr(at_).starts_with(three) : text_[at_] == quote || text_[at_] == '\n') {
        at_ += lines ? 3 : text_[at_] == quote ? 1 : 0;
        return;
      }
      if (text_[at_] == '\n') ++line_;
      at_ += text_[at_] == '\\' && quote == '"' ? 2 : 1;
    }
  }
  Status tooMuch(char c) const {
    return Error{c == '.'
                     ? fmt::format("line {}: a key of more than {} parts is none of ours", line_, kDeepestToml)
                     : fmt::format("line {}: brackets nested deeper than {} are none of ours", line_, kDeepestToml),
                 ErrorKind::File};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1, depth_ = 0, parts_ = 1;
};

}  // namespace

Status checkTomlLimits(std::string_view text) {
  if (text.size() > kLongestToml)
    return Error{fmt::format("a text of more than {} MB is none of ours", kLongestToml >> 20), ErrorKind::File};
  return Scanner(text).check();
}

}  // namespace surefoot
