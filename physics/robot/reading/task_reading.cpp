// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/text/words.h"
#include "physics/robot/reading/sections.h"

namespace surefoot {

namespace {

using Where = RobotReader::Where;

/// Of a state: as the file says, or the number of this name that a program sends.
Formula valueOf(const TomlNode& node, const std::string& key, TomlReader& reader, RobotReader& in) {
  if (in.spec().child.command.empty() || reader.find("value"))
    return in.needed(reader, "value", Where::Moving, ValueKind::Flag);
  TomlNode sent{.kind = TomlNode::Kind::Text, .at = node.at, .text = "child." + key};
  return in.formula(sent, "value", Where::Moving).value_or(Formula{});
}

StateSpec readState(const TomlNode& node, RobotReader& in) {
  TomlReader reader(node, in.complaints());
  StateSpec state;
  state.place = node.at;
  state.words.key = reader.text("key");
  std::string usual = state.words.key;
  std::replace(usual.begin(), usual.end(), '_', ' ');
  state.words.title = reader.text("title", usual);
  state.words.symbol = reader.text("symbol", usual);
  state.words.unit = reader.text("unit");
  state.words.spanText = reader.text("span_text", state.words.unit);
  state.words.perSpan = reader.text("per_span", state.words.unit.empty() ? "" : "/" + state.words.unit);
  state.words.whole = reader.flag("whole");
  state.value = valueOf(node, state.words.key, reader, in);
  if (const TomlNode* range = reader.need("range")) state.place = range->at;
  state.range = in.pair(reader, "range", 0, 1);
  state.view = in.maybePair(reader, "view");
  state.width = in.maybe(reader, "width");
  state.resolution = in.maybe(reader, "resolution");
  state.span = in.maybe(reader, "span");
  state.wrap = reader.flag("wrap");
  reader.end();
  if (state.width && (state.resolution || state.span))
    reader.complain("width", "the width of a tile and a resolution say the same; give one of them.");
  return state;
}

EndingSpec readEnding(const TomlNode& node, RobotReader& in, bool ends) {
  using Ends = EndingSpec::Kind;
  constexpr std::pair<const char*, Ends> kKinds[] = {
      {"fall", Ends::Fall}, {"goal", Ends::Goal}, {"out", Ends::Out}, {"time", Ends::Time}};
  TomlReader reader(node, in.complaints());
  EndingSpec ending;
  reader.need("kind");
  ending.kind = in.choice(reader, "kind", kKinds, Ends::Fall);
  ending.name = reader.text("name", reader.text("kind"));
  if (const TomlNode* when = reader.find("when")) ending.text = when->text;
  ending.when = in.needed(reader, "when", Where::Moving, ValueKind::Condition);
  reader.end();
  if (!ends && ending.kind != Ends::Fall && ending.kind != Ends::Goal)
    reader.complain("kind", "an event is a fall or a goal.");
  return ending;
}

std::string noEnding(const std::string& name, const std::vector<EndingSpec>& endings) {
  std::vector<std::string> names;
  for (const EndingSpec& ending : endings) names.push_back(ending.name);
  const std::string near = nearestWord(name, names);
  return fmt::format("there is no [[ending]] named \"{}\"{}.", name,
                     near.empty() ? "" : fmt::format(" (did you mean {}?)", near));
}

RewardSpec readReward(const TomlNode& node, RobotReader& in) {
  TomlReader reader(node, in.complaints());
  RewardSpec reward{.name = reader.neededText("name")};
  if (reward.name == "shaping" || reward.name == "price_of_fall")
    reader.complain("name", fmt::format("{} is what the learner calls a reward of its own.", reward.name));
  const TomlNode* potential = reader.find("potential");
  reward.potential = potential != nullptr;
  if (!potential) reader.need("value");
  if (potential && reader.find("value")) reader.complain("value", "a potential is a value already.");
  if (const auto value = in.maybe(reader, potential ? "potential" : "value", Where::Moving)) reward.value = *value;
  reward.when = in.maybe(reader, "when", Where::Moving, ValueKind::Flag);
  if (const TomlNode* on = reader.find("on")) {
    const auto& endings = in.spec().endings;
    const auto found = std::find_if(endings.begin(), endings.end(), [&](const auto& e) { return e.name == on->text; });
    if (found != endings.end())
      reward.ending = static_cast<int>(found - endings.begin());
    else
      in.complaints().push_back({on->at, noEnding(on->text, endings)});
  }
  reader.end();
  return reward;
}

MeasureSpec readMeasure(const TomlNode& node, RobotReader& in) {
  TomlReader reader(node, in.complaints());
  MeasureSpec measure;
  measure.words.key = reader.neededText("key");
  std::string usual = measure.words.key;
  std::replace(usual.begin(), usual.end(), '_', ' ');
  measure.words.title = reader.text("title", usual);
  measure.words.unit = reader.text("unit");
  const TomlNode *each = reader.find("each"), *last = reader.find("last");
  measure.adds = each != nullptr;
  if (!each == !last)
    in.complaints().push_back({node.at, "a measure has each, which is added up, or last, the newest value."});
  if (const auto value = in.maybe(reader, each ? "each" : "last", Where::Moving, ValueKind::Flag))
    measure.value = *value;
  reader.end();
  return measure;
}

void limitTables(const TomlNode& root, const char* key, std::size_t count, std::size_t most, RobotReader& in) {
  if (count > most)
    in.complaints().push_back(
        {root.find(key)->at, fmt::format("{}: {} of them; at most {} are allowed.", key, count, most)});
}

}  // namespace

void readMemories(const TomlNode& root, RobotReader& in) {
  constexpr std::pair<const char*, bool> kWhen[] = {{"step", false}, {"substep", true}};
  TomlReader all(root, in.complaints());
  for (const TomlNode* node : all.tables("memory")) {
    TomlReader reader(*node, in.complaints());
    MemorySpec& memory = in.spec().memories.emplace_back();
    static_cast<void>(reader.text("key"));
    memory.hasStart = reader.find("start") != nullptr;
    memory.start = in.number(reader, "start", 0);
    memory.each = in.needed(reader, "each", Where::Moving, ValueKind::Flag);
    memory.substep = in.choice(reader, "when", kWhen, false);
    if (memory.substep && in.spec().names.hasChild())
      reader.complain("when", "a program that moves the robot has no substeps.");
    reader.end();
  }
}

void readStates(const TomlNode& root, RobotReader& in) {
  TomlReader all(root, in.complaints());
  for (const TomlNode* node : all.tables("state")) in.spec().states.push_back(readState(*node, in));
  if (in.spec().states.empty()) in.complaints().push_back({{1, 1}, "there is no [[state]]: nothing can be learned."});
}

void readEndings(const TomlNode& root, RobotReader& in) {
  TomlReader all(root, in.complaints());
  for (const TomlNode* node : all.tables("ending")) in.spec().endings.push_back(readEnding(*node, in, true));
  for (const TomlNode* node : all.tables("event")) in.spec().events.push_back(readEnding(*node, in, false));
  limitTables(root, "ending", in.spec().endings.size(), 32, in);
  limitTables(root, "event", in.spec().events.size(), 32, in);
}

void readRewards(const TomlNode& root, RobotReader& in) {
  TomlReader all(root, in.complaints());
  for (const TomlNode* node : all.tables("reward")) in.spec().rewards.push_back(readReward(*node, in));
  for (const TomlNode* node : all.tables("measure")) in.spec().measures.push_back(readMeasure(*node, in));
  limitTables(root, "reward", in.spec().rewards.size(), kMaxTaskTerms, in);
  limitTables(root, "measure", in.spec().measures.size(), kMaxMeasures, in);
  if (in.spec().rewards.empty()) in.complaints().push_back({{1, 1}, "there is no [[reward]]: nothing is good or bad."});
}

}  // namespace surefoot
