// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/line_errors.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

Error unexpected(const CLI::App& app, const CLI::App& train, const std::string& word) {
  const bool option = word.starts_with('-');
  const bool top = app.get_parent() == nullptr;
  const std::string name = word.substr(0, word.find('='));
  const auto optionsOf = [](const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* o : command.get_options()) names.push_back(o->get_name());
    return names;
  };
  std::vector<std::string> known;
  if (option) known = optionsOf(app);
  if (!option && top)
    for (const CLI::App* command : app.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); }))
      known.push_back(command->get_name());
  if (option && top) {
    const auto behind = optionsOf(train);
    if (std::find(behind.begin(), behind.end(), name) != behind.end())
      return Error{fmt::format("{}: it stands behind a command, as in `surefoot train {} …` or `surefoot window {} …`.",
                               name, name, name)};
  }
  const std::string near = nearestWord(name, known);
  const char* what = option ? "there is no such option" : top ? "there is no such command" : "nothing is expected here";
  return Error{fmt::format("\"{}\": {}{}; see `surefoot{} --help`.", shortened(name), what,
                           near.empty() ? "" : ", did you mean " + near, top ? "" : " " + app.get_name())};
}

Error plain(const CLI::ParseError& error) {
  std::string text = error.what();
  const std::string option = text.substr(0, text.find(':'));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    const bool twice = text.find("At Most") != std::string::npos || text.find("Exactly") != std::string::npos;
    return Error{option + (twice ? ": it is given more than once; give it once." : ": a value is needed behind it.")};
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  return Error{text.ends_with('.') ? text : text + "."};
}

Status checkSwallowed(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    for (const std::string& value : option->results())
      if (value.starts_with("--"))
        return Error{
            fmt::format("{}: a value is needed behind it, not the option {}.", option->get_name(), shortened(value))};
  return Done{};
}

}  // namespace surefoot
