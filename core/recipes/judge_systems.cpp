// SPDX-License-Identifier: GPL-3.0-or-later
// Claims about many systems ([systems] of a plan): each is judged on every system alone.
#include "core/recipes/judge_systems.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "core/plans/plan_systems.h"
#include "core/recipes/judge.h"

namespace surefoot {

std::set<int> systemsOf(const std::vector<Evidence>& evidence) {
  std::set<int> numbers;
  for (const Evidence& e : evidence)
    if (const int number = systemOf(e.name()).first; number > 0) numbers.insert(number);
  return numbers;
}

Result<Judgement> judgeOnSystems(const Registry& registry, const Claim& claim, const std::vector<Evidence>& evidence,
                                 const std::set<int>& systems, std::uint64_t seed) {
  Judgement whole;
  whole.id = claim.id, whole.says = claim.says, whole.counts = claim.counts;
  std::array<std::vector<int>, 3> numbers;
  for (const int number : systems) {
    const auto judgement = Judge(registry, claim, evidence, seed, number).judge();
    if (!judgement) return judgement.error();
    whole.thesis = judgement->thesis;
    numbers[static_cast<std::size_t>(judgement->verdict)].push_back(number);
  }
  const auto count = [&](Verdict v) { return numbers[static_cast<std::size_t>(v)].size(); };
  const auto all = static_cast<double>(systems.size());
  const double agree = static_cast<double>(count(Verdict::Agrees)) / all;
  whole.ours = agree;
  whole.verdict = agree >= kOfMostSystems                                                    ? Verdict::Agrees
                  : static_cast<double>(count(Verdict::Differs)) / all >= 1 - kOfMostSystems ? Verdict::Differs
                                                                                             : Verdict::Undecided;
  whole.note = fmt::format("of {} systems it holds in {}", systems.size(), count(Verdict::Agrees));
  if (count(Verdict::Differs) > 0)
    whole.note += fmt::format(", not in {} ({})", count(Verdict::Differs),
                              fmt::join(numbers[static_cast<std::size_t>(Verdict::Differs)], ", "));
  if (count(Verdict::Undecided) > 0)
    whole.note += fmt::format(", and cannot be told in {} ({})", count(Verdict::Undecided),
                              fmt::join(numbers[static_cast<std::size_t>(Verdict::Undecided)], ", "));
  return whole;
}

}  // namespace surefoot
