// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated studies, of whose truth we know everything: conditions whose lives fall as often as we say, each life with
// the scatter and the skew of real ones, alone, in pairs with a Q-function of their own, or eight to a shared one.
#pragma once

#include <array>
#include <cmath>

#include "tests/core/recipes/claim_evidence.h"

namespace surefoot {

inline constexpr int kStudies = 2000;

enum class Design { Lives, OwnQFunctions, SharedQFunctions };

/// Makes conditions of one study. Their Q-functions are drawn once: conditions of the study share them.
class Study {
 public:
  Study(Design design, int lives, Random& random) : design_(design), random_(random) {
    const int count = design == Design::SharedQFunctions ? kShared : lives;
    for (int q = 0; q < count; ++q) qFunctions_.push_back(std::exp(kBetween * normal() - kBetween * kBetween / 2));
    lives_ = lives;
  }

  /// Falls are negative binomial (a Poisson number of a lognormal mean): a mean of 23 has a deviation of about 10.
  Evidence condition(const std::string& name, double mean, const std::string& reference = "") {
    Evidence e = surefoot::condition(name, mean, reference, 0, lives_);
    if (design_ != Design::Lives) e.pool = "q";
    for (std::size_t i = 0; i < e.lives.size(); ++i) {
      double own = mean;
      const double scatter = design_ == Design::Lives ? kAlone : kWithin;
      if (design_ != Design::Lives) {
        const std::size_t q = i % qFunctions_.size();
        e.record.lives[i].qFunction = static_cast<int>(q);
        own *= qFunctions_[q];
      }
      own *= std::exp(scatter * normal() - scatter * scatter / 2);
      e.lives[i].falls = e.lives[i].allFalls = poisson(own);
    }
    return e;
  }

 private:
  static constexpr int kShared = 5;
  static constexpr double kBetween = 0.3, kWithin = 0.25, kAlone = 0.38;  // as after pre-learning on scenario 2

  double normal() {
    return std::sqrt(-2 * std::log(1 - random_.uniform())) * std::cos(2 * std::acos(-1.0) * random_.uniform());
  }
  double poisson(double mean) {
    int count = -1;
    for (double left = mean; left > 0; ++count) left += std::log(1 - random_.uniform());
    return std::max(0, count);
  }

  Design design_;
  Random& random_;
  std::vector<double> qFunctions_;
  int lives_ = 0;
};

/// How often a rule said agrees, differs, undecided.
struct Rates {
  std::array<double, 3> shares{};
  double agrees() const { return shares[0]; }
  double differs() const { return shares[1]; }
  double undecided() const { return shares[2]; }
};

}  // namespace surefoot
