// SPDX-License-Identifier: GPL-3.0-or-later
// The instructions of an expression while it is compiled, within its limits.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/expression/expression.h"

namespace surefoot {

class Code {
 public:
  /// Adds an instruction that leaves `change` more values on the stack. Returns its place; nothing: there is no room.
  std::optional<std::size_t> add(Instruction in, int change) {
    height_ += change;
    if (instructions_.size() == Expression::kMostInstructions || height_ > static_cast<int>(Expression::kDeepest))
      return std::nullopt;
    instructions_.push_back(in);
    return instructions_.size() - 1;
  }
  /// A jump leads to the next instruction.
  void landHere(std::size_t jump) { instructions_[jump].place = static_cast<std::int32_t>(instructions_.size()); }

  std::size_t size() const { return instructions_.size(); }
  const Instruction& operator[](std::size_t i) const { return instructions_[i]; }
  std::vector<Instruction> take() { return std::move(instructions_); }

 private:
  std::vector<Instruction> instructions_;
  int height_ = 0;
};

}  // namespace surefoot
