// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/count_model.h"

#include <nlopt.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <map>

namespace surefoot {

namespace {

constexpr int kNodes = 20;
constexpr double kProfileStep = 0.1;  // from one point of the profile to the next

/// Nodes and weights of ∫ f(u) φ(u) du: eigenvalues of the Jacobi matrix of Hermite's polynomials (Golub & Welsch
/// 1969).
struct Quadrature {
  std::array<double, kNodes> nodes{}, logWeights{};

  Quadrature() {
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(kNodes, kNodes);
    for (int i = 1; i < kNodes; ++i) jacobi(i, i - 1) = jacobi(i - 1, i) = std::sqrt(i);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(jacobi);
    for (int i = 0; i < kNodes; ++i) {
      const double first = solver.eigenvectors()(0, i);
      nodes[static_cast<std::size_t>(i)] = solver.eigenvalues()(i);
      logWeights[static_cast<std::size_t>(i)] = std::log(first * first);
    }
  }
};

struct Count {
  double y = 0, x = 0;
};
/// The lives that share u.
using Shared = std::vector<std::vector<Count>>;

/// β₀, β₁, log σ, log k
using Theta = std::array<double, 4>;
enum Place { B0, B1, LogSigma, LogK };
constexpr double kLeastSigma = -7, kMostSigma = 1.5, kLeastK = -4, kMostK = 9;  // of the logarithms: e⁹ is Poisson

class Likelihood {
 public:
  Likelihood(Shared lives, bool withU) : lives_(std::move(lives)), withU_(withU) {
    for (const auto& group : lives_)
      for (const Count& c : group) constant_ -= std::lgamma(c.y + 1);
  }

  double at(const Theta& t) const {
    static const Quadrature rule;
    const double k = std::exp(t[LogK]), sigma = withU_ ? std::exp(t[LogSigma]) : 0, lgammaK = std::lgamma(k);
    double sum = constant_;
    std::array<double, kNodes> terms{};
    const std::size_t nodes = withU_ ? kNodes : 1;
    for (const auto& group : lives_) {
      double fixed = 0;
      terms.fill(0);
      for (const Count& c : group) {
        fixed += std::lgamma(c.y + k) - lgammaK + k * t[LogK];
        const double eta = t[B0] + c.x * t[B1];
        for (std::size_t n = 0; n < nodes; ++n) {
          const double here = eta + sigma * (withU_ ? rule.nodes[n] : 0);
          terms[n] += c.y * here - (c.y + k) * std::log(k + std::exp(here));
        }
      }
      if (!withU_) {
        sum += fixed + terms[0];
        continue;
      }
      double most = -std::numeric_limits<double>::infinity();
      for (std::size_t n = 0; n < kNodes; ++n) most = std::max(most, terms[n] += rule.logWeights[n]);
      double integral = 0;
      for (const double term : terms) integral += std::exp(term - most);
      sum += fixed + most + std::log(integral);
    }
    return sum;
  }

  /// The largest likelihood, from `start` on; with β₁ held where it is, if so asked.
  double maximise(Theta& start, bool holdsB1, double step = 0.3) const {
    std::vector<Place> free = {B0};
    if (!holdsB1) free.push_back(B1);
    if (withU_) free.push_back(LogSigma);
    free.push_back(LogK);
    struct Call {
      const Likelihood* likelihood;
      const std::vector<Place>* free;
      Theta theta;
    } call{this, &free, start};
    const auto negative = [](unsigned n, const double* x, double*, void* data) {
      auto& c = *static_cast<Call*>(data);
      for (unsigned i = 0; i < n; ++i) c.theta[(*c.free)[i]] = x[i];
      const double value = c.likelihood->at(c.theta);
      return std::isfinite(value) ? -value : 1e300;
    };
    std::vector<double> x, low, high;
    for (const Place p : free) {
      x.push_back(start[p]);
      low.push_back(p == LogSigma ? kLeastSigma : p == LogK ? kLeastK : -30);
      high.push_back(p == LogSigma ? kMostSigma : p == LogK ? kMostK : 30);
    }
    nlopt_opt search = nlopt_create(NLOPT_LN_SBPLX, static_cast<unsigned>(x.size()));
    nlopt_set_lower_bounds(search, low.data());
    nlopt_set_upper_bounds(search, high.data());
    nlopt_set_min_objective(search, negative, &call);
    nlopt_set_initial_step1(search, step);
    nlopt_set_ftol_abs(search, 1e-6);
    nlopt_set_maxeval(search, 4000);
    double least = 0;
    nlopt_optimize(search, x.data(), &least);
    nlopt_destroy(search);
    for (std::size_t i = 0; i < free.size(); ++i) start[free[i]] = x[i];
    return -least;
  }

