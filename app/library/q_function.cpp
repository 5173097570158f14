// SPDX-License-Identifier: GPL-3.0-or-later
// Q-functions from files.
#include <algorithm>

#include "app/library/description.h"
#include "app/library/handle.h"
#include "app/library/learned.h"
#include "app/library/ours.h"
#include "core/basics/typed_json.h"
#include "core/experiment/configuration_json.h"
#include "core/files/limited_json.h"
#include "core/saved/stored_function.h"

using namespace surefoot;

struct surefoot_q_function : Handle {
  StoredFunction function{};
  std::unique_ptr<Policy> policy{};
  std::string path{};
};

namespace {

/// The policy of a file, or another, with some values on top.
Result<std::unique_ptr<Policy>> policyOf(const StoredFunction& f, const char* name, const char* parameters) {
  const auto texts = assignmentsIn(parameters ? parseJson(parameters) : nlohmann::json());
  if (!texts) return texts.error();
  return policyOn(**ourRegistry(), f, name ? name : f.configuration.names.policy, *texts);
}

}  // namespace

surefoot_status surefoot_q_function_open(const char* file, surefoot_q_function** q) {
  return makeHandle(q, [&]() -> Result<std::unique_ptr<surefoot_q_function>> {
    const auto registry = ourRegistry();
    if (!registry) return registry.error();
    const auto path = given(file, "file");
    if (!path) return path.error();
    auto function = openFunction(**registry, *path);
    if (!function) return function.error();
    auto made = std::make_unique<surefoot_q_function>();
    made->function = std::move(*function);
    made->path = *path;
    auto policy = policyOf(made->function, nullptr, nullptr);
    if (!policy) return policy.error();
    made->policy = std::move(*policy);
    return made;
  });
}

surefoot_status surefoot_q_function_close(surefoot_q_function* q) {
  return closeHandle(q);
}

surefoot_status surefoot_q_function_about(surefoot_q_function* q, const char** json) {
  return call(q, "q", [&](surefoot_q_function& h) {
    const StoredFunction& f = h.function;
    const OrderedJson about = {{"configuration", configurationAsJson(f.configuration)},
                               {"origin", originOf(*f.file, h.path)},
                               {"content", contentOf(*f.file)},
                               {"layers", layersOf(f.values())},
                               {"task", aboutWorld(*f.environment, f.configuration)}};
    return handOut(h, jsonText(about), json);
  });
}

surefoot_status surefoot_q_function_values(surefoot_q_function* q, int32_t layer, const double* states, size_t n,
                                           double* values, size_t count) {
  return call(q, "q", [&](surefoot_q_function& h) {
    return valuesOf(h.function.values(), h.function.task(), layer, {states, n}, values, count);
  });
}

surefoot_status surefoot_q_function_follow(surefoot_q_function* q, const char* policy, const char* parameters) {
  return call(q, "q", [&](surefoot_q_function& h) -> Status {
    auto made = policyOf(h.function, policy, parameters);
    if (!made) return made.error();
    h.policy = std::move(*made);
    return Done{};
  });
}

surefoot_status surefoot_q_function_probabilities(surefoot_q_function* q, const double* states, size_t n, double* pi,
                                                  size_t count) {
  return call(q, "q", [&](surefoot_q_function& h) {
    return probabilitiesOf(h.function.values(), h.function.task(), *h.policy, {states, n}, pi, count);
  });
}

surefoot_status surefoot_q_function_visits(surefoot_q_function* q, const double* states, size_t n, double* visits,
                                           size_t count) {
  return call(q, "q", [&](surefoot_q_function& h) {
    return visitsOf(h.function.values(), h.function.task(), {states, n}, visits, count);
  });
}
