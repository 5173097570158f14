// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/schedule.h"

#include <algorithm>

#include "core/basics/portable_math.h"

namespace surefoot {

void Scheduled::declare(Fields& f, const Parameter& parameter, bool byRule) {
  f.real(start_, parameter);
  Parameter p = parameter;
  p.order = 3;
  p.sliderLow = p.sliderHigh = 0;  // as wide as the range
  p.origin = "ours";
  p.symbol = "";
  p.key = parameter.key + "_schedule";
  p.title = parameter.title + ", schedule";
  p.help = "How it changes while the life goes on: not at all, in a straight line, or by halves.";
  p.label = "Schedule";
  p.choices = {"constant", "linear", "exponential"};
  if (byRule) {
    p.choices.emplace_back("rule");
    p.help =
        "How it changes while the life goes on: not at all, in a straight line, by halves, or as the rule of thumb "
        "says.";
  }
  f.choice(kind_, p);

  p.needs = parameter.key + "_schedule";
  p.needsOne = {};
  p.key = parameter.key + "_end";
  p.label = "End value";
  p.title = parameter.title + ", end";
  p.help = "The value that the schedule goes to.";
  p.choices = {};
  p.sliderLow = parameter.sliderLow;
  p.sliderHigh = parameter.sliderHigh;
  f.real(end_, p);

  p.key = parameter.key + "_over";
  p.label = "Over";
  p.title = parameter.title + ", time";
  p.help = "How long a linear schedule takes to its end; the half-life of an exponential one.";
  p.unit = "";
  p.low = 1;
  p.high = 1e12;
  p.sliderLow = 1;
  p.sliderHigh = 10'000;
  f.real(over_, p);

  p.key = parameter.key + "_per";
  p.label = "Counted in";
  p.title = parameter.title + ", clock";
  p.sliderLow = p.sliderHigh = 0;
  p.help = "What the time of the schedule is counted in.";
  p.choices = {"episodes", "steps"};
  f.choice(per_, p);
}

void Scheduled::advance(const LifeTime& time) {
  if (kind_ == Kind::Rule) {
    now_ = time.rule.value_or(start_);
    return;
  }
  constexpr double kLn2 = 0.69314718055994531;
  const double t = static_cast<double>(per_ == Per::Steps ? time.steps : time.episodes) / over_;
  now_ = kind_ == Kind::Linear ? start_ + (end_ - start_) * std::min(t, 1.0)
                               : end_ + (start_ - end_) * portableExp(-kLn2 * t);
}

}  // namespace surefoot
