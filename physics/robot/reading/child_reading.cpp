// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/text/printable.h"
#include "core/text/text.h"
#include "physics/robot/reading/sections.h"

namespace surefoot {

namespace {

constexpr std::size_t kMostWords = 32, kLongestWord = 400, kMostSent = 256;

bool isWord(const TomlNode& node) {
  const auto plain = [](char c) { return static_cast<unsigned char>(c) >= 0x20; };
  return node.kind == TomlNode::Kind::Text && !node.text.empty() && node.text.size() <= kLongestWord &&
         std::all_of(node.text.begin(), node.text.end(), plain);
}

void readCommand(const TomlNode& command, RobotReader& in) {
  const bool right = command.kind == TomlNode::Kind::List && !command.list.empty() &&
                     command.list.size() <= kMostWords && std::all_of(command.list.begin(), command.list.end(), isWord);
  if (!right) {
    in.complaints().push_back(
        {command.at,
         fmt::format("command: it takes a list of up to {} words, such as [\"python3\", \"robot.py\"].", kMostWords)});
    return;
  }
  in.spec().child.place = command.at;
  for (const TomlNode& word : command.list) in.spec().child.command.push_back(word.text);
}

/// The keys of states that have no value of their own.
std::vector<std::string> statesWithoutValue(const TomlNode& root) {
  std::vector<std::string> keys;
  const TomlNode* states = root.find("state");
  for (const TomlNode& state : states ? states->list : std::vector<TomlNode>{})
    if (const TomlNode* key = state.find("key"); key && !state.find("value")) keys.push_back(key->text);
  return keys;
}

}  // namespace

void readChild(const TomlNode& root, RobotReader& in) {
  const TomlNode *command = root.find("command"), *sends = root.find("sends");
  if (!command) {
    if (sends) in.complaints().push_back({sends->keyAt, "sends: it belongs to a command."});
    return;
  }
  readCommand(*command, in);
  std::vector<std::string>& sent = in.spec().child.sends;
  sent = {"reward", "terminated", "truncated"};
  TomlReader reader(root, in.complaints());
  for (const std::string& name : sends ? reader.texts("sends") : statesWithoutValue(root)) {
    const char* why = wrongName(name);
    if (!why && std::find(sent.begin(), sent.end(), name) != sent.end()) why = "it is sent already.";
    if (why) reader.complain("sends", fmt::format("\"{}\": {}", printable(shortened(name)), why));
    sent.push_back(name);
  }
  if (sent.size() > kMostSent)
    reader.complain("sends", fmt::format("{} numbers; at most {} are allowed.", sent.size(), kMostSent));
  in.spec().names.setSent(sent);
}

void refuseWorld(const TomlNode& root, RobotReader& in) {
  if (!in.spec().names.hasChild()) return;
  for (const char* key : {"body", "joint", "ray", "ground", "start", "push", "substeps", "velocity_iterations",
                          "position_iterations", "gravity", "scale"})
    if (const TomlNode* node = root.find(key))
      in.complaints().push_back(
          {node->keyAt, fmt::format("{}: a robot has either a world of its own or a command that moves it; this one "
                                    "has a command.",
                                    key)});
}

}  // namespace surefoot
