// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/manual/file_kinds.h"
#include "app/manual/man_page.h"
#include "app/manual/man_pages.h"
#include "app/process/exit_code.h"
#include "app/requests/declared_commands.h"

namespace surefoot {

namespace {

/// A sentence from what the help says without a capital and a full stop.
std::string sentence(std::string text) {
  if (text.empty()) return text;
  if (!text.starts_with("Q-")) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text.ends_with('.') ? text : text + ".";
}

std::string nameOf(const DeclaredCommand& command) {
  return command.name.empty() ? "surefoot" : "surefoot-" + command.name;
}

void addOption(ManPage& page, const DeclaredOption& o) {
  const std::string usual = o.usual.empty() ? "" : fmt::format(" [{}]", o.usual);
  const std::string typed = o.letter.empty() ? o.name : o.letter + ", " + o.name;
  page.term(o.positional ? "" : typed, o.positional ? o.name : o.type, sentence(o.help + usual));
}

void addOptions(ManPage& page, const DeclaredCommand& command, bool positional) {
  const auto isOne = [&](const DeclaredOption& o) { return o.positional == positional; };
  if (std::none_of(command.options.begin(), command.options.end(), isOne)) return;
  page.heading(positional ? "Arguments" : "Options");
  for (const DeclaredOption& o : command.options)
    if (isOne(o)) addOption(page, o);
}

void addExamples(ManPage& page, const DeclaredCommand& command) {
  if (command.examples.empty()) return;
  page.heading("Examples");
  for (const Example& e : command.examples) page.term(e.line, "", sentence(e.does));
}

void addExitCodes(ManPage& page) {
  page.heading("Exit status");
  for (const ExitMeaning& m : kExitMeanings) page.term(std::to_string(m.code), "", sentence(std::string(m.text)));
}

void addSeeAlso(ManPage& page, const std::vector<DeclaredCommand>& commands, const std::string& but) {
  page.heading("See also");
  std::string list;
  for (const DeclaredCommand& command : commands)
    if (nameOf(command) != but) list += fmt::format("{}(1), ", nameOf(command));
  page.paragraph(list + "surefoot-parameters(7)");
}

ManualFile programPage(const std::vector<DeclaredCommand>& commands, const std::string& date) {
  const DeclaredCommand& program = commands.front();
  ManPage page("surefoot", 1, date, "reinforcement learning that avoids falling");
  page.heading("Synopsis");
  page.synopsis("surefoot", "[FILE]");
  page.synopsis("surefoot", "COMMAND [OPTION ...]");
  page.heading("Description");
  page.paragraph(program.help + " With a file it opens that.");
  page.heading("Commands");
  for (auto c = commands.begin() + 1; c != commands.end(); ++c)
    page.term(c->name, "", sentence(c->help) + fmt::format(" See {}(1).", nameOf(*c)));
  addOptions(page, program, false);
  addExitCodes(page);
  page.paragraph("An error is one sentence on standard error.");
  page.heading("Files");
  for (const FileKind& kind : fileKinds())
    page.term(fmt::format("NAME.{}", kind.ending), fmt::format("({})", kind.name), sentence(std::string(kind.holds)));
  addSeeAlso(page, commands, "surefoot");
  return {"surefoot.1", page.text()};
}

ManualFile commandPage(const std::vector<DeclaredCommand>& commands, const DeclaredCommand& command,
                       const std::string& date) {
  ManPage page(nameOf(command), 1, date, command.help);
  page.heading("Synopsis");
  std::string words = "[OPTION ...]";
  for (const DeclaredOption& o : command.options)
    if (o.positional) words += fmt::format(" [{}{}]", o.name, o.repeats ? " ..." : "");
  page.synopsis("surefoot " + command.name, words);
  page.heading("Description");
  page.paragraph(sentence(command.help));
  if (!command.remark.empty()) page.paragraph(command.remark);
  addOptions(page, command, true);
  addOptions(page, command, false);
  addExamples(page, command);
  addExitCodes(page);
  addSeeAlso(page, {commands.front()}, "");
  return {nameOf(command) + ".1", page.text()};
}

}  // namespace

std::vector<ManualFile> commandPages(const Registry& registry, const std::string& date) {
  const auto commands = declaredCommands(registry);
  std::vector<ManualFile> files = {programPage(commands, date)};
  for (auto c = commands.begin() + 1; c != commands.end(); ++c) files.push_back(commandPage(commands, *c, date));
  return files;
}

}  // namespace surefoot
