// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signals/npz.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdint>

namespace surefoot {

namespace {

/// Numbers of 2 and 4 bytes, little-endian.
void put16(std::string& to, std::uint32_t value) {
  for (int shift = 0; shift < 16; shift += 8) to += static_cast<char>(value >> shift & 0xff);
}
void put32(std::string& to, std::uint64_t value) {
  for (int shift = 0; shift < 32; shift += 8) to += static_cast<char>(value >> shift & 0xff);
}

/// A zip archive of files as they are, without compression, as numpy.savez writes it (PKWARE's APPNOTE 6.3.3, sections
/// 4.3.7, 4.3.12 and 4.3.16). A library for it would bring a cipher with it.
class Archive {
 public:
  void add(const std::string& name, const std::string& content) {
    const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size());
    std::string described;   // the part that both of its headers have
    put16(described, 20);    // version that can read it
    put16(described, 0);     // flags
    put16(described, 0);     // stored
    put16(described, 0);     // midnight
    put16(described, 0x21);  // of 1 January 1980: the same bytes at any time
    put32(described, sum);
    put32(described, content.size());
    put32(described, content.size());
    put16(described, static_cast<std::uint32_t>(name.size()));
    put16(described, 0);  // no extra field

    put32(directory_, 0x02014b50);
    put16(directory_, 20);  // version that made it
    directory_ += described;
    put16(directory_, 0);  // no comment
    put16(directory_, 0);  // on the first disk
    put16(directory_, 0);  // no text
    put32(directory_, 0);  // no attributes
    put32(directory_, files_.size());
    directory_ += name;

    put32(files_, 0x04034b50);
    files_ += described;
    files_ += name;
    files_ += content;
    ++count_;
  }

  std::string whole() const {
    std::string end;
    put32(end, 0x06054b50);
    put32(end, 0);  // two disk numbers
    put16(end, count_);
    put16(end, count_);
    put32(end, directory_.size());
    put32(end, files_.size());
    put16(end, 0);  // no comment
    return files_ + directory_ + end;
  }
  std::size_t size() const { return files_.size() + directory_.size(); }

 private:
  std::string files_, directory_;
  std::uint32_t count_ = 0;
};

}  // namespace

std::string npyOf(std::span<const double> values) {
  std::string head = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({},), }}", values.size());
  constexpr std::size_t kBefore = 10;  // magic, version and length
  while ((kBefore + head.size() + 1) % 64 != 0) head += ' ';
  head += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  put16(bytes, static_cast<std::uint32_t>(head.size()));
  bytes += head;
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  return bytes;
}

Result<std::string> npzOf(std::span<const NamedArray> arrays) {
  constexpr std::size_t kMost = 0xffff'0000;  // what 32 bits can tell
  Archive archive;
  for (const NamedArray& array : arrays) {
    if (archive.size() + array.values.size_bytes() > kMost)
      return Error{"the archive of arrays would be larger than 4 GB; take a shorter time."};
    archive.add(array.name + ".npy", npyOf(array.values));
  }
  return archive.whole();
}

}  // namespace surefoot
