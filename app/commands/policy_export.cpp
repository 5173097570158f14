// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot export FILE --c policy.c`: the greedy policy of a Q-function as C.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/commands/commands.h"
#include "app/commands/stored_function.h"
#include "app/process/exit_code.h"
#include "core/basics/random.h"
#include "core/basics/typed_json.h"
#include "core/c_policy/c_policy.h"
#include "core/files/whole_file.h"

namespace surefoot {

namespace {

/// A state anywhere in the range of its variables.
std::vector<double> anyState(const Task& task, Random& random) {
  std::vector<double> state;
  for (const StateVariable& v : task.state) {
    const double at = random.uniform(v.low, v.high);
    state.push_back(v.whole ? std::round(at) : at);
  }
  return state;
}

/// States in which one action is clearly the best, so that tables of float have the same one.
std::vector<KnownAction> knownActions(const StoredFunction& f) {
  constexpr int kWanted = 1000, kMostTries = 100'000;
  constexpr double kClear = 1e-4;  // of the largest value
  std::vector<KnownAction> known;
  Random random(1);
  std::vector<double> q(f.task().actions.size());
  for (int i = 0; i < kMostTries && known.size() < kWanted; ++i) {
    std::vector<double> state = anyState(f.task(), random);
    f.values().evaluate(state, Layer::Sum, q);
    const auto best = std::max_element(q.begin(), q.end());
    double second = -kInfinity, largest = 0.0;
    for (auto value = q.begin(); value != q.end(); ++value) {
      if (value != best) second = std::max(second, *value);
      largest = std::max(largest, std::abs(*value));
    }
    if (*best - second > kClear * largest) known.push_back({std::move(state), static_cast<int>(best - q.begin())});
  }
  return known;
}

std::string originOf(const StoredFunction& f, const std::string& path) {
  const Json& about = f.file->about;
  return fmt::format("From {}, content {}, after {} steps and {} episodes with {} falls; Surefoot {}.",
                     std::filesystem::path(path).filename().string(), contentOf(*f.file),
                     jsonText(about.value("/learned/steps"_json_pointer, Json(0))),
                     jsonText(about.value("/learned/episodes"_json_pointer, Json(0))),
                     jsonText(about.value("/learned/falls"_json_pointer, Json(0))),
                     about.value("program", "of an unknown version"));
}

}  // namespace

int exportPolicy(const Registry& registry, const ExportRequest& request) {
  const auto f = openFunction(registry, request.file);
  if (!f) return fail(f.error());
  CPolicySettings settings{.floats = request.floats, .known = {}, .origin = originOf(*f, request.file)};
  if (request.selfTest) settings.known = knownActions(*f);
  auto file = WholeFile::createNew("--c", *request.c);
  if (!file) return fail(file.error());
  fmt::print(stderr, "{}: tables of {:.1f} MB.\n", *request.c, tableBytesOf(*f->file, request.floats) / 1e6);
  const auto text = policyAsC(*f->file, f->task(), settings);
  if (!text) return fail(text.error());
  const Status written = file->commit(*text);
  return written ? kDone : fail(written.error());
}

}  // namespace surefoot
