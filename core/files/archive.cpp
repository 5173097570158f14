// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/archive.h"

#include <fmt/format.h>

#include "core/files/refused_tensor.h"

namespace surefoot {

void Archive::refuse(const std::string& name, const std::string& why) {
  if (good()) status_ = refusedTensor(in_ ? *in_ : *out_, prefix_ + name, why);
}

const Tensor* Archive::wanted(const std::string& name, ElementType type) {
  if (!good()) return nullptr;
  const Tensor* tensor = in_->find(prefix_ + name);
  if (!tensor) {
    refuse(name, "is missing");
  } else if (tensor->type != type) {
    refuse(name, fmt::format("is of type {}, not {}", nameOf(tensor->type), nameOf(type)));
    return nullptr;
  }
  return tensor;
}

}  // namespace surefoot
