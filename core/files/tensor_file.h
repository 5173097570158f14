// SPDX-License-Identifier: GPL-3.0-or-later
// Named tensors and a description of them in one file, in the safetensors format
// (https://github.com/huggingface/safetensors, "Format"): eight bytes with the length of the header, little-endian; the
// header in JSON, name → {dtype, shape, data_offsets}; then the data, in order and without gaps. Our description is one
// string of JSON in the header's __metadata__, under "surefoot". Q-functions and checkpoints are such files.
//
// Values; used by one thread at a time. Files are checked completely when they are read: whatever the bytes, the result
// is a file that is consistent, or an error.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/basics/result.h"
#include "core/files/read_file.h"

namespace surefoot {

using Json = nlohmann::json;  // sorted by key: equal content, equal bytes

enum class ElementType { F64, I64, U64, U32, U16, U8 };

/// The element type of a C++ type.
template <class T>
constexpr ElementType elementTypeOf() {
  if constexpr (std::is_same_v<T, double>) return ElementType::F64;
  if constexpr (std::is_same_v<T, std::int64_t>) return ElementType::I64;
  if constexpr (std::is_same_v<T, std::uint64_t>) return ElementType::U64;
  if constexpr (std::is_same_v<T, std::uint32_t>) return ElementType::U32;
  if constexpr (std::is_same_v<T, std::uint16_t>) return ElementType::U16;
  if constexpr (std::is_same_v<T, std::uint8_t>) return ElementType::U8;
}

const char* nameOf(ElementType type);
std::size_t sizeOf(ElementType type);

struct Tensor {
  std::string name;
  ElementType type = ElementType::F64;
  std::vector<std::size_t> shape;
  std::string bytes;  ///< little-endian, the last index of the shape fastest

  std::size_t count() const { return bytes.size() / sizeOf(type); }
  /// Number of elements by the shape; equal to count() once the data is there.
  std::size_t elements() const;
};

class TensorFile {
 public:
  /// The whole file as bytes.
  std::string write() const;
  /// The file up to the first tensor's bytes; after it come the bytes of all tensors, in order.
  std::string head() const;
  /// Reads bytes; messages call the file `name`.
  static Result<TensorFile> parse(std::string_view bytes, const std::string& name);
  /// Reads a regular file. `check` first gets the file without its data, when names, types and shapes are known to fit
  /// the file: a file that it refuses takes no memory.
  static Result<TensorFile> read(const std::string& path, const std::function<Status(const TensorFile&)>& check = {});

  const Tensor* find(std::string_view name) const;

  std::string name{};  ///< for messages: the path it was read from
  Json about = Json::object();
  std::vector<Tensor> tensors;
};

}  // namespace surefoot
