// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/words.h"
#include "physics/robot/reading/sections.h"

namespace surefoot {

namespace {

using Start = StartSpec::What;

/// "hinge.angle" → of the joint hinge, its position.
std::optional<StartSpec> coordinate(const std::string& key, const TomlNode& node, RobotReader& in) {
  const auto complain = [&](std::string sentence) {
    in.complaints().push_back({node.keyAt, std::move(sentence)});
    return std::nullopt;
  };
  const auto dot = key.find('.');
  const RobotNames::Name* found = in.spec().names.find(key.substr(0, dot));
  const std::string part = dot == std::string::npos ? "" : key.substr(dot + 1);
  if (!found || (found->kind != NameKind::Joint && found->kind != NameKind::Body)) {
    auto names = in.spec().names.all(NameKind::Joint);
    for (const std::string& body : in.spec().names.all(NameKind::Body)) names.push_back(body);
    const std::string near = nearestWord(key.substr(0, dot), names);
    return complain(fmt::format("there is no joint or body \"{}\"{}.", key.substr(0, dot),
                                near.empty() ? "" : fmt::format(" (did you mean {}?)", near)));
  }
  StartSpec start{.ofBody = found->kind == NameKind::Body, .index = found->index};
  if (part == "rate")
    start.what = Start::Rate;
  else if (part == "angle" || (part == "position" && !start.ofBody))
    start.what = Start::Position;
  else if (start.ofBody && part == "x")
    start.what = Start::X;
  else if (start.ofBody && part == "y")
    start.what = Start::Y;
  else if (start.ofBody && part == "vx")
    start.what = Start::Vx;
  else if (start.ofBody && part == "vy")
    start.what = Start::Vy;
  else
    return complain(fmt::format("\"{}\" has no \"{}\" to begin with; it has {}.", found->text, part,
                                start.ofBody ? "x, y, angle, vx, vy and rate" : "angle, position and rate"));
  return start;
}

constexpr std::pair<const char*, Ink> kLineInks[] = {{"outline", Ink::Outline},
                                                     {"solid", Ink::Solid},
                                                     {"body", Ink::Body},
                                                     {"quiet", Ink::Quiet},
                                                     {"hairline", Ink::Hairline}};

}  // namespace

void readStart(const TomlNode& root, RobotReader& in) {
  const TomlNode* all = root.find("start");
  for (const auto& [key, node] : all ? all->table : decltype(all->table){}) {
    if (key == "on_ground") {
      in.spec().onGround = node.flag;
      if (node.kind != TomlNode::Kind::Flag) in.complaints().push_back({node.at, "on_ground: it takes true or false."});
    } else if (key == "at_rest") {
      in.spec().atRest = in.indexOf(node, NameKind::Point).value_or(-1);
    } else if (auto start = coordinate(key, node, in)) {
      if (const auto value = in.formula(node, key, RobotReader::Where::Start)) start->value = *value;
      in.spec().start.push_back(std::move(*start));
    }
  }
}

void readPicture(const TomlNode& root, RobotReader& in) {
  static const TomlNode kEmpty{};
  const TomlNode *picture = root.find("picture"), *push = root.find("push");
  PictureSpec& spec = in.spec().picture;
  TomlReader reader(picture ? *picture : kEmpty, in.complaints());
  spec.height = in.maybe(reader, "height");
  spec.width = in.maybe(reader, "width");
  spec.follow = in.indexOf(reader, "follow", NameKind::Point);
  spec.tip = in.indexOf(reader, "tip", NameKind::Point);
  spec.metres = reader.flag("metres", true);
  for (const TomlNode* node : reader.tables("line")) {
    TomlReader line(*node, in.complaints());
    for (const char* key : {"from", "to"}) line.need(key);
    PictureLineSpec& drawn = spec.lines.emplace_back();
    drawn.from = in.indexOf(line, "from", NameKind::Point, 0);
    drawn.to = in.indexOf(line, "to", NameKind::Point, 0);
    drawn.ink = in.choice(line, "ink", kLineInks, Ink::Outline);
    drawn.width = line.number("width", 0.1, 50, 1);
    drawn.dashed = line.flag("dashed");
    line.end();
  }
  for (const TomlNode* node : reader.tables("label")) {
    TomlReader label(*node, in.complaints());
    for (const char* key : {"at", "text"}) label.need(key);
    PictureLabelSpec& drawn = spec.labels.emplace_back();
    drawn.at = in.indexOf(label, "at", NameKind::Point, 0);
    drawn.text = label.text("text");
    label.end();
  }
  reader.end();
  if (!push) return;
  TomlReader pushes(*push, in.complaints());
  pushes.need("point");
  in.spec().push = in.indexOf(pushes, "point", NameKind::Point);
  pushes.end();
}

}  // namespace surefoot
