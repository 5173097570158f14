// SPDX-License-Identifier: GPL-3.0-or-later
// Compiles the text of an expression (its grammar: expression.h).
#pragma once

#include "core/expression/expression.h"
#include "core/expression/vocabulary.h"

namespace surefoot {

inline constexpr std::size_t kLongestExpression = 1000;  ///< [bytes]

/// An expression that gives a number, or a condition (ValueKind::Flag: either). An error's message is one sentence,
/// and `at` gets the place in the text, from 0, that it is about. Refused are: names that are not in the vocabulary,
/// a number where a condition is wanted, chains of comparisons, texts over kLongestExpression, more than
/// Expression::kMostInstructions, and what is nested more than Expression::kDeepest deep.
Result<Expression> compile(std::string_view text, ValueKind wanted, const Vocabulary& vocabulary, std::size_t& at);

/// The same with the place in the message: "at character 12: …".
Result<Expression> compile(std::string_view text, ValueKind wanted, const Vocabulary& vocabulary);

}  // namespace surefoot
