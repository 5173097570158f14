// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot export FILE --c policy.c`: the greedy policy of a Q-function as C.
#include <fmt/format.h>

#include "app/commands/commands.h"
#include "app/process/exit_code.h"
#include "core/c_policy/c_policy.h"
#include "core/c_policy/known_actions.h"
#include "core/files/whole_file.h"
#include "core/saved/q_file.h"
#include "core/saved/stored_function.h"

namespace surefoot {

int exportPolicy(const Registry& registry, const ExportRequest& request) {
  const auto f = openFunction(registry, request.file);
  if (!f) return fail(f.error());
  CPolicySettings settings{.floats = request.floats, .known = {}, .origin = originOf(*f->file, request.file)};
  if (request.selfTest) settings.known = knownActions(f->values(), f->task());
  auto file = WholeFile::createNew("--c", *request.c);
  if (!file) return fail(file.error());
  fmt::print(stderr, "{}: tables of {:.1f} MB.\n", *request.c, tableBytesOf(*f->file, request.floats) / 1e6);
  const auto text = policyAsC(*f->file, f->task(), settings);
  if (!text) return fail(text.error());
  const Status written = file->commit(*text);
  return written ? kDone : fail(written.error());
}

}  // namespace surefoot
