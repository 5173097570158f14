// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reports/stability.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "app/reports/report_table.h"
#include "core/basics/typed_json.h"

namespace surefoot {

namespace {

struct ClaimOverSeeds {
  std::string id, recipe, preset, says;
  std::vector<Verdict> verdicts;  ///< by seeds

  int most() const {
    std::array<int, 3> counts{};
    for (const Verdict v : verdicts) ++counts[static_cast<std::size_t>(v)];
    return *std::max_element(counts.begin(), counts.end());
  }
  bool isStable() const { return most() == static_cast<int>(verdicts.size()); }
};

/// Every seed has the same recipes with the same claims, in the same order.
std::vector<ClaimOverSeeds> claimsOver(const std::vector<OfSeed>& seeds) {
  std::vector<ClaimOverSeeds> rows;
  for (std::size_t s = 0; s < seeds.size(); ++s) {
    std::size_t row = 0;
    const auto add = [&](const Reproduced& r, const std::vector<Judgement>& judgements, const char* preset) {
      for (const Judgement& j : judgements) {
        if (s == 0) rows.push_back({j.id, r.name, preset, j.says, {}});
        rows.at(row++).verdicts.push_back(j.verdict);
      }
    };
    for (const Reproduced& r : seeds[s].recipes) {
      add(r, r.judgements, "");
      add(r, r.onLabPreset, "lab");
    }
  }
  return rows;
}

}  // namespace

std::string stabilityAsMarkdown(const std::vector<OfSeed>& seeds) {
  const std::vector<ClaimOverSeeds> rows = claimsOver(seeds);
  const auto stable = std::count_if(rows.begin(), rows.end(), [](const ClaimOverSeeds& r) { return r.isStable(); });
  std::vector<std::uint64_t> numbers;
  for (const OfSeed& s : seeds) numbers.push_back(s.seed);
  std::string out = fmt::format(
      "# Verdicts under the master seeds {}\n\n{} of {} judgements are the same under all of them. a: agrees, d: "
      "differs, u: undecided.\n\n| claim | recipe | verdicts | same | what |\n|---|---|---|---|---|\n",
      fmt::join(numbers, ", "), stable, rows.size());
  for (const ClaimOverSeeds& r : rows) {
    std::string letters;
    for (const Verdict v : r.verdicts) letters += nameOf(v)[0];
    out += fmt::format("| {}{} | {} | {} | {} of {} | {} |\n", r.id, r.preset.empty() ? "" : " (lab)", r.recipe,
                       letters, r.most(), r.verdicts.size(), escapedForMarkdown(r.says));
  }
  return out;
}

std::string stabilityAsJson(const std::vector<OfSeed>& seeds) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ClaimOverSeeds& r : claimsOver(seeds)) {
    nlohmann::ordered_json verdicts;
    for (std::size_t s = 0; s < seeds.size(); ++s) verdicts[std::to_string(seeds[s].seed)] = nameOf(r.verdicts[s]);
    list.push_back({{"id", r.id},
                    {"recipe", r.recipe},
                    {"preset", r.preset.empty() ? "thesis" : r.preset},
                    {"says", r.says},
                    {"verdicts", verdicts},
                    {"stable", r.isStable()}});
  }
  return jsonText(list, 2) + "\n";
}

}  // namespace surefoot
