// SPDX-License-Identifier: GPL-3.0-or-later
// The words of an expression, one after the other.
#pragma once

#include <string>
#include <string_view>

namespace surefoot {

/// Thrown inside compile() only.
struct ExpressionTrouble {
  std::size_t at;
  std::string sentence;
};

struct Token {
  enum class Kind { Number, Name, Text, Sign, End };
  Kind kind = Kind::End;
  std::string_view text;  ///< of a Text without its quotes
  std::size_t at = 0;     ///< its place in the expression
  double number = 0.0;
};

class Tokens {
 public:
  explicit Tokens(std::string_view text) : text_(text) { take(); }

  const Token& next() const { return next_; }
  /// Takes the next token.
  Token take();
  /// Takes the next token if it is this sign, or this word ("and").
  bool take(std::string_view sign);

 private:
  Token read();
  Token number(std::size_t at);
  Token quoted(std::size_t at);

  std::string_view text_;
  std::size_t place_ = 0;
  Token next_;
};

}  // namespace surefoot
