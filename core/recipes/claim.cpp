// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recipes/claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/basics/typed_json.h"
#include "core/parameters.h"
#include "core/plans/plan_systems.h"
#include "core/recipes/judge.h"
#include "core/recipes/judge_systems.h"
#include "core/statistics/statistics_text.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

const std::map<std::string, Verdict (Judge::*)()>& Judge::kinds() {
  static const std::map<std::string, Verdict (Judge::*)()> kKinds = {{"value", &Judge::value},
                                                                     {"reduction", &Judge::reduction},
                                                                     {"significant", &Judge::significant},
                                                                     {"no-difference", &Judge::noDifference},
                                                                     {"order", &Judge::order},
                                                                     {"lowest", &Judge::lowest},
                                                                     {"pairs", &Judge::pairs},
                                                                     {"within-lives", &Judge::withinLives},
                                                                     {"not-longer", &Judge::notLonger},
                                                                     {"not-worse", &Judge::notWorse},
                                                                     {"ratio", &Judge::ratio},
                                                                     {"extreme", &Judge::extreme},
                                                                     {"below", &Judge::below},
                                                                     {"trend", &Judge::trend},
                                                                     {"settled", &Judge::settled},
                                                                     {"pool", &Judge::pool},
                                                                     {"spread", &Judge::spread},
                                                                     {"rule", &Judge::rule},
                                                                     {"parameters", &Judge::parameters},
                                                                     {"drawn", &Judge::drawn},
                                                                     {"same-values", &Judge::sameValues},
                                                                     {"best", &Judge::best},
                                                                     {"chosen", &Judge::chosen},
                                                                     {"compromise", &Judge::compromise},
                                                                     {"effect-order", &Judge::effectOrder},
                                                                     {"bands-overlap", &Judge::bandsOverlap},
                                                                     {"dips", &Judge::dips},
                                                                     {"equal-exploring", &Judge::equalExploring},
                                                                     {"adds-up", &Judge::addsUp}};
  return kKinds;
}

Status checkKind(const Claim& claim) {
  if (Judge::kinds().contains(claim.kind)) return Done{};
  std::vector<std::string> names;
  for (const auto& [name, function] : Judge::kinds()) names.push_back(name);
  return Error{fmt::format("claim {}: there is no kind \"{}\"; it takes {}.", shortened(claim.id),
                           shortened(claim.kind), joinWords(names, "or"))};
}

Result<Judgement> Judge::judge() {
  if (const Status s = checkKind(claim_); !s) return s.error();
  const auto kind = kinds().find(claim_.kind);
  measure_ = text("measure", "falls");
  conditions_ = find("conditions");
  static const std::set<std::string> kNamedElsewhere = {"pairs", "rule", "parameters", "drawn", "best"};
  if (conditions_.empty() && !kNamedElsewhere.contains(claim_.kind)) complain("conditions", "no condition fits");
  if (!problem_.empty()) return Error{problem_};
  j_.verdict = (this->*kind->second)();
  if (!problem_.empty()) return Error{problem_};
  return j_;
}

void Judge::complain(const std::string& key, const std::string& what) {
  if (problem_.empty()) problem_ = fmt::format("claim {}: {}: {}.", claim_.id, key, what);
}

std::string Judge::text(const char* key, const char* otherwise) {
  const auto found = arguments_.find(key);
  if (found == arguments_.end()) return otherwise;
  if (!found->is_string()) complain(key, "a text is expected");
  return found->is_string() ? found->get<std::string>() : otherwise;
}

double Judge::number(const char* key, std::optional<double> otherwise) {
  const auto found = arguments_.find(key);
  if (found != arguments_.end() && found->is_number()) return found->get<double>();
  if (found != arguments_.end() || !otherwise) complain(key, "a number is expected");
  return otherwise.value_or(0.0);
}

Judge::Group Judge::fitting(const std::string& pattern) const {
  Group group;
  for (const Evidence& e : evidence_) {
    if (e.lives.empty()) continue;
    const auto [system, name] = system_ > 0 ? systemOf(e.name()) : std::pair(0, e.name());
    if (system == system_ && fits(name, pattern)) group.push_back(&e);
  }
  return group;
}

