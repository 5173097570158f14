// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/declared_commands.h"

#include <CLI/CLI.hpp>

namespace surefoot {

namespace {

DeclaredOption declared(const CLI::Option& option) {
  DeclaredOption o;
  o.positional = !option.nonpositional();
  o.name = o.positional ? option.get_name(true) : "--" + option.get_lnames().at(0);
  if (!option.get_snames().empty()) o.letter = "-" + option.get_snames()[0];
  const bool takes = option.get_items_expected_max() > 0;
  if (takes && !o.positional) o.type = option.get_type_name();
  o.usual = option.get_default_str();
  o.help = option.get_description();
  o.repeats = takes && (option.get_items_expected_max() > 1 ||
                        option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll);
  return o;
}

DeclaredCommand declared(const CLI::App& command) {
  DeclaredCommand c{.name = command.get_name(), .help = command.get_description()};
  c.examples = examplesOf(c.name);
  c.remark = command.get_footer().substr(examplesText(c.name).size());
  for (const CLI::Option* option : command.get_options())
    if (!option->get_group().empty()) c.options.push_back(declared(*option));
  return c;
}

}  // namespace

std::vector<DeclaredCommand> declaredIn(const CLI::App& app) {
  std::vector<DeclaredCommand> all = {declared(app)};
  all.front().name.clear();
  all.front().remark.clear();  // its exit codes
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); }))
    all.push_back(declared(*command));
  return all;
}

}  // namespace surefoot
