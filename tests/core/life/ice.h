// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds whose states do not tell everything, to go back in, and an agent that notes what it is told.
#pragma once

#include "core/agents/agent_around.h"
#include "core/environments/small_world.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

/// A cart on ice between two edges: an action adds ±0.5 to its speed, which the state does not tell. Beyond x = ±4 it
/// falls; beyond 2 it is a success if it is slow. By hand: from x = 0 three steps to the right are x = 0.5, 1.5, 3.
class Ice : public SmallWorld<1> {
 public:
  Ice() {
    task_.state = {{.key = "x", .title = "x", .symbol = "x", .low = -4, .high = 4, .span = 1, .spanText = "1"}};
    task_.state[0].resolution = 2;
    task_.actions = {-0.5, 0.5};
    task_.actionTitle = "push";
    task_.rewardTerms = {"fall", "goal"};
    task_.measures = {{.key = "way", .title = "way"}};
    limit_.most = 60;
  }
  void reset(Random& random) override {
    state_[0] = random.uniform(-1, 1);
    speed_ = 0.0, way_ = {0.0};
    limit_.steps = 0;
  }
  Outcome step(Action action) override {
    speed_ += task_.actions[static_cast<std::size_t>(action)];
    state_[0] += speed_;
    way_[0] += std::abs(speed_);
    Outcome outcome;
    if (std::abs(state_[0]) > 4) {
      outcome.reward = outcome.terms[0] = -10.0;
      outcome.ending = Ending::Terminal;
      outcome.event = Event::Fall;
    } else if (std::abs(state_[0]) > 2 && std::abs(speed_) <= 0.5) {
      outcome.reward = outcome.terms[1] = 10.0;
      outcome.ending = Ending::Terminal;
      outcome.event = Event::Success;
    }
    limit_.count(outcome);
    return outcome;
  }
  bool push(double impulse) override {
    speed_ += impulse;
    return true;
  }
  std::span<const double> measures() const override { return way_; }
  std::vector<double> pose() const override { return {state_[0], speed_, way_[0], static_cast<double>(limit_.steps)}; }
  void draw(std::span<const double>, Scene&) const override {}
  std::vector<ReadOut> readOuts(std::span<const double>) const override { return {}; }

 protected:
  double speed_ = 0.0;
  std::array<double, 1> way_{};
};

/// Its first episode is like no other: later ones end with their first step.
class Thaw final : public Ice {
 public:
  void reset(Random& random) override {
    Ice::reset(random);
    if (++resets_ > 1) state_[0] = 5.0;
  }

 private:
  int resets_ = 0;
};

/// It takes its time.
class SlowIce final : public Ice {
 public:
  bool answersAtOnce() const override { return false; }
};

/// What an agent was told, and in which state its episodes began.
struct Told {
  int starts = 0, ends = 0, cuts = 0;
  std::vector<double> begins;
};

class Listening final : public AgentAround {
 public:
  Listening(std::unique_ptr<Agent> agent, Told& told) : AgentAround(std::move(agent)), told_(told) {}
  Action start(std::span<const double> state, Random& random) override {
    ++told_.starts;
    told_.begins.push_back(state[0]);
    return AgentAround::start(state, random);
  }
  void end(const Outcome& outcome) override {
    ++told_.ends;
    AgentAround::end(outcome);
  }
  Action truncate(const Outcome& outcome, std::span<const double> state, Random& random) override {
    ++told_.cuts;
    return AgentAround::truncate(outcome, state, random);
  }

 private:
  Told& told_;
};

inline Registry withIce(Told& told) {
  Registry r = fullRegistry();
  r.environments.push_back({{"ice", "Ice", "A cart on ice."}, [] { return std::make_unique<Ice>(); }});
  r.environments.push_back({{"thaw", "Thaw", "Never the same."}, [] { return std::make_unique<Thaw>(); }});
  r.environments.push_back(
      {{"slow-ice", "Slow ice", "It takes its time."}, [] { return std::make_unique<SlowIce>(); }});
  AgentEntry listening = **findEntry(r.agents, "agent", "sarsa");
  listening.name = "listening";
  listening.make = [make = listening.make, &told](const AgentParts& parts) -> Result<std::unique_ptr<Agent>> {
    auto inner = make(parts);
    if (!inner) return inner.error();
    return std::unique_ptr<Agent>(std::make_unique<Listening>(std::move(*inner), told));
  };
  r.agents.push_back(listening);
  return r;
}

inline Configuration rewinding(const Registry& r, const std::string& environment, const std::string& steps,
                               const std::string& most, const std::string& agent = "sarsa") {
  auto c = configure(r, {.environment = environment, .agent = agent},
                     {{"life.rewind", steps}, {"life.rewinds", most}, {"policy.epsilon", "0.3"}});
  EXPECT_TRUE(c) << c.error().message;
  c->episodes = 200;
  return *c;
}

inline void livePart(Life& life, std::int64_t steps = std::numeric_limits<std::int64_t>::max()) {
  while (life.steps() < steps && !life.finished()) life.step();
}

}  // namespace surefoot
