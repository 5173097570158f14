// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/command_help.h"

#include <fmt/format.h>

#include "app/requests/declared_commands.h"

namespace surefoot {

std::vector<CommandHelp> commandHelp(const Registry& registry) {
  std::vector<CommandHelp> all;
  for (const DeclaredCommand& c : declaredCommands(registry)) {
    if (c.name.empty()) continue;  // the program itself
    CommandHelp help{.name = c.name, .summary = c.help, .line = "surefoot " + c.name, .remark = c.remark};
    for (const DeclaredOption& o : c.options) {
      const std::string words =
          fmt::format("{}{}{}", o.letter.empty() ? "" : o.letter + ", ", o.name, o.type.empty() ? "" : " " + o.type);
      help.options.push_back({words, o.help + (o.usual.empty() ? "" : fmt::format(" [{}]", o.usual))});
      if (o.positional) help.line += fmt::format(" [{}{}]", o.name, o.repeats ? " …" : "");
    }
    help.line += " [OPTION …]";
    for (const Example& e : c.examples) help.examples.push_back({e.line, e.does});
    all.push_back(std::move(help));
  }
  return all;
}

}  // namespace surefoot
