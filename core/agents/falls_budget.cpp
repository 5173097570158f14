// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/falls_budget.h"

#include <limits>

namespace surefoot {

void BudgetSettings::declare(Fields& f) {
  f.choice(kind, {.key = "budget",
                  .title = "Falls budget",
                  .label = "Budget",
                  .when = When::NewTable,
                  .group = Group::Learning,
                  .help = "A fall costs more and more while the robot falls more often than the budget allows.",
                  .origin = "ours: off, as in the thesis",
                  .choices = {"off", "on"},
                  .order = 3});
  declareLive(f);
}

void BudgetSettings::declareLive(Fields& f) {
  f.real(budget, {.key = "falls_budget",
                  .title = "Falls an episode",
                  .label = "Falls",
                  .symbol = "d",
                  .low = 0.0,
                  .high = 1000.0,
                  .sliderLow = 0.0,
                  .sliderHigh = 1.0,
                  .when = When::Now,
                  .group = Group::Learning,
                  .help = "So many falls an episode are allowed; with more a fall costs more.",
                  .origin = "ours",
                  .order = 3,
                  .needs = "budget"});
  f.real(rate, {.key = "budget_rate",
                .title = "Rate of the budget",
                .label = "Rate",
                .symbol = "η",
                .low = 0.0,
                .high = 1e6,
                .sliderLow = 0.0,
                .sliderHigh = 100.0,
                .when = When::Now,
                .group = Group::Learning,
                .help = "How much more a fall costs after an episode with one fall too many.",
                .origin = "ours",
                .order = 3,
                .needs = "budget"});
}

void FallsBudget::transferLearning(Archive& archive) {
  inner().transferLearning(archive);
  archive.under("budget.", [&] {
    archive.value("price", price_);
    if (archive.reading() && price_ < 0) archive.refuse("price", "is out of range");
    archive.value("falls", falls_, 0, std::numeric_limits<std::int64_t>::max());
  });
}

}  // namespace surefoot
