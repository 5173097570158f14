// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot query`: Q, Q⁺, Q⁻, the risk and π of one state.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands/action_text.h"
#include "app/commands/commands.h"
#include "app/requests/requests.h"
#include "core/basics/typed_json.h"
#include "core/saved/stored_function.h"
#include "core/text/words.h"
#include "core/values_of_state.h"

namespace surefoot {

namespace {

struct Answer {
  std::vector<double> q, positive, negative, risk, pi;
  std::string policy;
  double visits = 0.0;
};

Result<Answer> answer(const Registry& registry, const QueryRequest& request, const StoredFunction& f,
                      const std::vector<double>& state) {
  Answer a;
  a.policy = request.policy.value_or(f.configuration.names.policy);
  const auto policy = policyOn(registry, f, a.policy, request.assignments);
  if (!policy) return policy.error();
  ValuesOfState here;
  here.evaluate(f.values(), state);
  a.pi.resize(here.q.size());
  (*policy)->probabilities(here.view(), a.pi);
  a.q = std::move(here.q), a.risk = std::move(here.risk);
  a.visits = f.values().visits(state);
  if (!f.values().split()) return a;
  for (const auto& [layer, part] : {std::pair{Layer::Positive, &a.positive}, std::pair{Layer::Negative, &a.negative}}) {
    part->resize(a.q.size());
    f.values().evaluate(state, layer, *part);
  }
  return a;
}

using OrderedJson = nlohmann::ordered_json;

/// The names and units of the values in "actions" and "action_coordinates".
OrderedJson actionVariables(const Task& task) {
  OrderedJson list = OrderedJson::array();
  for (const ActionVariable& v : task.actionVariables)
    list.push_back({{"variable", v.key}, {"title", v.title}, {"unit", v.unit}});
  if (list.empty())
    list.push_back({{"variable", task.actionTitle}, {"title", task.actionTitle}, {"unit", task.actionUnit}});
  return list;
}

std::string asJson(const StoredFunction& f, const std::vector<double>& state, const Answer& a) {
  const Task& task = f.task();
  OrderedJson json = {{"state", state}, {"action_variables", actionVariables(task)}, {"actions", OrderedJson::array()}};
  for (std::size_t i = 0; i < a.q.size(); ++i) {
    json["actions"].push_back(actionWithUnit(task, i));
    json["action_coordinates"].push_back(actionValues(task, i));
  }
  json["q"] = a.q;
  if (f.values().split()) json["q_positive"] = a.positive, json["q_negative"] = a.negative;
  if (!a.risk.empty()) json["risk"] = a.risk;
  json["policy"] = a.policy;
  json["probabilities"] = a.pi;
  json["visits"] = a.visits;
  return jsonText(json) + "\n";
}

std::string withUnit(const std::string& title, const std::string& unit) {
  return unit.empty() ? title : fmt::format("{} [{}]", title, unit);
}

/// The heads of an action's columns; their contents come next.
std::vector<std::string> actionHeads(const Task& task) {
  std::vector<std::string> heads;
  for (const ActionVariable& v : task.actionVariables) heads.push_back(withUnit(v.title, v.unit));
  if (heads.empty()) heads.push_back(withUnit(task.actionTitle, task.actionNames.empty() ? task.actionUnit : ""));
  return heads;
}
std::vector<std::string> actionCells(const Task& task, std::size_t i) {
  if (task.actionVariables.empty()) return {actionText(task, i)};
  std::vector<std::string> cells;
  for (const double value : actionValues(task, i)) cells.push_back(fmt::format("{:.5g}", value));
  return cells;
}

std::string asTable(const StoredFunction& f, const Answer& a) {
  const bool split = f.values().split();
  const std::vector<std::string> heads = actionHeads(f.task());
  const auto width = [&](std::size_t j) { return std::max<std::size_t>(10, heads[j].size()); };
  std::string text;
  for (std::size_t j = 0; j < heads.size(); ++j) text += fmt::format("{:>{}}  ", heads[j], width(j));
  text += fmt::format("{:>12}", "Q");
  if (split) text += fmt::format("  {:>12}  {:>12}", "Q+", "Q-");
  if (!a.risk.empty()) text += fmt::format("  {:>12}", "risk");
  text += fmt::format("  {:>12}\n", "probability");
  for (std::size_t i = 0; i < a.q.size(); ++i) {
    const std::vector<std::string> cells = actionCells(f.task(), i);
    for (std::size_t j = 0; j < cells.size(); ++j) text += fmt::format("{:>{}}  ", cells[j], width(j));
    text += fmt::format("{:>12.6g}", a.q[i]);
    if (split) text += fmt::format("  {:>12.6g}  {:>12.6g}", a.positive[i], a.negative[i]);
    if (!a.risk.empty()) text += fmt::format("  {:>12.6g}", a.risk[i]);
    text += fmt::format("  {:>12.6g}\n", a.pi[i]);
  }
  return text + fmt::format("policy {}, {:.0f} visits\n", a.policy, a.visits);
}

}  // namespace

int queryCommand(const Registry& registry, const QueryRequest& request) {
  auto function = openFunction(registry, request.file);
  if (!function) return fail(function.error());
  if (!request.state) {
    std::vector<std::string> names, zeros;
    for (const StateVariable& v : function->task().state) {
      names.push_back(v.key);
      zeros.push_back(fmt::format("{}", std::clamp(0.0, v.low, v.high)));
    }
    return fail({fmt::format("--state: the state is needed, {}, such as --state {}.", joinWords(names),
                             fmt::join(zeros, ","))});
  }
  const auto state = parseState("--state", *request.state, function->task());
  if (!state) return fail(state.error());
  const auto found = answer(registry, request, *function, *state);
  if (!found) return fail(found.error());
  return print(request.json ? asJson(*function, *state, *found) : asTable(*function, *found));
}

}  // namespace surefoot
