// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/expression/compile.h"

#include <numbers>

#include "core/expression/compiler.h"
#include "core/text/words.h"

namespace surefoot {

Compiler::Meaning Compiler::named(const Token& name) {
  const bool opens = tokens_.next().kind == Token::Kind::Sign && tokens_.next().text == "(";
  if (opens)
    for (const ExpressionFunction& f : kExpressionFunctions)
      if (f.name == name.text) return call(name, f);
  if (!opens && name.text == "pi") return constant(std::numbers::pi);
  std::optional<std::string_view> argument;
  if (tokens_.take("(")) {
    const Token token = tokens_.take();
    // A function that is none is told before what stands in its parentheses.
    if (token.kind != Token::Kind::Text && token.kind != Token::Kind::Number && !vocabulary_.find(name.text, "0"))
      return variable(name, "0");
    if (token.kind != Token::Kind::Text && token.kind != Token::Kind::Number)
      fail(token, fmt::format("{} takes a text in quotes or a number.", printable(shortened(name.text))));
    argument = token.text;
    close("(");
  }
  return variable(name, argument);
}

Compiler::Meaning Compiler::call(const Token& name, const ExpressionFunction& f) {
  if (f.operation == Operation::Uniform && !vocabulary_.chance()) fail(name, "there is no chance here.");
  tokens_.take("(");
  Meaning values[3];
  for (int i = 0; i < f.arguments; ++i) {
    const Token comma = tokens_.next();
    if (i > 0 && !tokens_.take(","))
      fail(comma, fmt::format("{} takes {} values with commas between them.", f.name, f.arguments));
    values[i] = choice();
  }
  if (f.operation == Operation::Min || f.operation == Operation::Max)
    while (tokens_.take(",")) {  // of more than two
      add({f.operation}, -1);
      const Meaning another = choice();
      values[0] = {Kind::Number, rangeOf(f.operation, values[0].range, values[1].range)};
      values[1] = another;
    }
  close(f.name);
  add({f.operation}, 1 - f.arguments);
  if (f.arguments == 1) return {Kind::Number, rangeOf(f.operation, values[0].range)};
  if (f.arguments == 2) return {Kind::Number, rangeOf(f.operation, values[0].range, values[1].range)};
  return {};
}

Compiler::Meaning Compiler::variable(const Token& name, std::optional<std::string_view> argument) {
  const auto found = vocabulary_.find(name.text, argument);
  if (found) {
    add({Operation::Variable, found->place}, 1);
    return {found->kind, {found->low, found->high}};
  }
  if (!found.error().message.empty()) fail(name, found.error().message);
  auto names = vocabulary_.names();
  for (const ExpressionFunction& f : kExpressionFunctions) names.push_back(std::string(f.name) + "(");
  const std::string near = nearestWord(std::string(name.text) + (argument ? "(" : ""), names);
  fail(name, fmt::format("there is no \"{}\"{}.", printable(shortened(name.text)),
                         near.empty() ? "" : fmt::format("; did you mean {}", near)));
}

Result<Expression> compile(std::string_view text, ValueKind wanted, const Vocabulary& vocabulary, std::size_t& at) {
  at = 0;
  if (text.size() > kLongestExpression)
    return Error{fmt::format("an expression has at most {} characters.", kLongestExpression)};
  try {
    return Expression(Compiler(text, vocabulary).compile(wanted));
  } catch (const ExpressionTrouble& trouble) {
    at = trouble.at;
    return Error{trouble.sentence};
  }
}

Result<Expression> compile(std::string_view text, ValueKind wanted, const Vocabulary& vocabulary) {
  std::size_t at = 0;
  auto compiled = compile(text, wanted, vocabulary, at);
  if (compiled) return compiled;
  return Error{fmt::format("at character {}: {}", at + 1, compiled.error().message)};
}

}  // namespace surefoot
