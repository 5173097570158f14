// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/reading/robot_reading.h"

#include <algorithm>

#include "core/basics/hash64.h"
#include "physics/robot/reading/robot_text.h"
#include "physics/robot/reading/sections.h"

namespace surefoot {

namespace {

/// [body.thigh_r] with like = "thigh_l" has everything of that one but what it says itself.
void fillLike(TomlNode& tables, std::vector<Complaint>& complaints) {
  for (auto& [name, node] : tables.table) {
    const TomlNode* like = node.find("like");
    if (!like) continue;
    const TomlNode* model = tables.find(like->text);
    if (!model || model->find("like") || model == &node) {
      complaints.push_back({like->at, fmt::format("like: there is no \"{}\" that stands for itself.", like->text)});
      continue;
    }
    TomlNode whole = *model;
    whole.at = node.at, whole.keyAt = node.keyAt;
    for (auto& [key, own] : node.table) {
      if (key == "like") continue;
      const auto same =
          std::find_if(whole.table.begin(), whole.table.end(), [&k = key](auto& w) { return w.first == k; });
      if (same == whole.table.end())
        whole.table.emplace_back(key, std::move(own));
      else
        same->second = std::move(own);
    }
    node = std::move(whole);
  }
}

enum class Form { Table, Named, List };  // [start], [body.NAME], [[state]]

constexpr std::pair<const char*, Form> kSections[] = {
    {"constants", Form::Table}, {"ground", Form::Table},   {"start", Form::Table},    {"picture", Form::Table},
    {"push", Form::Table},      {"learning", Form::Table}, {"body", Form::Named},     {"point", Form::Named},
    {"ray", Form::Named},       {"joint", Form::Named},    {"actuator", Form::Named}, {"preset", Form::Named},
    {"scenario", Form::Named},  {"parameter", Form::List}, {"memory", Form::List},    {"state", Form::List},
    {"ending", Form::List},     {"event", Form::List},     {"reward", Form::List},    {"measure", Form::List}};

/// Whether every section is written as it is meant: [body.NAME] and not [[body]].
void checkForms(const TomlNode& root, std::vector<Complaint>& complaints) {
  const auto isTable = [](const TomlNode& node) { return node.kind == TomlNode::Kind::Table; };
  for (const auto& [name, form] : kSections) {
    const TomlNode* node = root.find(name);
    if (!node) continue;
    bool right = form == Form::List ? node->kind == TomlNode::Kind::List : isTable(*node);
    for (const TomlNode& element : node->list) right &= isTable(element);
    if (form == Form::Named)
      for (const auto& [key, value] : node->table) right &= isTable(value);
    const char* shape = form == Form::List ? "[[{}]]" : form == Form::Named ? "[{}.NAME]" : "[{}]";
    if (!right)
      complaints.push_back({node->keyAt, fmt::format("it is written {}.", fmt::format(fmt::runtime(shape), name))});
  }
}

void readHead(TomlReader& reader, RobotReader& in) {
  RobotSpec& spec = in.spec();
  if (!reader.find("surefoot"))
    reader.complain("surefoot", "it is missing; the file begins with surefoot = \"robot 1\".");
  else if (const std::string format = reader.neededText("surefoot"); !format.empty() && format != "robot 1")
    reader.complain("surefoot", fmt::format("\"{}\" is no format of ours; it is \"robot 1\".", format));
  spec.name = reader.neededText("name");
  if (const std::string why = wrongRobotName(spec.name); !why.empty() && !spec.name.empty())
    reader.complain("name", why);
  spec.title = reader.text("title", spec.name);
  spec.help = reader.text("help");
  for (const auto& section : kSections) static_cast<void>(reader.find(section.first));
  for (const char* key : {"command", "sends"}) static_cast<void>(reader.find(key));  // read before all others
}

void readTimes(TomlReader& reader, RobotReader& in) {
  RobotSpec& spec = in.spec();
  spec.stepTime = in.needed(reader, "step_time");
  spec.maxSteps = in.number(reader, "max_steps", 1000);
  spec.testEvery = in.number(reader, "test_every", 0);
  spec.returns = in.pair(reader, "return", -1, 1);
  spec.substeps = in.number(reader, "substeps", 1);
  spec.velocityIterations = in.number(reader, "velocity_iterations", 8);
  spec.positionIterations = in.number(reader, "position_iterations", 3);
  spec.gravity = in.number(reader, "gravity", 9.81);
  spec.scale = in.number(reader, "scale", 1);
}

/// What a test of the greedy policy tells are measures.
void checkTests(const TomlNode& root, RobotReader& in) {
  const TomlNode* every = root.find("test_every");
  const bool none = every && every->kind != TomlNode::Kind::Text && every->number == 0.0;
  if (every && !none && in.spec().measures.empty())
    in.complaints().push_back(
        {every->keyAt,
         "test_every: a test of the greedy policy tells the robot's measures, and it has none; add a "
         "[[measure]], such as the distance."});
}

void readSections(const TomlNode& root, RobotReader& in) {
  TomlReader reader(root, in.complaints());
  readHead(reader, in);
  readParameters(root, in);
  readConstants(root, in);
  readTimes(reader, in);
  reader.end();
  refuseWorld(root, in);
  readBodies(root, in);
  readPoints(root, in);
  readJoints(root, in);
  readActuators(root, in);
  readGround(root, in);
  readMemories(root, in);
  readStates(root, in);
  readStart(root, in);
  readEndings(root, in);
  readRewards(root, in);
  checkTests(root, in);
  readPicture(root, in);
  readSettings(root, in);
}

/// Numbers and texts in the order of the file; of an expression's spaces none counts.
void addTo(Hash64& hash, const TomlNode& node) {
  hash.add(static_cast<std::uint64_t>(node.kind));
  for (const char c : node.text)
    if (c != ' ') hash.add(std::string_view(&c, 1));
  hash.add(node.number);
  hash.add(static_cast<std::uint64_t>(node.flag));
  for (const TomlNode& element : node.list) addTo(hash, element);
  for (const auto& [key, value] : node.table) hash.add(key), addTo(hash, value);
  hash.add(static_cast<std::uint64_t>(node.list.size() + node.table.size()));
}

void sortAndLimit(std::vector<Complaint>& complaints) {
  std::stable_sort(complaints.begin(), complaints.end(), [](const Complaint& a, const Complaint& b) {
    return std::pair(a.at.line, a.at.column) < std::pair(b.at.line, b.at.column);
  });
  if (complaints.size() > kMostComplaints) complaints.resize(kMostComplaints);
}

}  // namespace

std::shared_ptr<const RobotSpec> readRobot(std::string_view text, std::vector<Complaint>& complaints) {
  if (text.size() > kLongestRobot) {
    complaints.push_back({{}, fmt::format("a robot has at most {} kB.", kLongestRobot >> 10)});
    return nullptr;
  }
  auto root = parseToml(text, complaints);
  if (!root) return nullptr;
  checkForms(*root, complaints);
  if (!complaints.empty()) return nullptr;
  for (auto& [heading, tables] : root->table)
    if ((heading == "body" || heading == "joint" || heading == "actuator") && tables.kind == TomlNode::Kind::Table)
      fillLike(tables, complaints);
  auto spec = std::make_shared<RobotSpec>();
  Hash64 hash;
  addTo(hash, *root);
  spec->fingerprint = hash.value();
  RobotReader in(*spec, complaints);
  readChild(*root, in);
  collectNames(*root, in);
  if (complaints.empty()) readSections(*root, in);
  sortAndLimit(complaints);
  if (!complaints.empty()) return nullptr;
  return spec;
}

}  // namespace surefoot
