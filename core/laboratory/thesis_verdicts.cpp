// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/thesis_verdicts.h"

#include <algorithm>

#include "core/text.h"

namespace surefoot {

namespace {

/// Empty: the claim is about something else.
std::string saysOf(const Claim& claim) {
  const auto& a = claim.arguments;
  if (a.value("measure", "falls") != "falls") return "";
  const bool number = a.contains("thesis") && a["thesis"].is_number();
  if (claim.kind == "value" && number) return fixedText(a["thesis"].get<double>(), 0);
  if (claim.kind == "reduction" && number) {
    const double percent = a["thesis"].get<double>();
    return (percent > 0 ? "+" : "") + fixedText(percent, 0) + " %";
  }
  if (claim.kind == "reduction" || claim.kind == "significant") return "differs";
  return claim.kind == "no-difference" ? "no difference" : "";
}

bool isAbout(const Claim& claim, const std::string& condition) {
  const auto conditions = claim.arguments.value("conditions", nlohmann::json::array());
  return std::any_of(conditions.begin(), conditions.end(),
                     [&](const auto& p) { return p.is_string() && fits(condition, p.template get<std::string>()); });
}

Verdict both(Verdict a, Verdict b) {
  if (a == Verdict::Differs || b == Verdict::Differs) return Verdict::Differs;
  return a == Verdict::Undecided ? a : b;
}

}  // namespace

std::map<std::string, ThesisVerdict> thesisVerdicts(const Registry& registry, const std::vector<Claim>& claims,
                                                    const std::vector<Evidence>& evidence, std::uint64_t seed) {
  std::map<std::string, ThesisVerdict> all;
  for (const Claim& claim : claims) {
    const std::string says = saysOf(claim);
    if (says.empty()) continue;
    for (const Evidence& e : evidence) {
      if (e.lives.empty() || !isAbout(claim, e.name())) continue;
      Claim one = claim;
      one.arguments["conditions"] = {e.name()};
      const auto judgement = judge(registry, one, evidence, seed);
      if (!judgement) continue;
      const auto [place, fresh] = all.try_emplace(e.name(), ThesisVerdict{says, judgement->verdict, {}});
      ThesisVerdict& v = place->second;
      if (!fresh) v.verdict = both(v.verdict, judgement->verdict);
      if (!fresh && says.ends_with('%')) v.says = says;  // a number says more than that there is a difference
      v.claims.push_back(claim.id);
    }
  }
  return all;
}

}  // namespace surefoot
