// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/refused_tensor.h"

#include <fmt/format.h>

#include "core/basics/version.h"
#include "core/text/text.h"

namespace surefoot {

std::string otherProgramOf(const TensorFile& file) {
  const Json program = file.about.is_object() ? file.about.value("program", Json()) : Json();
  if (!program.is_string() || program == kVersion) return "";
  return std::string(shortened(program.get<std::string>()));
}

Error refusedTensor(const TensorFile& file, std::string_view tensor, std::string_view why) {
  const std::string program = otherProgramOf(file);
  const std::string hint = program.empty()
                               ? ""
                               : fmt::format(
                                     " Surefoot {} wrote the file, and this is {}: `surefoot train --from FILE` lives "
                                     "such a life anew, from its beginning.",
                                     program, kVersion);
  return fileError(file.name, fmt::format("the tensor \"{}\" {}.{}", shortened(tensor), why, hint));
}

}  // namespace surefoot
