// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recipes/thesis_verdicts.h"

#include <cmath>

#include "core/basics/typed_json.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

/// Empty: the claim is about something else.
std::string saysOf(const Claim& claim) {
  if (textIn(claim.arguments, "measure", "falls") != "falls") return "";
  const double thesis = numberIn(claim.arguments, "thesis");
  if (claim.kind == "value" && std::isfinite(thesis)) return fixedText(thesis, 0);
  if (claim.kind == "reduction" && std::isfinite(thesis)) return (thesis > 0 ? "+" : "") + fixedText(thesis, 0) + " %";
  if (claim.kind == "reduction" || claim.kind == "significant") return "differs";
  return claim.kind == "no-difference" ? "no difference" : "";
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