 private:
  Shared lives_;
  bool withU_;
  double constant_ = 0;
};

bool areCounts(Sample values) {
  return values.size() >= 3 &&
         std::all_of(values.begin(), values.end(), [](double v) { return v >= 0 && v == std::floor(v) && v < 1e9; });
}

/// Where the profile likelihood has dropped by half the quantile of χ²(1): towards `sign`. Infinite: it never does.
double endOf(const Likelihood& likelihood, const Theta& best, double most, double sign) {
  const double drop = boost::math::quantile(boost::math::chi_squared(1), 0.95) / 2;
  Theta at = best;
  const auto above = [&](double b1) {
    at[B1] = b1;
    return likelihood.maximise(at, true, kProfileStep) - (most - drop);
  };
  constexpr double kFarthest = 12;  // e⁻¹²: no falls at all, where the likelihood is flat
  const double begin = std::max(best[B1], -kFarthest);
  double inner = begin, outer = begin, atInner = drop;
  for (double step = 0.25; std::abs(outer - begin) < 2 * kFarthest; step *= 2) {
    outer = inner + sign * step;
    const double atOuter = above(outer);
    if (atOuter < 0) {
      std::uintmax_t evaluations = 12;
      const auto near = [](double a, double b) { return std::abs(a - b) < 1e-3; };
      const bool up = inner < outer;
      const auto ends =
          boost::math::tools::toms748_solve(above, up ? inner : outer, up ? outer : inner, up ? atInner : atOuter,
                                            up ? atOuter : atInner, near, evaluations);
      return (ends.first + ends.second) / 2;
    }
    inner = outer, atInner = atOuter;
  }
  return sign * std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<CountRatio> countRatio(Sample before, const Units& ofBefore, Sample after, const Units& ofAfter,
                                     bool sameUnits) {
  if (!areCounts(before) || !areCounts(after) || meanOf(before) == 0) return std::nullopt;
  std::map<std::size_t, std::vector<Count>> groups;
  for (std::size_t i = 0; i < before.size(); ++i) groups[ofBefore.of[i]].push_back({before[i], 0});
  const std::size_t others = sameUnits ? 0 : ofBefore.count;  // units of their own
  for (std::size_t i = 0; i < after.size(); ++i) groups[ofAfter.of[i] + others].push_back({after[i], 1});
  Shared lives;
  bool withU = false;
  for (auto& [number, group] : groups) withU = withU || group.size() > 1, lives.push_back(std::move(group));
  const Likelihood likelihood(std::move(lives), withU);

  const double from = meanOf(before), to = std::max(meanOf(after), 0.05);
  Theta best = {std::log(from), std::log(to / from), std::log(0.3), std::log(5.0)};
  double most = likelihood.maximise(best, false);
  most = std::max(most, likelihood.maximise(best, false));  // Subplex restarts well
  Theta none = best;
  none[B1] = 0;
  const double without = likelihood.maximise(none, true);
  CountRatio result;
  result.p =
      boost::math::cdf(boost::math::complement(boost::math::chi_squared(1), std::max(0.0, 2 * (most - without))));
  const bool nothing = meanOf(after) == 0;
  result.ratio = {nothing ? 0 : std::exp(best[B1]), nothing ? 0 : std::exp(endOf(likelihood, best, most, -1)),
                  std::exp(endOf(likelihood, best, most, 1))};
  result.deviation = withU ? std::exp(best[LogSigma]) : 0;
  result.dispersion = best[LogK] >= kMostK - 0.01 ? 0 : std::exp(-best[LogK]);
  return result;
}

}  // namespace surefoot
