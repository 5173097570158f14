// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/inputs_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/files/limited_json.h"

namespace surefoot {

namespace {

using InputsJson = nlohmann::ordered_json;  // the order of its keys is that of the text

constexpr std::size_t kMostActionsTold = 10'000'000;

bool areNumbers(const InputsJson& list) {
  return list.is_array() && std::all_of(list.begin(), list.end(), [](const InputsJson& v) { return v.is_number(); });
}

bool readRandom(const InputsJson& words, EpisodeInputs& inputs) {
  if (!words.is_array() || words.size() != inputs.random.size()) return false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].is_string()) return false;
    const std::string text = words[i];
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), inputs.random[i], 16);
    if (code != std::errc{} || end != text.data() + text.size() || text.empty()) return false;
  }
  return std::any_of(inputs.random.begin(), inputs.random.end(), [](std::uint64_t word) { return word != 0; });
}

bool readActions(const InputsJson& list, const Task& task, EpisodeInputs& inputs) {
  if (!areNumbers(list) || list.size() > kMostActionsTold) return false;
  for (const InputsJson& value : list) {
    if (!value.is_number_integer()) return false;
    const auto action = value.get<std::int64_t>();
    const bool known = action >= 0 && action < std::ssize(task.actions);
    if (!known && !(task.handMade && action == kHandMade)) return false;
    inputs.actions.push_back(static_cast<std::uint16_t>(action));
  }
  return true;
}

bool readPushes(const InputsJson& list, EpisodeInputs& inputs) {
  if (!list.is_array()) return false;
  for (const InputsJson& push : list) {
    if (!areNumbers(push) || push.size() != 2 || !push[0].is_number_unsigned()) return false;
    const auto step = push[0].get<std::uint64_t>();
    const double impulse = push[1];
    const std::uint64_t last = inputs.pushSteps.empty() ? 0 : inputs.pushSteps.back();
    if (step < last || step > inputs.actions.size() || !(std::abs(impulse) <= 1e3)) return false;
    inputs.pushSteps.push_back(step);
    inputs.pushImpulses.push_back(impulse);
  }
  return true;
}

}  // namespace

std::string textOf(const EpisodeInputs& inputs) {
  InputsJson json;
  for (const std::uint64_t word : inputs.random) json["random"].push_back(fmt::format("{:x}", word));
  json["start"] = inputs.start;
  json["actions"] = InputsJson::array();
  for (std::size_t step = 0; step < inputs.actions.size(); ++step) json["actions"].push_back(inputs.actionAt(step));
  json["pushes"] = InputsJson::array();
  for (std::size_t i = 0; i < inputs.pushSteps.size(); ++i)
    json["pushes"].push_back({inputs.pushSteps[i], inputs.pushImpulses[i]});
  return json.dump();
}

Result<EpisodeInputs> inputsFrom(const std::string& text, const Task& task) {
  const auto wrong = [](const char* what) { return Error{fmt::format("go_on: {} is not as a journal has it.", what)}; };
  const InputsJson json = parseJson(text);
  if (!json.is_object()) return wrong("the episode");
  EpisodeInputs inputs;
  for (const char* part : {"random", "start", "actions", "pushes"})
    if (!json.contains(part)) return wrong(part);
  if (!readRandom(json["random"], inputs)) return wrong("random");
  if (!areNumbers(json["start"])) return wrong("start");
  inputs.start = json["start"].get<std::vector<double>>();
  if (!inputs.start.empty())
    if (const Status s = checkState(task, inputs.start); !s) return s.error();
  if (!readActions(json["actions"], task, inputs)) return wrong("actions");
  if (!readPushes(json["pushes"], inputs)) return wrong("pushes");
  return inputs;
}

}  // namespace surefoot
