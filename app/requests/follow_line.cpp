// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/follow_line.h"

#include <fmt/format.h>

#include "core/saved/followable.h"

namespace surefoot {

FollowLine::FollowLine(CLI::App& app) : window(app) {
  addOption(app, "--follow", follow,
            "look at results or a checkpoint while another process writes them; nothing is written, and no life begins",
            "FILE");
}

Status FollowLine::check() const {
  if (!follow) return Done{};
  for (const CLI::Option* option : window.get_options())
    if (const std::string name = option->get_name();
        option->count() > 0 && name != "--follow" && name != "--allow-programs")
      return Error{fmt::format("--follow: it only looks at {}, so {} has no place beside it.", *follow, name)};
  const auto what = followableAt(*follow);
  return what ? Status(Done{}) : Status(what.error());
}

}  // namespace surefoot
