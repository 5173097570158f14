// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot resample`: a Q-function in another resolution, with the error that this makes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/commands/commands.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "app/requests/requests.h"
#include "core/basics/typed_json.h"
#include "core/files/whole_file.h"
#include "core/saved/carry_over.h"
#include "core/saved/stored_function.h"

namespace surefoot {

namespace {

constexpr const char* kRepresentation[] = {"features.", "positive.", "negative."};

/// The file's configuration with another representation.
Result<Configuration> newConfiguration(const StoredFunction& f, const std::vector<std::string>& texts) {
  const auto assignments = parseAssignments(texts);
  if (!assignments) return assignments.error();
  if (assignments->empty())
    return Error{"--set: a parameter of the representation is needed, such as --set features.scale=0.5."};
  Configuration c = f.configuration;
  for (const Assignment& a : *assignments) {
    if (const Status s = c.parameters.set(a.key, std::string_view(a.value)); !s) return s.error();
    const bool fits = std::any_of(std::begin(kRepresentation), std::end(kRepresentation),
                                  [&](const char* prefix) { return a.key.starts_with(prefix); }) &&
                      c.parameters.find(a.key)->parameter.when == When::NewTable;
    if (!fits) return Error{fmt::format("{}: only parameters of the representation can be changed here.", a.key)};
  }
  return c;
}

}  // namespace

int resampleCommand(const Registry& registry, const ResampleRequest& request) {
  if (!request.save) return fail({"--save: the name of a file is needed, such as --save coarse.safetensors."});
  auto old = openFunction(registry, request.file);
  if (!old) return fail(old.error());
  const auto configuration = newConfiguration(*old, request.assignments);
  if (!configuration) return fail(configuration.error());
  auto agent = makeAgent(registry, *configuration, old->task(), nullptr);
  if (!agent) return fail(agent.error());
  auto file = WholeFile::createNew("--save", *request.save);
  if (!file) return fail(file.error());

  const std::atomic<bool>& interrupted = watchForInterrupt();
  const CarriedError error = carryOver(old->values(), **agent, old->task(), &interrupted);
  if (interrupted) return fail({"interrupted; nothing is written.", ErrorKind::Interrupted});
  if (!std::isfinite(error.rms))
    return fail({"the function cannot be fitted in this representation; take more tiles or more memory."});
  Json origin = old->file->about.value("learned", Json::object());
  if (!origin.is_object()) origin = Json::object();
  origin["resampled_from"] = std::filesystem::path(request.file).filename().string();
  origin["resample_error"] = error.rms;
  const Status written = file->commit(qFileOf(**agent, old->task(), *configuration, origin).write());
  if (!written) return fail(written.error());
  if (request.json) {
    const nlohmann::ordered_json json = {{"rms_error", error.rms},
                                         {"rms_error_visited", error.rmsVisited},
                                         {"largest_error", error.largest},
                                         {"states", error.states},
                                         {"states_visited", error.visited}};
    return print(jsonText(json) + "\n");
  }
  return print(
      fmt::format("error over {} states: {:.4g} (RMS), {:.4g} at most; over the {} visited ones {:.4g} (RMS)\n",
                  error.states, error.rms, error.largest, error.visited, error.rmsVisited));
}

}  // namespace surefoot
