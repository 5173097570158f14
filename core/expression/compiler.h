// SPDX-License-Identifier: GPL-3.0-or-later
// The grammar of expressions: part of compile().
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/expression/code.h"
#include "core/expression/functions.h"
#include "core/expression/range.h"
#include "core/expression/tokens.h"
#include "core/expression/vocabulary.h"
#include "core/text/printable.h"
#include "core/text/text.h"

namespace surefoot {

/// Recursive descent: a function for each line of the grammar, weakest first. Each leaves one value on the stack and
/// says what is known of it.
class Compiler {
 public:
  Compiler(std::string_view text, const Vocabulary& vocabulary) : tokens_(text), vocabulary_(vocabulary) {}

  std::vector<Instruction> compile(ValueKind wanted) {
    const Meaning all = choice();
    if (const Token more = tokens_.next(); more.kind == Token::Kind::Name)
      fail(more,
           fmt::format("a sign is missing before \"{}\"; units are not written.", printable(shortened(more.text))));
    else if (more.kind != Token::Kind::End)
      fail(more, unexpected(more));
    if (wanted == Kind::Condition) {
      needCondition(all, Token{});
      if (all.range.low == 0.0 && all.range.high == 0.0) fail(Token{}, "this can never hold.");
    }
    if (wanted == Kind::Number && all.kind == Kind::Condition)
      fail(Token{}, "a number is wanted, and this is a condition; write (condition) ? 1 : 0.");
    return code_.take();
  }

 private:
  using Kind = ValueKind;
  /// What is known of a value before it is computed.
  struct Meaning {
    Kind kind = Kind::Number;
    Range range{};
  };

  [[noreturn]] static void fail(const Token& at, std::string sentence) {
    throw ExpressionTrouble{at.at, std::move(sentence)};
  }
  static std::string unexpected(const Token& token) {
    if (token.kind == Token::Kind::End) return "it ends too early; a number or a name is missing.";
    if (token.text == "=") return "compare with ==.";
    return fmt::format("\"{}\" is not expected here.", printable(shortened(token.text)));
  }
  static void needCondition(const Meaning& value, const Token& at) {
    if (value.kind == Kind::Number) fail(at, "a condition is wanted, and this is a number; compare it with something.");
  }

  /// Whatever nests goes through here: no text overflows the stack of the program.
  class Deeper {
   public:
    explicit Deeper(Compiler& compiler, const Token& at) : compiler_(compiler) {
      if (++compiler_.depth_ > static_cast<int>(Expression::kDeepest)) fail(at, "this is nested too deep.");
    }
    ~Deeper() { --compiler_.depth_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;

   private:
    Compiler& compiler_;
  };

  std::size_t add(Instruction in, int change) {
    const auto place = code_.add(in, change);
    if (!place) fail(tokens_.next(), "the expression is too long, or nested too deep.");
    return *place;
  }

  // c ? a : b
  Meaning choice() {
    const Token begin = tokens_.next();
    const Deeper deeper(*this, begin);
    const Meaning condition = either();
    if (!tokens_.take("?")) return condition;
    needCondition(condition, begin);
    const std::size_t toOther = add({Operation::JumpIfFalse}, -1);
    const Meaning a = choice();
    const Token colon = tokens_.next();
    if (!tokens_.take(":")) fail(colon, "a condition with ? needs a second value, behind a colon.");
    const std::size_t toEnd = add({Operation::Jump}, -1);
    code_.landHere(toOther);
    const Meaning b = choice();
    code_.landHere(toEnd);
    const bool number = a.kind == Kind::Number || b.kind == Kind::Number;
    return {a.kind == b.kind ? a.kind : number ? Kind::Number : Kind::Flag, together(a.range, b.range)};
  }

  Meaning either() {
    const auto orOf = [](Range a, Range b) { return Range{std::max(a.low, b.low), std::max(a.high, b.high)}; };
    return decided(
        {"||", "or"}, 1.0, [this] { return both(); }, orOf);
  }
  Meaning both() {
    bounds_.emplace_back();
    const auto andOf = [](Range a, Range b) { return Range{std::min(a.low, b.low), std::min(a.high, b.high)}; };
    Meaning all = decided(
        {"&&", "and"}, 0.0, [this] { return bounded(); }, andOf);
    for (const auto& [place, range] : bounds_.back())
      if (range.empty()) all.range = {0.0, 0.0};
    bounds_.pop_back();
    return all;
  }

  /// Conditions that are evaluated up to the one that decides. `of`: the range of two of them.
  template <class Next, class Of>
  Meaning decided(std::pair<std::string_view, std::string_view> signs, double decisive, Next next, Of of) {
    Token begin = tokens_.next();
    Meaning all = next();
    std::vector<std::size_t> jumps;
    while (tokens_.take(signs.first) || tokens_.take(signs.second)) {
      needCondition(all, begin);
      jumps.push_back(add({Operation::JumpIfDecided, 0, decisive}, -1));
      begin = tokens_.next();
      const Meaning another = next();
      needCondition(another, begin);
      all = {Kind::Condition, of(truthOf(all.range), truthOf(another.range))};
    }
    if (jumps.empty()) return all;
    for (const std::size_t jump : jumps) code_.landHere(jump);
    add({Operation::Truth}, 0);
    return all;
  }
  static Range truthOf(Range range) { return rangeOf(Operation::Not, rangeOf(Operation::Not, range)); }

