// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/saved/q_file_tensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/files/refused_tensor.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

constexpr double kMany = 1e15;  // features: no file is as large

double numberAt(const Json& json, const char* key) {
  return json.is_object() && json.contains(key) && json[key].is_number() ? json[key].get<double>() : -1.0;
}

/// Number of features of an estimate by its layout (FeatureMap::layout); for a hashed table the largest number.
double featuresOf(const Json& layout) {
  if (const double memory = numberAt(layout, "memory"); memory >= 0) return memory;
  if (!layout.is_object() || !layout.contains("variables") || !layout["variables"].is_array()) return -1.0;
  double features = layout.contains("tilings") ? numberAt(layout, "tilings") : 1.0;
  for (const Json& v : layout["variables"]) {
    const double low = numberAt(v, "lowest"), high = numberAt(v, "highest");
    const double tiles = numberAt(v, "tiles"), centres = numberAt(v, "centres");
    features *= tiles >= 0 ? tiles : centres >= 0 ? centres : high - low + 1;
  }
  return features >= 0 && features < kMany ? std::round(features) : -1.0;
}

class Checker {
 public:
  explicit Checker(const TensorFile& file) : file_(file) {
    const auto list = [&](const char* key) {
      return file.about.contains("actions") && file.about["actions"].is_object() &&
                     file.about["actions"].contains(key) && file.about["actions"][key].is_array()
                 ? file.about["actions"][key].size()
                 : 0;
    };
    actions_ = static_cast<double>(std::max(list("values"), list("names")));
    const Json learned = file.about.value("learned", Json::object());
    episodes_ = std::max(0.0, numberAt(learned, "episodes"));
    steps_ = std::max(0.0, numberAt(learned, "steps"));
  }

  Status check() {
    if (!file_.about.contains("estimates") || !file_.about["estimates"].is_object())
      return fileError(file_.name, "its description names no estimates; the file is damaged.");
    for (const Tensor& t : file_.tensors)
      if (const Status s = checkValues(t); !s) return s;
    const bool life = file_.about["kind"] == "checkpoint";
    for (const Tensor& t : file_.tensors)
      if (!isValue(t))
        if (const Status s = life ? checkLife(t) : refuse(t, "belongs to none of its estimates"); !s) return s;
    return Done{};
  }

 private:
  bool isValue(const Tensor& t) const {
    const auto dot = t.name.find('.');
    return dot != t.name.npos && file_.about["estimates"].contains(t.name.substr(0, dot)) &&
           !t.name.starts_with("log.") && !t.name.starts_with("learning.");
  }

  Status checkValues(const Tensor& t) {
    if (!isValue(t)) return Done{};
    const auto dot = t.name.find('.');
    const Json& layout = file_.about["estimates"][t.name.substr(0, dot)];
    const double features = featuresOf(layout);
    const bool hashed = numberAt(layout, "memory") >= 0;
    if (features < 0) return fileError(file_.name, "the layout of an estimate is none; the file is damaged.");
    const std::string part = t.name.substr(dot + 1);
    const auto elements = static_cast<double>(t.elements());
    const auto fits = [&](double n) { return hashed ? n <= features : n == features; };
    if (part == "weights") {
      weights_ += elements;
      constexpr double kMostTiles = 16;  // tiles of an action, where actions share weights
      const double columns = t.shape.empty() ? 0.0 : static_cast<double>(t.shape.back());
      if (columns > std::max(1.0, kMostTiles * actions_)) return refuse(t, "has more columns than actions");
      return fits(columns > 0 ? elements / columns : 0.0) ? Status(Done{}) : refuse(t, "does not fit its layout");
    }
    if (part == "visits") return fits(elements) ? Status(Done{}) : refuse(t, "does not fit its layout");
    if (part == "tiles" && hashed) return fits(elements) ? Status(Done{}) : refuse(t, "does not fit its layout");
    if (part.starts_with("initial_") && hashed && elements == 1) return Done{};
    return refuse(t, "is none that an estimate has");
  }

  /// The additional tensors of a checkpoint.
  Status checkLife(const Tensor& t) const {
    const auto elements = static_cast<double>(t.elements());
    constexpr double kFew = 1000, kMarks = 1e6, kColumns = 32;
    const auto within = [&](double most) {
      return elements <= most ? Status(Done{}) : refuse(t, "has more elements than such a life can have");
    };
    if (t.name == "teacher") return Done{};  // a file of its own, which is checked as one
    if (t.name.starts_with("log.rows.")) return within(kColumns * episodes_);
    if (t.name == "greedy_tests") return within(kColumns * (episodes_ + 1));
    if (t.name.starts_with("episode.")) return within(steps_ + kMarks);
    if (t.name.starts_with("learning.")) return within(4 * weights_ + kMarks);
    for (const char* few : {"log.", "random.", "cut_off."})
      if (t.name.starts_with(few)) return within(kFew);
    for (const char* one : {"action", "environment_changed", "greedy_test_seed", "in_episode", "pre_learned", "steps"})
      if (t.name == one) return within(1);
    return refuse(t, "is none that a checkpoint has");
  }

  Status refuse(const Tensor& t, const char* why) const { return refusedTensor(file_, t.name, why); }

  const TensorFile& file_;
  double actions_ = 0, episodes_ = 0, steps_ = 0, weights_ = 0;
};

}  // namespace

Status checkTensors(const TensorFile& file) {
  return Checker(file).check();
}

}  // namespace surefoot
