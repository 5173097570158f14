// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot query`: Q, Q⁺, Q⁻ and π of one state.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/requests.h"
#include "app/stored_function.h"

namespace surefoot {

namespace {

struct Answer {
  std::vector<double> q, positive, negative, pi;
  std::string policy;
  double visits = 0.0;
};

Result<Answer> answer(const Registry& registry, const QueryRequest& request, StoredFunction& f,
                      const std::vector<double>& state) {
  Answer a;
  a.policy = request.policy.value_or(f.configuration.names.policy);
  const auto assignments = parseAssignments(request.assignments);
  if (!assignments) return assignments.error();
  if (const Status s = checkPolicyKeys(registry, a.policy, *assignments); !s) return s.error();
  for (const Assignment& assignment : *assignments) {
    if (!assignment.key.starts_with("policy."))
      return Error{fmt::format("{}: only parameters of the policy have a meaning here.", assignment.key)};
    if (const Status s = f.configuration.parameters.set(assignment.key, std::string_view(assignment.value)); !s)
      return s.error();
  }
  const auto policy = makePolicy(registry, a.policy, f.configuration.parameters);
  if (!policy) return policy.error();

  a.q.resize(f.task().actions.size());
  a.pi.resize(a.q.size());
  f.values().evaluate(state, Layer::Sum, a.q);
  (*policy)->advance({});
  (*policy)->probabilities(a.q, a.pi);
  a.visits = f.values().visits(state);
  if (!f.values().split()) return a;
  for (const auto& [layer, part] : {std::pair{Layer::Positive, &a.positive}, std::pair{Layer::Negative, &a.negative}}) {
    part->resize(a.q.size());
    f.values().evaluate(state, layer, *part);
  }
  return a;
}

std::string asJson(const StoredFunction& f, const std::vector<double>& state, const Answer& a) {
  nlohmann::ordered_json json = {{"state", state}, {"actions", nlohmann::ordered_json::array()}, {"q", a.q}};
  for (std::size_t i = 0; i < a.q.size(); ++i) json["actions"].push_back(actionText(f.task(), i));
  if (f.values().split()) json["q_positive"] = a.positive, json["q_negative"] = a.negative;
  json["policy"] = a.policy;
  json["probabilities"] = a.pi;
  json["visits"] = a.visits;
  return json.dump() + "\n";
}

std::string asTable(const StoredFunction& f, const Answer& a) {
  const bool split = f.values().split();
  std::string text = fmt::format("{:>10}  {:>12}", f.task().actionTitle, "Q");
  if (split) text += fmt::format("  {:>12}  {:>12}", "Q+", "Q-");
  text += fmt::format("  {:>12}\n", "probability");
  for (std::size_t i = 0; i < a.q.size(); ++i) {
    text += fmt::format("{:>10}  {:>12.6g}", actionText(f.task(), i), a.q[i]);
    if (split) text += fmt::format("  {:>12.6g}  {:>12.6g}", a.positive[i], a.negative[i]);
    text += fmt::format("  {:>12.6g}\n", a.pi[i]);
  }
  return text + fmt::format("policy {}, {:.0f} visits\n", a.policy, a.visits);
}

}  // namespace

int queryCommand(const Registry& registry, const QueryRequest& request) {
  if (!request.state) return fail({"--state: the state is needed, such as --state 0.1,0,0."});
  auto function = openFunction(registry, request.file);
  if (!function) return fail(function.error());
  const auto state = parseState("--state", *request.state, function->task());
  if (!state) return fail(state.error());
  const auto found = answer(registry, request, *function, *state);
  if (!found) return fail(found.error());
  return print(request.json ? asJson(*function, *state, *found) : asTable(*function, *found));
}

}  // namespace surefoot
