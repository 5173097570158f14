// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/completion/completion.h"

#include <algorithm>

#include "app/completion/completion_values.h"
#include "app/manual/file_kinds.h"

namespace surefoot {

namespace {

const DeclaredOption* find(const DeclaredCommand& command, const std::string& name) {
  for (const DeclaredOption& o : command.options)
    if (!o.positional && o.name == name) return &o;
  return nullptr;
}

/// The options that may still be given.
void offerOptions(const DeclaredCommand& command, const std::vector<std::string>& given, Completions& into) {
  for (const DeclaredOption& o : command.options) {
    const bool there = std::any_of(given.begin(), given.end(), [&](const std::string& word) {
      return word == o.name || word.starts_with(o.name + "=");
    });
    if (!o.positional && (o.repeats || !there)) into.words.push_back({o.name, o.help});
  }
}

void offerCommands(const std::vector<DeclaredCommand>& commands, Completions& into) {
  for (auto c = commands.begin() + 1; c != commands.end(); ++c) into.words.push_back({c->name, c->help});
}

/// Behind a command.
void offerBehind(const Registry& registry, const DeclaredCommand& command, const std::vector<std::string>& words,
                 Completions& into) {
  UnfinishedLine line{registry, command.name, {words.begin() + 1, words.end() - 1}, words.back()};
  const DeclaredOption* before = line.words.empty() ? nullptr : find(command, line.words.back());
  if (before && !before->type.empty()) return offerValues(line, *before, into);
  if (const auto equals = line.written.find('='); line.written.starts_with("--") && equals != std::string::npos) {
    const DeclaredOption* option = find(command, line.written.substr(0, equals));
    line.written = line.written.substr(equals + 1);
    if (option && !option->type.empty()) offerValues(line, *option, into);
    for (Completion& c : into.words) c.word = option->name + "=" + c.word;
    return;
  }
  const auto stands = std::find_if(command.options.begin(), command.options.end(),
                                   [](const DeclaredOption& o) { return o.positional; });
  if (line.written.starts_with('-') || stands == command.options.end()) return offerOptions(command, line.words, into);
  offerValues(line, *stands, into);
}

}  // namespace

Completions complete(const Registry& registry, const std::vector<std::string>& words) {
  Completions all;
  if (words.empty()) return all;
  const auto commands = declaredCommands(registry);
  if (words.size() == 1) {
    offerOptions(commands.front(), {}, all);
    if (!words[0].starts_with('-')) {
      all.words.clear();
      offerCommands(commands, all);
      all.files = true;
      for (const FileKind& kind : fileKinds())
        if (kind.opens && (all.endings.empty() || all.endings.back() != kind.ending))
          all.endings.emplace_back(kind.ending);
    }
  } else {
    const auto command = std::find_if(commands.begin() + 1, commands.end(),
                                      [&](const DeclaredCommand& c) { return c.name == words[0]; });
    if (words[0].starts_with('-')) offerOptions(commands.front(), {words.begin(), words.end() - 1}, all);
    if (command != commands.end()) offerBehind(registry, *command, words, all);
  }
  std::erase_if(all.words, [&](const Completion& c) { return !c.word.starts_with(words.back()); });
  return all;
}

std::string completionsText(const Completions& completions) {
  std::string text;
  for (const Completion& c : completions.words) {
    std::string help = c.help;
    std::replace_if(
        help.begin(), help.end(), [](char x) { return x == '\n' || x == '\t'; }, ' ');
    text += c.word + "\t" + help + "\n";
  }
  if (completions.files) {
    text += ":files";
    for (const std::string& ending : completions.endings) text += " " + ending;
    text += "\n";
  }
  return text + (completions.folders ? ":folders\n" : "");
}

}  // namespace surefoot
