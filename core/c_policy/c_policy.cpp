// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/c_policy/c_policy.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/c_policy/c_estimate.h"
#include "core/c_policy/c_features.h"
#include "core/c_policy/c_text.h"
#include "core/text/number_text.h"

namespace surefoot {

namespace {

/// The estimates whose sum is q̂: q, or positive and negative.
std::vector<std::string> estimatesOf(const TensorFile& file) {
  std::vector<std::string> names;
  for (const char* name : {"q", "positive", "negative"})
    if (file.about["estimates"].contains(name)) names.emplace_back(name);
  return names;
}

/// An action's number and what it does: "3: 0.75 N m".
std::string actionsInWords(const Task& task) {
  std::string text = fmt::format("   Actions ({}{}{}):\n", commentInC(task.actionTitle),
                                 task.actionUnit.empty() ? "" : ", in ", commentInC(task.actionUnit));
  constexpr std::size_t kMost = 24;
  for (std::size_t a = 0; a < std::min(kMost, task.actions.size()); ++a) {
    text += fmt::format("     {}:", a);
    if (a < task.actionNames.size()) text += " " + commentInC(task.actionNames[a]);
    for (std::size_t j = 0; j < task.actionVariables.size(); ++j)
      text +=
          fmt::format(" {} {:.6g}", task.actionVariables[j].key, task.actionVariables[j].levels[levelOf(task, a, j)]);
    if (a >= task.actionNames.size() && task.actionVariables.empty()) text += fmt::format(" {}", task.actions[a]);
    text += '\n';
  }
  if (task.actions.size() > kMost) text += "     and so on, as in policy_actions.\n";
  return text;
}

std::string headOf(const TensorFile& file, const Task& task, const CPolicySettings& settings) {
  std::string text =
      "/* The greedy policy of a Q-function that was learned in simulation by Surefoot. It was tried there "
      "and nowhere\n   else: what it does to a real machine is for you to check.\n\n";
  const Json& c = file.about["configuration"];
  const auto name = [&](const char* key) { return commentInC(c.is_object() ? c.value(key, "") : ""); };
  text += fmt::format("   {}\n   Learned on {} {} {} by {}.\n\n   State, in this order:\n", commentInC(settings.origin),
                      name("environment"), name("preset"), name("scenario"), name("agent"));
  for (std::size_t d = 0; d < task.state.size(); ++d) {
    const StateVariable& v = task.state[d];
    text += fmt::format("     state[{}]: {}{}{}, from {:.6g} to {:.6g}{}\n", d, commentInC(v.title),
                        v.unit.empty() ? "" : " in ", commentInC(v.unit), v.low, v.high,
                        v.period ? ", going round" : "; beyond, it counts as at the end");
  }
  text += actionsInWords(task);
  text += R"(
   int policy_action(const double state[]): the number of the first action with the greatest value.
   void policy_action_values(const double state[], double q[]): the expected return of every action.
   C99; no library, no heap. Safe to call from several threads.)";
  if (!settings.known.empty()) text += "\n   Compiled with -DPOLICY_SELF_TEST it is a program that checks itself.";
  return text + " */\n";
}

/// What the actions are, in their units; combinations have a row of several.
std::string actionTable(const Task& task) {
  const std::size_t variables = task.actionVariables.size();
  std::vector<double> values;
  for (std::size_t a = 0; a < task.actions.size(); ++a) {
    if (variables == 0) values.push_back(task.actions[a]);
    for (std::size_t j = 0; j < variables; ++j) values.push_back(task.actionVariables[j].levels[levelOf(task, a, j)]);
  }
  std::string text = arrayInC("double", "policy_actions", std::span<const double>(values));
  text = "extern const double policy_actions[];\n" + text.substr(std::string("static ").size());
  if (variables > 1) text = fmt::format("/* {} numbers an action */\n", variables) + text;
  return text;
}

std::string selfTest(const CPolicySettings& settings, std::size_t states) {
  std::vector<double> all;
  std::vector<std::uint64_t> actions;
  for (const KnownAction& known : settings.known) {
    all.insert(all.end(), known.state.begin(), known.state.end());
    actions.push_back(static_cast<std::uint64_t>(known.action));
  }
  return "\n#ifdef POLICY_SELF_TEST\n#include <stdio.h>\n" +
         arrayInC("double", "known_state", std::span<const double>(all)) +
         arrayInC("uint32_t", "known_action", std::span<const std::uint64_t>(actions)) +
         fmt::format(R"(int main(void) {{
  int i, right = 0;
  for (i = 0; i < {0}; ++i) right += policy_action(known_state + i * {1}) == (int)known_action[i];
  printf("%d of {0} actions are right\n", right);
  return right == {0} ? 0 : 1;
}}
#endif
)",
                     settings.known.size(), states);
}

}  // namespace

double tableBytesOf(const TensorFile& file, bool floats) {
  double bytes = 0.0;
  for (const std::string& name : estimatesOf(file)) bytes += tableBytesOf(file, name, floats);
  return bytes;
}

Result<std::string> policyAsC(const TensorFile& file, const Task& task, const CPolicySettings& settings) {
  if (const double bytes = tableBytesOf(file, settings.floats); bytes > kMostCTables)
    return fileError(file.name,
                     fmt::format("as C its tables have {:.0f} MB; at most {:.0f} MB are written{}.", bytes / 1e6,
                                 kMostCTables / 1e6, settings.floats ? "" : ", and --float halves them"));
  const std::vector<std::string> names = estimatesOf(file);
  std::string estimates;
  for (const std::string& name : names) {
    auto text = estimateInC(file, name, task, settings.floats);
    if (!text) return text.error();
    estimates += "\n" + *text;
  }
  const std::size_t actions = task.actions.size();
  std::string sum = fmt::format(
      "\nvoid policy_action_values(const double state[], double q[]) {{\n  {}_values(state, q);\n", names[0]);
  if (names.size() > 1)  // Q = Q⁺ + Q⁻
    sum = fmt::format(
        "\nvoid policy_action_values(const double state[], double q[]) {{\n"
        "  double losses[{0}];\n  int a;\n  {1}_values(state, q);\n  {2}_values(state, losses);\n"
        "  for (a = 0; a < {0}; ++a) q[a] += losses[a];\n",
        actions, names[0], names[1]);
  std::string text = headOf(file, task, settings) + "#include <stdint.h>\n";
  text += "#ifdef __clang__\n#pragma STDC FP_CONTRACT OFF\n#endif\n\n";
  text += "int policy_action(const double state[]);\nvoid policy_action_values(const double state[], double q[]);\n";
  text += actionTable(task) + "\n" + helpersInC(estimates) + estimates + sum + "}\n";
  text += fmt::format(
      "\nint policy_action(const double state[]) {{\n  double q[{0}];\n  int a, best = 0;\n"
      "  policy_action_values(state, q);\n  for (a = 1; a < {0}; ++a)\n    if (q[a] > q[best]) best = a;\n"
      "  return best;\n}}\n",
      actions);
  if (!settings.known.empty()) text += selfTest(settings, task.state.size());
  return text;
}

}  // namespace surefoot
