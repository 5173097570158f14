// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signals/npz.h"

#include <fmt/format.h>
#include <zip.h>

#include <memory>

namespace surefoot {

std::string npyOf(std::span<const double> values) {
  std::string head = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({},), }}", values.size());
  constexpr std::size_t kBefore = 10;  // magic, version and length
  while ((kBefore + head.size() + 1) % 64 != 0) head += ' ';
  head += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(head.size() & 0xff);
  bytes += static_cast<char>(head.size() >> 8);
  bytes += head;
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  return bytes;
}

Result<std::string> npzOf(std::span<const NamedArray> arrays) {
  const Error failed{"the archive of arrays cannot be made.", ErrorKind::File};
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* whole = zip_source_buffer_create(nullptr, 0, 0, &error);
  if (!whole) return failed;
  zip_source_keep(whole);  // it is read below, when the archive has been closed
  const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> kept(whole, zip_source_free);
  zip_t* archive = zip_open_from_source(whole, ZIP_TRUNCATE, &error);
  if (!archive) return failed;
  std::vector<std::string> files;  // they must live until the archive is closed
  files.reserve(arrays.size());
  for (const NamedArray& array : arrays) {
    files.push_back(npyOf(array.values));
    zip_source_t* source = zip_source_buffer(archive, files.back().data(), files.back().size(), 0);
    const zip_int64_t at = source ? zip_file_add(archive, (array.name + ".npy").c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    if (at < 0) return zip_source_free(source), zip_discard(archive), failed;
    zip_file_set_mtime(archive, static_cast<zip_uint64_t>(at), 315532800, 0);  // 1980: the same bytes at any time
  }
  if (zip_close(archive) != 0) return zip_discard(archive), failed;
  if (zip_source_open(whole) != 0) return failed;
  std::string bytes;
  char part[65536];
  for (zip_int64_t count = 0; (count = zip_source_read(whole, part, sizeof part)) > 0;)
    bytes.append(part, static_cast<std::size_t>(count));
  zip_source_close(whole);
  return bytes;
}

}  // namespace surefoot
