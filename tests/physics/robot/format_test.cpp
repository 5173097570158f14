// SPDX-License-Identifier: GPL-3.0-or-later
// resources/robots/format.md names every key of the format, and no other.
#include <fmt/format.h>

#include <map>
#include <regex>
#include <set>

#include "core/files/toml_tree.h"
#include "tests/physics/robot/robot_files.h"

namespace surefoot {

namespace {

/// The keys of each section: "body" of "## [body.NAME]", "" of the file's own, "shape".
std::map<std::string, std::set<std::string>> explained() {
  static const std::regex kHead("^## \\[*([a-z]+)"), kKey("^- `(\\w+)`");
  std::map<std::string, std::set<std::string>> keys;
  std::istringstream in(textOfFile(std::string(SUREFOOT_SOURCE) + "/resources/robots/format.md"));
  std::string section, line;
  std::smatch found;
  while (std::getline(in, line)) {
    if (line == "## The file")
      section.clear();
    else if (std::regex_search(line, found, kHead))
      section = found[1];
    else if (std::regex_search(line, found, kKey))
      keys[section].insert(found[1]);
  }
  keys["scenario"] = keys["preset"];
  return keys;
}

std::vector<const TomlNode*> tablesOf(const TomlNode& node) {
  std::vector<const TomlNode*> tables;
  for (const TomlNode& element : node.list) tables.push_back(&element);
  for (const auto& [name, element] : node.table)
    if (element.kind == TomlNode::Kind::Table) tables.push_back(&element);
  if (tables.empty()) tables.push_back(&node);
  return tables;
}

}  // namespace

TEST(RobotFormat, ExplainsEveryKeyOfTheRobotsThatComeWithTheProgram) {
  const auto keys = explained();
  for (const char* name :
       {"acrobot", "ball-beam", "biped", "cart-pole", "compass", "hopper", "leo", "pendulum", "segway"}) {
    std::vector<Complaint> complaints;
    const auto root = parseToml(robotText(name), complaints);
    ASSERT_TRUE(root);
    for (const auto& [section, node] : root->table) {
      if (node.kind != TomlNode::Kind::Table && node.kind != TomlNode::Kind::List) {
        EXPECT_TRUE(keys.at("").contains(section)) << name << ": " << section;
        continue;
      }
      if (section == "constants" || section == "learning" || section == "start" || section == "return") continue;
      ASSERT_TRUE(keys.contains(section)) << name << ": " << section;
      for (const TomlNode* table : tablesOf(node))
        for (const auto& [key, value] : table->table) {
          EXPECT_TRUE(keys.at(section).contains(key)) << name << ": [" << section << "] " << key;
          if (key != "shape") continue;
          for (const TomlNode* shape : tablesOf(value))
            for (const auto& [of, number] : shape->table)
              EXPECT_TRUE(keys.at("shape").contains(of)) << name << ": shape, " << of;
        }
    }
  }
}

TEST(RobotFormat, ExplainsNoKeyThatThereIsNot) {
  const auto list = [](const std::string& s) {
    return std::set<std::string>{"parameter", "memory", "state", "ending", "event", "reward", "measure"}.contains(s);
  };
  const auto named = [](const std::string& s) {
    return std::set<std::string>{"body", "joint", "actuator", "point", "ray", "preset", "scenario"}.contains(s);
  };
  int known = 0;
  for (const auto& [section, keys] : explained())
    for (const std::string& key : keys) {
      if (section == "start" || section == "learning" || key == "like" || (section == "shape" && key == "to")) continue;
      std::string text = section.empty()      ? key + " = true\n"
                         : section == "shape" ? "[body.b]\nshape = [{ " + key + " = true }]\n"
                                              : fmt::format("{}\n{} = true\n",
                                                            list(section)    ? "[[" + section + "]]"
                                                            : named(section) ? "[" + section + ".n]"
                                                                             : "[" + section + "]",
                                                            key);
      if (list(section) && key != "key") text += "key = \"k\"\n";
      std::vector<Complaint> complaints;
      static_cast<void>(readRobot(text, complaints));
      for (const Complaint& c : complaints)
        EXPECT_EQ(c.sentence.find("\"" + key + "\" here"), std::string::npos) << section << ": " << c.sentence;
      ++known;
    }
  EXPECT_GT(known, 150);
}

}  // namespace surefoot