Judge::Group Judge::find(const char* key) {
  Group group;
  const auto found = arguments_.find(key);
  if (found == arguments_.end()) return group;
  for (const auto& pattern : *found) {
    const Group more = pattern.is_string() ? fitting(pattern.get<std::string>()) : Group{};
    if (more.empty()) complain(key, fmt::format("no condition fits {}", jsonText(pattern)));
    group.insert(group.end(), more.begin(), more.end());
  }
  return group;
}

const Evidence* Judge::referenceOf(const Evidence& e) {
  const std::string& own = e.record.condition.reference;
  const std::string name = text("reference", (system_ > 0 ? systemOf(own).second : own).c_str());
  const Group found = fitting(name);
  if (found.size() == 1) return found[0];
  complain("reference", fmt::format("no single condition is called \"{}\"", name));
  return &e;
}

std::vector<double> Judge::values(const Evidence& e) const {
  std::vector<double> v = valuesOf(e, measure_);
  std::erase_if(v, [](double x) { return !std::isfinite(x); });
  return v;
}

MeanEstimate Judge::estimate(const Evidence& e) {
  static const std::set<std::string> kUpToTheEnd = {"falls",         "minutes",        "success_during",
                                                    "success_after", "failure_during", "failure_after"};
  MeanEstimate mean = estimateOf(e, measure_);
  if (e.end || !(e.record.condition.goalReward > 0) || !kUpToTheEnd.contains(measure_)) return mean;
  neverEnded_ = e.name();
  mean.deviations.clear(), mean.degrees = 0;
  return mean;
}

double Judge::p(const Evidence& a, const Evidence& b) {
  if (!estimate(a).known() || !estimate(b).known()) return std::nan("");
  const auto test = testOfUnits(a, b, measure_);
  return test ? test->p : std::nan("");
}

Interval Judge::change(const Evidence& reference, const Evidence& e) {
  const MeanEstimate before = estimate(reference), after = estimate(e);
  const Interval change = changeOf(before, after, sameUnits(reference, e));
  ofNothing_ = before.value == 0;
  toNothing_ = !ofNothing_ && after.value == 0 && before.known() && after.known() && !change.known();
  return change;
}

Interval Judge::judged(const Interval& change, const Evidence& reference, const Evidence& e) {
  if (!toNothing_) return change;
  if (const auto counts = countsOf(reference, e, measure_); counts && std::isfinite(counts->ratio.high))
    return {change.value, -100, 100 * (counts->ratio.high - 1)};
  const MeanEstimate before = estimate(reference);
  const Interval d = differenceOf(before, estimate(e), sameUnits(reference, e));
  return {change.value, 100 * d.low / std::abs(before.value), 100 * d.high / std::abs(before.value)};
}

bool Judge::leavesZeroIn(const Evidence& reference, const Evidence& e) {
  const Interval i = change(reference, e);
  const Interval d = i.known() ? i : differenceOf(estimate(reference), estimate(e), sameUnits(reference, e));
  if (d.low > 0 || d.high < 0) return false;
  if (d.known())
    note(fmt::format("{}: the interval leaves 0 in", e.name()));
  else
    static_cast<void>(tooFew(e.name()));
  return true;
}

// A condition that is twice in a group is drawn once.
std::vector<double> Judge::drawn(const Group& group, const std::function<double(const std::vector<double>&)>& f) {
  std::vector<MeanEstimate> means;
  std::vector<std::size_t> together, places;
  std::map<const Evidence*, std::size_t> numbers;
  FirstWithSameUnits firsts;
  for (const Evidence* e : group) {
    const auto [number, isNew] = numbers.try_emplace(e, means.size());
    places.push_back(number->second);
    if (!isNew) continue;
    means.push_back(estimate(*e));
    together.push_back(firsts.add(*e));
  }
  if (means.size() == group.size()) return drawMeans(means, together, f, random_);
  std::vector<double> ofGroup(group.size());
  const auto spread = [&](const std::vector<double>& drawn) {
    for (std::size_t i = 0; i < places.size(); ++i) ofGroup[i] = drawn[places[i]];
    return f(ofGroup);
  };
  return drawMeans(means, together, spread, random_);
}

