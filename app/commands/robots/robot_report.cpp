// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/robots/robot_report.h"

#include <fmt/format.h>

#include "core/text/text.h"
#include "physics/robot/child/program_files.h"
#include "physics/robot/reading/robot_reading.h"

namespace surefoot {

using nlohmann::ordered_json;

namespace {

std::string stateTable(const EnvironmentInspection& found) {
  std::string text =
      fmt::format("  {:<20}{:>22}{:>24}{:>10}{:>7}\n", "state", "file", "4,000 random steps", "outside", "tiles");
  for (const SeenState& s : found.states) {
    text += fmt::format("  {:<20}{:>22}{:>24}{:>9.1f}%{:>7}\n", s.key, fmt::format("{:.4g} … {:.4g}", s.low, s.high),
                        fmt::format("{:.4g} … {:.4g}", s.seenLow, s.seenHigh), 100 * s.outside, s.tiles);
    if (s.proposedLow != s.low || s.proposedHigh != s.high)
      text += fmt::format("  {:<20}proposed: range = [{:.4g}, {:.4g}]\n", "", s.proposedLow, s.proposedHigh);
  }
  return text;
}

std::string countOf(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string worldText(const EnvironmentInspection& found) {
  std::string text;
  if (found.passive.seconds > 0)
    text += fmt::format(
        "  without motors, dampers and friction it loses {:.1f} % of its motion a second ({:.1f} % with twice the "
        "substeps)\n",
        100 * found.passive.lossPerSecond(), 100 * found.halved.lossPerSecond());
  std::string joints;
  for (const auto& [name, soft] : found.joints)
    joints += fmt::format("{}{}{}", joints.empty() ? "" : ", ", name, soft ? " (soft)" : "");
  if (!joints.empty())
    text += fmt::format("  joints: {}; they part by at most {:.2g} mm\n", joints, 1000 * found.jointGap);
  if (found.smallestRadius > 0)
    text += fmt::format("  scale = {:.4g}: its smallest part that meets something is {:.2g} of Box2D's units\n",
                        found.scale, found.smallestRadius * found.scale);
  return text;
}

}  // namespace

std::string robotReport(const RobotSpec& spec, const EnvironmentInspection& found, const std::string& file) {
  std::size_t actions = 1;
  for (const ActuatorSpec& actuator : spec.actuators)
    if (!actuator.levels.empty()) actions *= actuator.levels.size();
  const std::string moved = spec.names.hasChild() ? fmt::format("moved by {}", commandText(spec))
                                                  : fmt::format("{}, {}", countOf(spec.bodies.size(), "body", "bodies"),
                                                                countOf(spec.joints.size(), "joint", "joints"));
  std::string text =
      fmt::format("{}: {}, {}, {} state variables, {} actions\n", file, spec.title, moved, spec.states.size(), actions);
  text += stateTable(found);
  text += fmt::format("  a dense table has {} tiles a tiling\n", countText(found.tiles));
  std::string endings;
  for (const SeenEnding& e : found.endings)
    endings += fmt::format("{}{} {}", endings.empty() ? "" : ", ", e.name, e.count);
  text += fmt::format("  endings: {}; {:.1f} steps an episode\n", endings, found.meanSteps);
  text += worldText(found);
  if (found.warnings.empty()) return text + "  nothing is doubtful\n";
  text += fmt::format("{} to look at:\n", found.warnings.size() == 1 ? "one thing" : "things");
  for (const Complaint& warning : found.warnings) text += complaintLine(file, warning) + "\n";
  return text;
}

ordered_json complaintsAsJson(const std::vector<Complaint>& complaints) {
  ordered_json list = ordered_json::array();
  for (const Complaint& c : complaints)
    list.push_back({{"line", c.at.line}, {"column", c.at.column}, {"sentence", c.sentence}});
  return list;
}

ordered_json robotReportAsJson(const RobotSpec& spec, const EnvironmentInspection& found) {
  ordered_json states = ordered_json::array(), endings = ordered_json::object(), joints = ordered_json::object();
  for (const SeenState& s : found.states)
    states.push_back({{"key", s.key},
                      {"unit", s.unit},
                      {"range", {s.low, s.high}},
                      {"seen", {s.seenLow, s.seenHigh}},
                      {"outside", s.outside},
                      {"proposed", {s.proposedLow, s.proposedHigh}},
                      {"tiles", s.tiles},
                      {"histogram", s.bins}});
  for (const SeenEnding& e : found.endings) endings[e.name] = e.count;
  for (const auto& [name, soft] : found.joints) joints[name] = soft ? "soft" : "hard";
  return {{"name", spec.name},
          {"title", spec.title},
          {"states", states},
          {"tiles", found.tiles},
          {"endings", endings},
          {"mean_steps", found.meanSteps},
          {"flew_apart", found.flewApart},
          {"loss_a_second", found.passive.lossPerSecond()},
          {"loss_a_second_halved", found.halved.lossPerSecond()},
          {"joints", joints},
          {"joint_gap", found.jointGap},
          {"scale", found.scale},
          {"proposed_scale", found.proposedScale}};
}

}  // namespace surefoot