  /// A comparison. If it compares a variable with a constant, it narrows what the variable can be where all of
  /// `a and b and …` hold: "falls > 5 and falls < 3" can not.
  Meaning bounded() {
    const std::size_t begin = code_.size();
    const Meaning value = comparison();
    if (code_.size() != begin + 3) return value;
    const Instruction &a = code_[begin], &b = code_[begin + 1];
    const Operation operation = code_[begin + 2].operation;
    if (a.operation != Operation::Variable || b.operation != Operation::Constant) return value;
    Range& range = bounds_.back()[a.place];
    const double beyond = std::nextafter(b.number, operation == Operation::Less ? -kInfinity : kInfinity);
    if (operation == Operation::LessOrEqual || operation == Operation::Equal)
      range.high = std::min(range.high, b.number);
    if (operation == Operation::GreaterOrEqual || operation == Operation::Equal)
      range.low = std::max(range.low, b.number);
    if (operation == Operation::Less) range.high = std::min(range.high, beyond);
    if (operation == Operation::Greater) range.low = std::max(range.low, beyond);
    return value;
  }

  /// The operation that this sign stands for.
  template <std::size_t N>
  std::optional<Operation> takeOneOf(const std::pair<std::string_view, Operation> (&signs)[N]) {
    for (const auto& [sign, operation] : signs)
      if (tokens_.take(sign)) return operation;
    return std::nullopt;
  }

  Meaning comparison() {
    static constexpr std::pair<std::string_view, Operation> kSigns[] = {
        {"<=", Operation::LessOrEqual}, {">=", Operation::GreaterOrEqual},
        {"==", Operation::Equal},       {"!=", Operation::NotEqual},
        {"<", Operation::Less},         {">", Operation::Greater}};
    const Meaning a = sum();
    const auto operation = takeOneOf(kSigns);
    if (!operation) return a;
    const Meaning b = sum();
    add({*operation}, -1);
    const Token again = tokens_.next();
    if (takeOneOf(kSigns)) fail(again, "comparisons do not chain; write a < b and b < c.");
    return {Kind::Condition, rangeOf(*operation, a.range, b.range)};
  }

  Meaning sum() {
    static constexpr std::pair<std::string_view, Operation> kSigns[] = {{"+", Operation::Add},
                                                                        {"-", Operation::Subtract}};
    return row(kSigns, [this] { return product(); });
  }
  Meaning product() {
    static constexpr std::pair<std::string_view, Operation> kSigns[] = {{"*", Operation::Multiply},
                                                                        {"/", Operation::Divide}};
    return row(kSigns, [this] { return withSign(); });
  }

  /// Operations of two numbers, from left to right.
  template <std::size_t N, class Next>
  Meaning row(const std::pair<std::string_view, Operation> (&signs)[N], Next next) {
    Meaning all = next();
    while (const auto operation = takeOneOf(signs)) {
      const Meaning another = next();
      add({*operation}, -1);
      all = {Kind::Number, rangeOf(*operation, all.range, another.range)};
    }
    return all;
  }

  Meaning withSign() {
    const Token begin = tokens_.next();
    const Deeper deeper(*this, begin);
    if (tokens_.take("-")) {
      const Meaning value = withSign();
      add({Operation::Minus}, 0);
      return {Kind::Number, rangeOf(Operation::Minus, value.range)};
    }
    if (tokens_.take("!") || tokens_.take("not")) {
      const Token condition = tokens_.next();
      const Meaning value = begin.text == "!" ? withSign() : comparison();
      needCondition(value, condition);
      add({Operation::Not}, 0);
      return {Kind::Condition, rangeOf(Operation::Not, value.range)};
    }
    return power();
  }

  // -x^2 is -(x^2).
  Meaning power() {
    constexpr double kHighest = 16;
    const Meaning value = primary();
    if (!tokens_.take("^")) return value;
    const Token exponent = tokens_.take();
    if (exponent.kind != Token::Kind::Number || exponent.number != std::floor(exponent.number) ||
        exponent.number > kHighest)
      fail(exponent, "the exponent is a whole number from 0 to 16.");
    add({Operation::Power, static_cast<std::int32_t>(exponent.number)}, 0);
    return {};
  }

  Meaning primary() {
    const Token token = tokens_.take();
    if (token.kind == Token::Kind::Number) {
      return constant(token.number);
    }
    if (token.kind == Token::Kind::Name && token.text != "and" && token.text != "or") return named(token);
    if (token.kind != Token::Kind::Sign || token.text != "(") fail(token, unexpected(token));
    const Meaning value = choice();
    close("(");
    return value;
  }

  Meaning constant(double value) {
    add({Operation::Constant, 0, value}, 1);
    return {Kind::Number, {value, value}};
  }

  void close(std::string_view opened) {
    const Token token = tokens_.next();
    if (!tokens_.take(")")) fail(token, fmt::format("the parenthesis of {}… is not closed.", opened));
  }

  Meaning named(const Token& name);
  Meaning call(const Token& name, const ExpressionFunction& f);
  Meaning variable(const Token& name, std::optional<std::string_view> argument);

  Tokens tokens_;
  const Vocabulary& vocabulary_;
  Code code_;
  std::vector<std::map<std::int32_t, Range>> bounds_;  // of the variables in every `a and b and …` in hand
  int depth_ = 0;
};

}  // namespace surefoot
