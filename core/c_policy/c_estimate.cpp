// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/c_policy/c_estimate.h"

#include <fmt/format.h>

#include <cstring>

#include "core/c_policy/c_features.h"
#include "core/c_policy/c_text.h"
#include "core/features/action_tiles.h"

namespace surefoot {

namespace {

template <class T>
std::vector<T> valuesOf(const TensorFile& file, const std::string& name) {
  const Tensor* tensor = file.find(name);
  if (!tensor || tensor->type != elementTypeOf<T>()) return {};
  std::vector<T> values(tensor->count());
  std::memcpy(values.data(), tensor->bytes.data(), tensor->bytes.size());
  return values;
}

double oneOf(const TensorFile& file, const std::string& name) {
  const auto values = valuesOf<double>(file, name);
  return values.empty() ? 0.0 : values[0];
}

const Json& layoutOf(const TensorFile& file, const std::string& name) {
  return file.about["estimates"][name];
}

/// The columns of actions that share weights; none: each has its own.
Result<ActionTiles> actionTilesOf(const Json& layout, const Task& task) {
  std::vector<ActionTiles::Variable> variables;
  for (const Json& v : layout.value("action_tiles", Json::array()))
    variables.push_back({v["variable"], v["levels"].get<std::vector<double>>(), v["tiles_per_unit"]});
  const std::size_t tilings = layout.value("tilings", std::size_t{1});
  return ActionTiles::create(task.state.size(), tilings, task.actions.size(), variables);
}

/// The weights of rows that a hashed table has not claimed: what they begin with (LinearActionValue::grow).
std::string freshInC(const TensorFile& file, const std::string& name, int tilings) {
  const double low = oneOf(file, name + ".initial_low") / tilings, high = oneOf(file, name + ".initial_high") / tilings;
  if (low == high) return fmt::format("static double {}_fresh(uint64_t k) {{ (void)k; return {}; }}\n", name, inC(low));
  const auto seed = valuesOf<std::uint64_t>(file, name + ".initial_seed");
  return fmt::format(
      "static double {}_fresh(uint64_t k) {{\n"
      "  const double unit = (double)(mixed({}u + (k + 1u) * 0x9e3779b97f4a7c15u) >> 11) / "
      "9007199254740992.0;\n  return {} + {} * unit;\n}}\n",
      name, seed.empty() ? 0 : seed[0], inC(low), inC(high - low));
}

}  // namespace

double tableBytesOf(const TensorFile& file, const std::string& name, bool floats) {
  const Tensor *weights = file.find(name + ".weights"), *tiles = file.find(name + ".tiles");
  double bytes = weights ? static_cast<double>(weights->elements()) * (floats ? 4.0 : 8.0) : 0.0;
  if (tiles) bytes += 8.0 * static_cast<double>(tiles->elements()) + 4.0 * layoutOf(file, name).value("memory", 0.0);
  return bytes;
}

Result<std::string> estimateInC(const TensorFile& file, const std::string& name, const Task& task, bool floats) {
  const Json& layout = layoutOf(file, name);
  const auto tiles = valuesOf<std::uint64_t>(file, name + ".tiles");
  const auto features = featuresInC(name, layout, tiles);
  if (!features) return fileError(file.name, features.error().message);
  const auto shared = actionTilesOf(layout, task);
  if (!shared) return fileError(file.name, shared.error().message);

  const std::vector<double> weights = valuesOf<double>(file, name + ".weights");
  const bool hashed = file.find(name + ".tiles") != nullptr;
  const std::size_t actions = task.actions.size(), columns = shared->count();
  std::string text = features->text;
  text += floats ? floatArrayInC(name + "_weight", weights) : arrayInC("double", name + "_weight", weights);
  if (shared->shared()) {
    std::vector<std::uint64_t> all;
    for (int i = 0; i < features->most; ++i)
      for (const std::uint16_t column : shared->columnsOf(static_cast<std::size_t>(i))) all.push_back(column);
    text += arrayInC("uint16_t", name + "_column", std::span<const std::uint64_t>(all));
  }
  std::string weight = fmt::format("{}_weight[k]", name);
  if (hashed) {
    text += freshInC(file, name, features->most);
    weight = fmt::format("(k < {}u ? {} : {}_fresh(k))", weights.size(), weight, name);
  }
  const std::string column = shared->shared() ? fmt::format("{}_column[i * {} + a]", name, actions) : "(uint64_t)a";
  return text + fmt::format(
                    "static void {0}_values(const double s[], double q[]) {{\n"
                    "  uint32_t x[{1}];\n  double value[{2}];\n  int i, a;\n"
                    "  const int count = {0}_features(s, x, value);\n"
                    "  for (a = 0; a < {3}; ++a) {{\n    double sum = 0.0;\n"
                    "    for (i = 0; i < count; ++i) {{\n"
                    "      const uint64_t k = (uint64_t)x[i] * {4}u + {5};\n      sum += {6}{7};\n    }}\n"
                    "    q[a] = sum;\n  }}\n}}\n",
                    name, features->most, features->binary ? 1 : features->most, actions, columns, column, weight,
                    features->binary ? "" : " * value[i]");
}

}  // namespace surefoot
