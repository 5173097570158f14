// SPDX-License-Identifier: GPL-3.0-or-later
// The state of an object as named tensors: written into a file or read back from one by the same calls, so that the two
// cannot drift apart.
//
//   void Estimate::transfer(Archive& archive) {
//     archive.value("states_outside", statesOutside_);
//     archive.table("weights", weights_, shape);
//   }
//
// Reading checks names, types, sizes, and that every number is finite. After the first error nothing more is read; the
// values read before it must not be used.
#pragma once

#include <cmath>
#include <cstring>

#include "core/files/tensor_file.h"

namespace surefoot {

class Archive {
 public:
  static Archive writer(TensorFile& file) { return Archive(&file, nullptr); }
  static Archive reader(const TensorFile& file) { return Archive(nullptr, &file); }

  bool reading() const { return in_ != nullptr; }
  /// Whether the file that is read has it; files of older versions lack what came later.
  bool has(const std::string& name) const { return in_ && in_->find(prefix_ + name); }
  bool good() const { return static_cast<bool>(status_); }
  const Status& status() const { return status_; }
  /// Makes the reading fail: a value does not make sense.
  void refuse(const std::string& name, const std::string& why);

  /// One number that is not narrower in memory than in the file.
  void value(const std::string& name, double& v) { elements(name, std::span(&v, 1), {1}); }
  void value(const std::string& name, std::int64_t& v) { elements(name, std::span(&v, 1), {1}); }
  void value(const std::string& name, std::uint64_t& v) { elements(name, std::span(&v, 1), {1}); }
  /// A whole number from `low` to `high`, both within T. In the file it has 64 bits, and its range is checked.
  template <class T>
  void value(const std::string& name, T& v, std::int64_t low, std::int64_t high) {
    auto wide = static_cast<std::int64_t>(v);
    elements(name, std::span(&wide, 1), {1});
    if (!good()) return;
    if (wide < low || wide > high)
      refuse(name, "is out of range");
    else
      v = static_cast<T>(wide);
  }
  /// A table with a shape that writer and reader know.
  template <class T>
  void table(const std::string& name, std::vector<T>& v, const std::vector<std::size_t>& shape) {
    elements(name, std::span<T>(v), shape);
  }
  template <class T, std::size_t n>
  void table(const std::string& name, std::array<T, n>& v) {
    elements(name, std::span<T>(v), {n});
  }
  /// A list of any length up to `most`.
  template <class T>
  void list(const std::string& name, std::vector<T>& v, std::size_t most) {
    if (reading()) {
      const Tensor* tensor = wanted(name, elementTypeOf<T>());
      if (!tensor) return;
      if (tensor->count() > most) return refuse(name, "is too long");
      v.resize(tensor->count());
    }
    elements(name, std::span<T>(v), {v.size()});
  }
  /// Names inside `transfer` begin with the prefix.
  void under(const std::string& prefix, const auto& transfer) {
    const std::string outer = prefix_;
    prefix_ += prefix;
    transfer();
    prefix_ = outer;
  }

 private:
  Archive(TensorFile* out, const TensorFile* in) : out_(out), in_(in) {}

  const Tensor* wanted(const std::string& name, ElementType type);
  template <class T>
  void elements(const std::string& name, std::span<T> v, const std::vector<std::size_t>& shape) {
    const std::size_t bytes = v.size_bytes();
    if (!reading()) {
      out_->tensors.push_back({prefix_ + name, elementTypeOf<T>(), shape, std::string(bytes, '\0')});
      if (bytes > 0) std::memcpy(out_->tensors.back().bytes.data(), v.data(), bytes);
      return;
    }
    const Tensor* tensor = wanted(name, elementTypeOf<T>());
    if (!tensor) return;
    if (tensor->shape != shape) return refuse(name, "has another shape than is needed");
    if constexpr (std::is_same_v<T, double>)
      for (std::size_t i = 0; i < v.size(); ++i) {
        double x = 0.0;
        std::memcpy(&x, tensor->bytes.data() + i * sizeof x, sizeof x);
        if (!std::isfinite(x)) return refuse(name, "holds a value that is not a finite number");
      }
    if (bytes > 0) std::memcpy(v.data(), tensor->bytes.data(), bytes);
  }

  TensorFile* out_;
  const TensorFile* in_;
  std::string prefix_;
  Status status_ = Done{};
};

}  // namespace surefoot