double Judge::share(const Group& group, const std::function<bool(const std::vector<double>&)>& holds) {
  const auto results = drawn(group, [&](const auto& means) { return holds(means) ? 1.0 : 0.0; });
  if (!results.empty()) return surefoot::meanOf(results);
  static_cast<void>(tooFew());
  return std::nan("");
}

void Judge::report(const Interval& i) {
  const auto known = [](double v) { return std::isfinite(v) ? std::optional(v) : std::nullopt; };
  j_.ours = known(i.value), j_.low = known(i.low), j_.high = known(i.high);
}

Verdict Judge::tooFew(const std::string& condition) {
  const std::string never =
      fmt::format("learning never ended in {}, and lives that were cut off are not compared", neverEnded_);
  const char* why = !neverEnded_.empty() ? never.c_str()
                    : ofNothing_         ? "the reference is 0, of which there are no per cent"
                    : toNothing_         ? "it is 0 in every life; how rare more is cannot be told in per cent"
                                         : "too few lives to tell";
  note(condition.empty() ? why : fmt::format("{}: {}", condition, why));
  return Verdict::Undecided;
}

bool Judge::mayExceed(const Interval& change, bool down, bool up) {
  const double widest = number("widest", 15);
  return !change.known() || (down && change.low < -widest) || (up && change.high > widest);
}

bool Judge::leavesOpen(const Interval& change, double sign, double size) {
  const double end = sign < 0 ? change.low : change.high;
  return mayExceed(change, sign<0, sign> 0) || (change.value * sign > 0 && end * sign >= size);
}

const char* nameOf(Verdict verdict) {
  constexpr const char* kNames[] = {"agrees", "differs", "undecided"};
  return kNames[static_cast<int>(verdict)];
}

Result<Judgement> judge(const Registry& registry, const Claim& claim, const std::vector<Evidence>& evidence,
                        std::uint64_t seed) {
  const std::set<int> systems = systemsOf(evidence);
  return systems.empty() ? Judge(registry, claim, evidence, seed).judge()
                         : judgeOnSystems(registry, claim, evidence, systems, seed);
}

nlohmann::ordered_json judgementAsJson(const Judgement& j) {
  const auto orNull = [](const std::optional<double>& v) { return numberAsJson(v.value_or(std::nan(""))); };
  return {{"id", j.id},
          {"says", j.says},
          {"thesis", j.thesis},
          {"thesis_p", orNull(j.thesisP)},
          {"ours", orNull(j.ours)},
          {"low", orNull(j.low)},
          {"high", orNull(j.high)},
          {"p", orNull(j.p)},
          {"verdict", nameOf(j.verdict)},
          {"counts", j.counts},
          {"note", j.note}};
}

// A part between two * is searched from the left: its first place leaves the most room for later parts.
bool fits(std::string_view name, std::string_view pattern) {
  auto star = pattern.find('*');
  if (star == std::string_view::npos) return name == pattern;
  if (!name.starts_with(pattern.substr(0, star))) return false;
  name.remove_prefix(star);
  pattern.remove_prefix(star + 1);
  for (star = pattern.find('*'); star != std::string_view::npos; star = pattern.find('*')) {
    const auto place = name.find(pattern.substr(0, star));
    if (place == std::string_view::npos) return false;
    name.remove_prefix(place + star);
    pattern.remove_prefix(star + 1);
  }
  return name.ends_with(pattern);
}

bool isAbout(const Claim& claim, std::string_view condition) {
  const auto& patterns = partOf(claim.arguments, "conditions");
  return std::any_of(patterns.begin(), patterns.end(), [&](const nlohmann::json& pattern) {
    return pattern.is_string() && fits(condition, pattern.get_ref<const std::string&>());
  });
}

}  // namespace surefoot
