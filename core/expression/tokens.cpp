// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/expression/tokens.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <utility>

#include "core/text/printable.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

constexpr std::array<std::string_view, 20> kSigns = {"<=", ">=", "==", "!=", "||", "&&", "<", ">", "+", "-",
                                                     "*",  "/",  "^",  "!",  "?",  ":",  "(", ")", ",", "="};

/// Signs that people write and this language writes otherwise.
constexpr std::pair<std::string_view, std::string_view> kOthers[] = {{"≤", "<="},  {"≥", ">="}, {"≠", "!="},
                                                                     {"−", "-"},   {"×", "*"},  {"·", "*"},
                                                                     {"&", "and"}, {"|", "or"}, {"%", "* 0.01"}};

}  // namespace

Token Tokens::take() {
  return std::exchange(next_, read());
}

bool Tokens::take(std::string_view sign) {
  if ((next_.kind != Token::Kind::Sign && next_.kind != Token::Kind::Name) || next_.text != sign) return false;
  take();
  return true;
}

Token Tokens::read() {
  while (place_ < text_.size() && (text_[place_] == ' ' || text_[place_] == '\n' || text_[place_] == '\t')) ++place_;
  const std::size_t at = place_;
  if (at == text_.size()) return {Token::Kind::End, {}, at};
  const std::string_view rest = text_.substr(at);
  if (isDigit(rest[0]) || (rest[0] == '.' && rest.size() > 1 && isDigit(rest[1]))) return number(at);
  if (rest[0] == '"' || rest[0] == '\'') return quoted(at);
  if (isLetter(rest[0])) {
    while (place_ < text_.size() && (isLetter(text_[place_]) || isDigit(text_[place_]) || text_[place_] == '.'))
      ++place_;
    return {Token::Kind::Name, text_.substr(at, place_ - at), at};
  }
  for (const std::string_view sign : kSigns)
    if (rest.starts_with(sign)) {
      place_ += sign.size();
      return {Token::Kind::Sign, sign, at};
    }
  for (const auto& [other, ours] : kOthers)
    if (rest.starts_with(other)) throw ExpressionTrouble{at, fmt::format("\"{}\" is written {} here.", other, ours)};
  throw ExpressionTrouble{at, fmt::format("\"{}\" means nothing here.", printable(shortened(rest.substr(0, 4))))};
}

Token Tokens::number(std::size_t at) {
  double value = 0.0;
  const char* const end = text_.data() + text_.size();
  const auto [behind, error] = std::from_chars(text_.data() + at, end, value);
  place_ = static_cast<std::size_t>(behind - text_.data());
  if (error != std::errc()) throw ExpressionTrouble{at, "this number is too large or too small."};
  const std::string_view rest(behind, static_cast<std::size_t>(end - behind));
  if (rest.starts_with("deg") || rest.starts_with("°"))
    throw ExpressionTrouble{place_, "angles are in rad: 30 degrees are 30 * pi / 180."};
  if (behind != end && (isLetter(*behind) || *behind == '.'))
    throw ExpressionTrouble{place_, "a number ends here; write 2 * x for twice x, and 0.5 with a point."};
  return {Token::Kind::Number, text_.substr(at, place_ - at), at, value};
}

Token Tokens::quoted(std::size_t at) {
  const auto end = text_.find(text_[at], at + 1);
  if (end == std::string_view::npos) throw ExpressionTrouble{at, "this quotation mark has no other."};
  place_ = end + 1;
  return {Token::Kind::Text, text_.substr(at + 1, end - at - 1), at};
}

}  // namespace surefoot
