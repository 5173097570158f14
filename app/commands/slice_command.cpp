// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot slice`: a plane through a Q-function, one row per point.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/commands/action_text.h"
#include "app/commands/commands.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "app/requests/requests.h"
#include "core/files/whole_file.h"
#include "core/saved/stored_function.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

/// Two different state variables from "pole_angle,pole_rate".
Result<std::pair<std::size_t, std::size_t>> parseAxes(const std::string& text, const Task& task) {
  std::vector<std::string> names;
  for (const StateVariable& v : task.state) names.push_back(v.key);
  if (names.size() < 2)
    return Error{fmt::format("--axes: a plane needs two state variables, and the environment has one, {}.", names[0])};
  const auto comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
    return Error{
        fmt::format("--axes: \"{}\" does not name two variables, such as {},{}.", shortened(text), names[0], names[1])};
  std::size_t axes[2];
  for (int i = 0; i < 2; ++i) {
    const std::string name = i == 0 ? text.substr(0, comma) : text.substr(comma + 1);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return unknownName("--axes", name, names);
    axes[i] = static_cast<std::size_t>(found - names.begin());
  }
  if (axes[0] == axes[1])
    return Error{fmt::format("--axes: {} is named twice; two variables are needed.", names[axes[0]])};
  return std::pair{axes[0], axes[1]};
}

/// The i-th of n points over the range of a variable; whole numbers stay whole.
double pointOf(const StateVariable& v, std::int64_t i, std::int64_t n) {
  return n == 1 ? (v.low + v.high) / 2 : v.low + (v.high - v.low) * static_cast<double>(i) / static_cast<double>(n - 1);
}
std::int64_t pointsOf(const StateVariable& v, std::int64_t points) {
  return v.whole ? static_cast<std::int64_t>(v.high - v.low) + 1 : points;
}

/// The table; as far as it came, if `interrupted`.
std::string sliceAsCsv(const StoredFunction& f, std::pair<std::size_t, std::size_t> axes, std::vector<double> state,
                       std::int64_t points, const std::atomic<bool>& interrupted) {
  const Task& task = f.task();
  const StateVariable &x = task.state[axes.first], &y = task.state[axes.second];
  const std::size_t actions = task.actions.size();
  std::vector<std::pair<Layer, const char*>> layers = {{Layer::Sum, "q"}};
  if (f.values().split())
    layers.insert(layers.end(), {{Layer::Positive, "q_positive"}, {Layer::Negative, "q_negative"}});
  if (f.values().hasRisk()) layers.emplace_back(Layer::Risk, "risk");

  fmt::memory_buffer out;
  const auto to = std::back_inserter(out);
  fmt::format_to(to, "{},{}", x.key, y.key);
  for (const auto& [layer, name] : layers)
    for (std::size_t a = 0; a < actions; ++a) fmt::format_to(to, ",{} {}", name, actionText(task, a));
  fmt::format_to(to, ",greedy,visits\n");
  std::vector<double> q(actions);
  for (std::int64_t j = 0; j < pointsOf(y, points) && !interrupted; ++j)
    for (std::int64_t i = 0; i < pointsOf(x, points); ++i) {
      state[axes.first] = pointOf(x, i, pointsOf(x, points));
      state[axes.second] = pointOf(y, j, pointsOf(y, points));
      fmt::format_to(to, "{},{}", state[axes.first], state[axes.second]);
      std::size_t best = 0;
      for (const auto& [layer, name] : layers) {
        f.values().evaluate(state, layer, q);
        if (layer == Layer::Sum) best = static_cast<std::size_t>(std::max_element(q.begin(), q.end()) - q.begin());
        for (const double value : q) fmt::format_to(to, ",{}", value);
      }
      fmt::format_to(to, ",{},{}\n", actionText(task, best), f.values().visits(state));
    }
  return fmt::to_string(out);
}

}  // namespace

int sliceCommand(const Registry& registry, const SliceRequest& request) {
  if (!request.axes) return fail({"--axes: two state variables are needed, such as --axes pole_angle,pole_rate."});
  if (!request.out) return fail({"--out: the name of a file is needed, such as --out slice.csv."});
  const auto points = request.points ? parseCount("--points", *request.points, 2000) : Result<std::int64_t>(101);
  if (!points) return fail(points.error());
  auto function = openFunction(registry, request.file);
  if (!function) return fail(function.error());
  const auto axes = parseAxes(*request.axes, function->task());
  if (!axes) return fail(axes.error());
  const auto state = request.at ? parseState("--at", *request.at, function->task())
                                : Result<std::vector<double>>(std::vector<double>(function->task().state.size(), 0.0));
  if (!state) return fail(state.error());
  auto file = WholeFile::createNew("--out", *request.out);
  if (!file) return fail(file.error());
  const std::atomic<bool>& interrupted = watchForInterrupt();
  const std::string table = sliceAsCsv(*function, *axes, *state, *points, interrupted);
  if (interrupted) return fail({"interrupted; nothing is written.", ErrorKind::Interrupted});
  const Status written = file->commit(table);
  return written ? kDone : fail(written.error());
}

}  // namespace surefoot
