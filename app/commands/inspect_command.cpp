// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot inspect`: the contents and the origin of a file. Reads any safetensors file of ours, even one whose
// environment this program does not know.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <numeric>

#include "app/commands/commands.h"
#include "core/basics/typed_json.h"
#include "core/environment_library.h"
#include "core/experiment/task_description.h"
#include "core/saved/checkpoint.h"
#include "core/saved/q_file.h"
#include "core/saved/stored_function.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

struct Range {
  double low = 0.0, high = 0.0, mean = 0.0;
};

Range rangeOf(const Tensor& tensor) {
  std::vector<double> values(tensor.count());
  std::memcpy(values.data(), tensor.bytes.data(), tensor.bytes.size());
  if (values.empty()) return {};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high, std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size())};
}

nlohmann::ordered_json tensorsAsJson(const TensorFile& file) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Tensor& t : file.tensors) {
    nlohmann::ordered_json entry = {{"name", t.name}, {"dtype", nameOf(t.type)}, {"shape", t.shape}};
    if (t.type == ElementType::F64 && t.count() > 0) {
      const Range range = rangeOf(t);
      entry["lowest"] = range.low, entry["highest"] = range.high, entry["mean"] = range.mean;
    }
    list.push_back(std::move(entry));
  }
  return list;
}

/// "pendulum" at /configuration/environment, or "?".
std::string textAt(const Json& json, const char* pointer) {
  const auto at = nlohmann::json::json_pointer(pointer);
  if (!json.contains(at)) return "?";
  const Json& value = json[at];
  if (value.is_string()) return std::string(shortened(value.get_ref<const std::string&>()));
  return std::string(shortened(jsonText(value, -1, true)));
}

std::string asTable(const TensorFile& file) {
  const Json& about = file.about;
  std::string text;
  const auto row = [&](const char* name, const std::string& value) { text += fmt::format("{:<16}{}\n", name, value); };
  row("kind", fmt::format("{}, format {}, written by surefoot {}", textAt(about, "/kind"), textAt(about, "/format"),
                          textAt(about, "/program")));
  row("environment", fmt::format("{} {}, scenario {}", textAt(about, "/configuration/environment"),
                                 textAt(about, "/configuration/preset"), textAt(about, "/configuration/scenario")));
  row("learned by", fmt::format("{}, {}, {}, seed {}", textAt(about, "/configuration/agent"),
                                textAt(about, "/configuration/features"), textAt(about, "/configuration/policy"),
                                textAt(about, "/seed")));
  row("in", fmt::format("{} steps, {} episodes, {} falls", textAt(about, "/learned/steps"),
                        textAt(about, "/learned/episodes"), textAt(about, "/learned/falls")));
  row("average reward", textAt(about, "/learned/average_reward"));
  if (about.contains("began_with") && !about["began_with"].is_null())
    row("began with", fmt::format("{}, scenario learned {} episodes", textAt(about, "/began_with/file"),
                                  textAt(about, "/began_with/learned/episodes")));
  for (const Tensor& t : file.tensors) {
    std::string line = fmt::format("{} {}", nameOf(t.type), fmt::join(t.shape, " × "));
    if (t.type == ElementType::F64 && t.count() > 0) {
      const Range range = rangeOf(t);
      line += fmt::format(", {:.6g} … {:.6g}, mean {:.6g}", range.low, range.high, range.mean);
    }
    text += fmt::format("{:<36} {}\n", shortened(t.name), line);
  }
  return text;
}

/// Whether a life could go on from the file; not checked if this program does not know the environment.
Status checkWhole(const Registry& registry, const std::shared_ptr<const TensorFile>& file) {
  const Json name = file->about.value("/configuration/environment"_json_pointer, Json());
  if (!name.is_string()) return fileError(file->name, "its configuration names no environment.");
  if (!findEnvironment(registry, name.get<std::string>())) return Done{};
  if (file->about["kind"] == "checkpoint") {
    const auto resumed = resume(registry, file, {}, Versions::Any);
    return resumed ? Status(Done{}) : resumed.error();
  }
  const auto configuration = configurationOf(registry, *file);
  if (!configuration) return configuration.error();
  const auto environment = makeEnvironment(registry, *configuration);
  if (!environment) return environment.error();
  if (const Status s = checkTask(*file, (*environment)->task()); !s) return s;
  const auto agent = makeAgent(registry, *configuration, (*environment)->task(), file.get());
  return agent ? Status(Done{}) : agent.error();
}

}  // namespace

int inspectCommand(const Registry& registry, const InspectRequest& request) {
  if (request.file.empty()) return fail({"FILE: the name of a file is needed."});
  const auto file = readQFile(request.file);
  if (!file) return fail(file.error());
  if (const Status s = checkWhole(registry, *file); !s) return fail(s.error());
  if (!request.json) return print(asTable(**file));
  nlohmann::ordered_json json = {{"about", (*file)->about}, {"tensors", tensorsAsJson(**file)}};
  return print(jsonText(json, 2, true) + "\n");
}

}  // namespace surefoot
