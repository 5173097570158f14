// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/tensor_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <numeric>
#include <optional>
#include <tuple>

#include "core/basics/typed_json.h"
#include "core/files/limited_json.h"
#include "core/text/text.h"

static_assert(std::endian::native == std::endian::little, "tensors are copied as they lie in memory");

namespace surefoot {

namespace {

constexpr std::size_t kLengthBytes = 8;
constexpr std::size_t kLongestHeader = 4u << 20;
constexpr const char* kMetadata = "__metadata__";
constexpr const char* kOurs = "surefoot";

struct TypeName {
  ElementType type;
  const char* name;
  std::size_t size;
};
constexpr std::array kTypes = {TypeName{ElementType::F64, "F64", 8}, TypeName{ElementType::I64, "I64", 8},
                               TypeName{ElementType::U64, "U64", 8}, TypeName{ElementType::U32, "U32", 4},
                               TypeName{ElementType::U16, "U16", 2}, TypeName{ElementType::U8, "U8", 1}};

const TypeName& entryOf(ElementType type) {
  return *std::find_if(kTypes.begin(), kTypes.end(), [=](const TypeName& t) { return t.type == type; });
}

std::optional<std::size_t> naturalNumber(const Json& json) {
  if (!json.is_number_unsigned()) return std::nullopt;
  return json.get<std::size_t>();
}

/// Reads the header's entry of one tensor; there are `size` bytes behind the header, and this tensor must begin at
/// `offset`. Its own bytes are left to the caller.
Result<Tensor> readTensor(const std::string& file, const std::string& name, const Json& entry, std::size_t size,
                          std::size_t offset) {
  const auto refuse = [&](const std::string& why) {
    return fileError(file, fmt::format("the tensor \"{}\" {}.", shortened(name), why));
  };
  Tensor tensor{.name = name, .type = ElementType::F64, .shape = {}, .bytes = {}};
  const Json& dtype = entry["dtype"];
  const auto type = std::find_if(kTypes.begin(), kTypes.end(), [&](const TypeName& t) { return dtype == t.name; });
  if (type == kTypes.end())
    return refuse(fmt::format("has the dtype {}; F64, I64, U64, U32, U16 and U8 are known",
                              shortened(jsonText(dtype, -1, true))));
  tensor.type = type->type;

  std::size_t count = 1;
  for (const Json& extent : entry["shape"]) {
    const auto n = naturalNumber(extent);
    if (!n || (*n != 0 && count > size / *n)) return refuse("has a shape that does not fit the file");
    tensor.shape.push_back(*n);
    count *= *n;
  }
  const auto begin = naturalNumber(entry["data_offsets"][0]), end = naturalNumber(entry["data_offsets"][1]);
  if (!begin || !end || *begin != offset || *end < *begin || *end > size)
    return refuse("does not lie where the one before it ends, or ends beyond the file");
  if (count > size / type->size || count * type->size != *end - *begin)
    return refuse(
        fmt::format("has {} bytes, but its shape needs {} elements of {} bytes", *end - *begin, count, type->size));
  return tensor;
}

bool isTensorEntry(const Json& entry) {
  return entry.is_object() && entry.contains("dtype") && entry["dtype"].is_string() && entry.contains("shape") &&
         entry["shape"].is_array() && entry.contains("data_offsets") && entry["data_offsets"].is_array() &&
         entry["data_offsets"].size() == 2 && entry["data_offsets"][0].is_number_unsigned() &&
         entry["data_offsets"][1].is_number_unsigned();
}

/// A path in it may not be UTF-8: then as near as can be.
std::string textOf(const Json& json) {
  return jsonText(json);
}

}  // namespace

const char* nameOf(ElementType type) {
  return entryOf(type).name;
}
std::size_t sizeOf(ElementType type) {
  return entryOf(type).size;
}

const Tensor* TensorFile::find(std::string_view wanted) const {
  const auto found = std::find_if(tensors.begin(), tensors.end(), [&](const Tensor& t) { return t.name == wanted; });
  return found == tensors.end() ? nullptr : &*found;
}

std::string TensorFile::head() const {
  Json header = {{kMetadata, {{kOurs, textOf(about)}}}};
  std::size_t offset = 0;
  for (const Tensor& t : tensors) {
    header[t.name] = {
        {"dtype", nameOf(t.type)}, {"shape", t.shape}, {"data_offsets", {offset, offset + t.bytes.size()}}};
    offset += t.bytes.size();
  }
  std::string text = textOf(header);
  text.resize((text.size() + 7) / 8 * 8, ' ');  // so that the data is aligned
  const std::uint64_t length = text.size();
  std::string bytes(kLengthBytes, '\0');
  std::memcpy(bytes.data(), &length, kLengthBytes);
  return bytes + text;
}

std::string TensorFile::write() const {
  std::string bytes = head();
  std::size_t size = bytes.size();
  for (const Tensor& t : tensors) size += t.bytes.size();
  bytes.reserve(size);
  for (const Tensor& t : tensors) bytes += t.bytes;
  return bytes;
}

namespace {

/// The length of the header, if a file of so many bytes can have it.
Result<std::size_t> headerLength(std::string_view head, std::size_t size, const std::string& name) {
  std::uint64_t length = 0;
  if (head.size() < kLengthBytes)
    return fileError(name, fmt::format("this is no safetensors file: it has only {} bytes.", head.size()));
  std::memcpy(&length, head.data(), kLengthBytes);
  if (length == 0 || length > kLongestHeader || length > size - kLengthBytes)
    return fileError(name,
                     fmt::format("this is no safetensors file, or it is cut off: its header would have {} bytes, and "
                                 "the file has {}.",
                                 length, size));
  return static_cast<std::size_t>(length);
}

/// The file without its data, `size` bytes, its tensors in the order in which they lie.
Result<TensorFile> parseHeader(std::string_view text, std::size_t size, const std::string& name) {
  Json header = parseJson(text);
  if (!header.is_object()) return fileError(name, "its header is not JSON; the file is damaged.");
  if (!header.contains(kMetadata) || !header[kMetadata].is_object() || !header[kMetadata].contains(kOurs) ||
      !header[kMetadata][kOurs].is_string())
    return fileError(name, "it is a safetensors file, but not one of Surefoot: its metadata has no text \"surefoot\".");

  TensorFile file;
  file.name = name;
  file.about = parseJson(header[kMetadata][kOurs].get_ref<const std::string&>());
  if (!file.about.is_object()) return fileError(name, "its description is not JSON; the file is damaged.");
  std::size_t offset = 0;
  std::vector<std::tuple<std::size_t, std::size_t, std::string>> order;  // as they lie in the file; empty ones first
  for (const auto& [key, entry] : header.items()) {
    if (key == kMetadata) continue;
    if (!isTensorEntry(entry))
      return fileError(name, fmt::format("the entry \"{}\" of its header is no tensor.", shortened(key)));
    order.emplace_back(entry["data_offsets"][0].get<std::size_t>(), entry["data_offsets"][1].get<std::size_t>(), key);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [begin, end, key] : order) {
    auto tensor = readTensor(name, key, header[key], size, offset);
    if (!tensor) return tensor.error();
    offset = end;
    file.tensors.push_back(std::move(*tensor));
  }
  if (offset != size)
    return fileError(name, fmt::format("{} bytes behind the last tensor belong to none.", size - offset));
  return file;
}

using OpenFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// So many bytes from where it stands; fewer at its end.
Result<std::string> take(std::FILE* in, std::size_t count, const std::string& name) {
  std::string bytes;
  try {
    bytes.resize(count);
  } catch (const std::bad_alloc&) {
    return fileError(name, "it cannot be read: it is larger than the memory that is left.");
  }
  bytes.resize(std::fread(bytes.data(), 1, count, in));
  if (std::ferror(in)) return fileError(name, fmt::format("it cannot be read: {}.", std::strerror(errno)));
  return bytes;
}

}  // namespace

std::size_t Tensor::elements() const {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

Result<TensorFile> TensorFile::parse(std::string_view bytes, const std::string& name) {
  const auto length = headerLength(bytes, bytes.size(), name);
  if (!length) return length.error();
  std::string_view data = bytes.substr(kLengthBytes + *length);
  auto file = parseHeader(bytes.substr(kLengthBytes, *length), data.size(), name);
  if (!file) return file;
  for (Tensor& t : file->tensors) {
    const std::size_t size = t.elements() * sizeOf(t.type);
    t.bytes = data.substr(0, size);
    data.remove_prefix(size);
  }
  return file;
}

Result<TensorFile> TensorFile::read(const std::string& path, const std::function<Status(const TensorFile&)>& check) {
  const auto head = readHead(path, kLengthBytes);  // with readHead's look at what the name is
  if (!head) return head.error();
  const OpenFile in(std::fopen(path.c_str(), "rb"), std::fclose);
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  if (!in || failed) return fileError(path, fmt::format("it cannot be read: {}.", std::strerror(errno)));
  const auto length = headerLength(*head, size, path);
  if (!length) return length.error();
  std::fseek(in.get(), kLengthBytes, SEEK_SET);
  const auto text = take(in.get(), *length, path);
  if (!text) return text.error();
  auto file = parseHeader(*text, size - kLengthBytes - *length, path);
  if (!file) return file;
  if (check)
    if (const Status s = check(*file); !s) return s.error();
  for (Tensor& t : file->tensors) {
    const std::size_t wanted = t.elements() * sizeOf(t.type);
    auto bytes = take(in.get(), wanted, path);
    if (!bytes) return bytes.error();
    if (bytes->size() != wanted) return fileError(path, "it became shorter while it was read.");
    t.bytes = std::move(*bytes);
  }
  return file;
}

}  // namespace surefoot
