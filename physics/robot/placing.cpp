// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/placing.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace surefoot {

Placing::Placing(const RobotSpec& spec, const RobotNumbers& numbers, const Assembly& assembly,
                 std::span<const double> values)
    : spec_(spec),
      assembly_(assembly),
      values_(values.begin(), values.end()),
      u_(spec.actuators.size(), 0.0),
      world_(spec, numbers) {
  for (const StateSpec& state : spec.states) {
    low_.push_back(state.range[0](values_));
    range_.push_back(state.range[1](values_) - low_.back());
    period_.push_back(state.wrap ? range_.back() : 0.0);
  }
  findUnknowns();
}

void Placing::findUnknowns() {
  using What = Unknown::What;
  for (std::size_t b = 0; b < spec_.bodies.size(); ++b) {
    if (!assembly_.isFree(static_cast<int>(b)) || spec_.bodies[b].still) continue;
    for (const What what : {What::X, What::Y, What::Vx, What::Vy}) unknowns_.push_back({what, b});
    if (!spec_.bodies[b].rotates) continue;
    for (const What what : {What::Angle, What::Rate}) unknowns_.push_back({what, b});
  }
  for (std::size_t j = 0; j < spec_.joints.size(); ++j) {
    const auto kind = spec_.joints[j].kind;
    if (kind == JointSpec::Kind::Weld || kind == JointSpec::Kind::Distance) continue;
    for (const What what : {What::Joint, What::JointRate}) unknowns_.push_back({what, j});
  }
}

double& Placing::part(Coordinates& c, const Unknown& unknown) {
  switch (unknown.what) {
    case Unknown::What::X:
      return c.free[unknown.index].at.x;
    case Unknown::What::Y:
      return c.free[unknown.index].at.y;
    case Unknown::What::Angle:
      return c.free[unknown.index].angle;
    case Unknown::What::Vx:
      return c.free[unknown.index].velocity.x;
    case Unknown::What::Vy:
      return c.free[unknown.index].velocity.y;
    case Unknown::What::Rate:
      return c.free[unknown.index].rate;
    case Unknown::What::Joint:
      return c.joints[unknown.index];
    case Unknown::What::JointRate:
      break;
  }
  return c.jointRates[unknown.index];
}

std::vector<double> Placing::stateOf(const std::vector<BodyPlacement>& bodies) {
  const auto place = [&](NameKind kind, std::size_t i) {
    return static_cast<std::size_t>(spec_.names.placeOf(kind, static_cast<int>(i)));
  };
  world_.place(bodies);
  for (std::size_t m = 0; m < spec_.memories.size(); ++m)
    values_[place(NameKind::Memory, m)] = spec_.memories[m].start(values_);
  world_.readAll(values_, u_);
  for (std::size_t m = 0; m < spec_.memories.size(); ++m)
    if (!spec_.memories[m].substep && !spec_.memories[m].hasStart)
      values_[place(NameKind::Memory, m)] = spec_.memories[m].each(values_);
  std::vector<double> state;
  for (const StateSpec& spec : spec_.states) state.push_back(spec.value(values_));
  return state;
}

std::vector<double> Placing::misfit(const Coordinates& c, std::span<const double> state) {
  std::vector<double> off = stateOf(assembly_.settled(c));
  for (std::size_t s = 0; s < off.size(); ++s) {
    off[s] -= state[s];
    if (period_[s] > 0.0) off[s] -= period_[s] * std::floor(off[s] / period_[s] + 0.5);
    off[s] /= range_[s];
  }
  return off;
}

double Placing::descend(Coordinates& c, std::span<const double> state) {
  constexpr int kMostRounds = 60;
  constexpr double kStep = 1e-3, kStill = 1e-9;  // single precision: differences of 1e-3 are known to 1e-4
  const auto n = static_cast<Eigen::Index>(unknowns_.size()), rows = static_cast<Eigen::Index>(state.size());
  std::vector<double> off = misfit(c, state);
  std::vector<bool> moves(state.size(), false);
  const auto size = [&](const std::vector<double>& of) {
    double sum = 0.0;
    for (const double x : of) sum += x * x;
    return sum;
  };
  double damping = 1e-3;
  for (int round = 0; round < kMostRounds && size(off) > kStill * kStill; ++round) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows + n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(rows + n);
    for (Eigen::Index i = 0; i < n; ++i) {
      Coordinates near = c;
      part(near, unknowns_[static_cast<std::size_t>(i)]) += kStep;
      const std::vector<double> there = misfit(near, state);
      for (std::size_t s = 0; s < state.size(); ++s) {
        const double slope = (there[s] - off[s]) / kStep;
        a(static_cast<Eigen::Index>(s), i) = slope;
        moves[s] = moves[s] || std::abs(slope) > 1e-6;
      }
      a(rows + i, i) = std::sqrt(damping);
    }
    for (std::size_t s = 0; s < state.size(); ++s) b(static_cast<Eigen::Index>(s)) = -off[s];
    const Eigen::VectorXd step = a.colPivHouseholderQr().solve(b);
    Coordinates next = c;
    for (Eigen::Index i = 0; i < n; ++i) part(next, unknowns_[static_cast<std::size_t>(i)]) += step(i);
    std::vector<double> then = misfit(next, state);
    if (size(then) < size(off)) {
      c = std::move(next);
      off = std::move(then);
      damping = std::max(damping * 0.2, 1e-12);
    } else {
      damping *= 8.0;
      if (damping > 1e3) break;
    }
  }
  double most = 0.0;
  for (std::size_t s = 0; s < state.size(); ++s)
    if (moves[s]) most = std::max(most, std::abs(off[s]));
  return most;
}

std::optional<std::vector<BodyPlacement>> Placing::bodiesFor(std::span<const double> state) {
  constexpr int kStarts = 8;
  Random random(1);
  for (int attempt = 0; attempt < kStarts; ++attempt) {
    Coordinates c = assembly_.drawing();
    if (attempt > 0)
      for (const Unknown& unknown : unknowns_)
        if (unknown.what != Unknown::What::X && unknown.what != Unknown::What::Y)
          part(c, unknown) += random.uniform(-0.5, 0.5);
    const double off = descend(c, state);
    if (off < kNear) return assembly_.settled(c);
  }
  return std::nullopt;
}

}  // namespace surefoot
