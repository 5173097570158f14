// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold of every environment, whoever adds it: its words, its step limit, its states, its pictures, its
// measures.
#include <cmath>
#include <set>

#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

constexpr double kSteps = 500;

/// With a step limit that random actions reach.
std::unique_ptr<Environment> limited(const EnvironmentEntry& entry, double steps = kSteps) {
  auto environment = entry.make();
  Fields fields("");
  environment->declare(fields);
  for (const auto& field : fields.all())
    if (field.parameter.key == "max_steps") field.set(steps);
  environment->parametersChanged();
  return environment;
}

Action anyAction(const Environment& environment, Random& random) {
  return static_cast<Action>(random.next() % environment.task().actions.size());
}

template <class List, class Name>
void expectUnique(const List& list, const Name& nameOf, const std::string& where) {
  std::set<std::string> names;
  for (const auto& item : list) {
    EXPECT_FALSE(nameOf(item).empty()) << where;
    EXPECT_TRUE(names.insert(nameOf(item)).second) << where << ": " << nameOf(item) << " is there twice";
  }
}

/// Whether two pictures differ in any number.
bool differ(const Scene& a, const Scene& b) {
  const auto numbers = [](const Scene& scene) {
    std::vector<double> all = {scene.focus.x, scene.tip.x, scene.tip.y};
    for (const Shape& shape : scene.shapes) {
      if (const auto* line = std::get_if<Polyline>(&shape))
        for (const Point& p : line->points) all.insert(all.end(), {p.x, p.y});
      if (const auto* polygon = std::get_if<Polygon>(&shape))
        for (const Point& p : polygon->points) all.insert(all.end(), {p.x, p.y});
      if (const auto* disc = std::get_if<Disc>(&shape)) all.insert(all.end(), {disc->centre.x, disc->centre.y});
    }
    return all;
  };
  return numbers(a) != numbers(b);
}

}  // namespace

TEST(EnvironmentContract, EveryKeyStandsOnce) {
  const Registry r = fullRegistry();
  for (const EnvironmentEntry& entry : r.environments) {
    const auto environment = entry.make();
    const Task& task = environment->task();
    expectUnique(
        task.state, [](const StateVariable& v) { return v.key; }, entry.name + ", state");
    expectUnique(
        task.measures, [](const TaskMeasure& m) { return m.key; }, entry.name + ", measures");
    expectUnique(
        task.rewardTerms, [](const std::string& term) { return term; }, entry.name + ", rewards");
    for (const AgentEntry& agent : r.agents)
      for (const FeatureEntry& features : r.features) {
        Names names;
        names.environment = entry.name, names.agent = agent.name, names.features = features.name;
        if (const auto c = configure(r, names, {}))
          expectUnique(
              c->parameters.all(), [](const auto& e) { return e.parameter.key; }, entry.name + agent.name);
      }
  }
}

TEST(EnvironmentContract, AClockGoesForwardAndMeasuresAreAsTheTaskSays) {
  for (const EnvironmentEntry& entry : fullRegistry().environments) {
    const auto environment = limited(entry);
    const Task& task = environment->task();
    if (task.stepTime) {
      EXPECT_GT(*task.stepTime, 0.0) << entry.name;
    }
    ASSERT_LE(task.measures.size(), static_cast<std::size_t>(kMaxMeasures)) << entry.name;
    Random random(3);
    environment->reset(random);
    for (int step = 0; step < 2000; ++step) {
      ASSERT_EQ(environment->measures().size(), task.measures.size()) << entry.name;
      for (const double m : environment->measures()) ASSERT_TRUE(std::isfinite(m)) << entry.name;
      if (environment->step(anyAction(*environment, random)).ending != Ending::None) environment->reset(random);
    }
  }
}

TEST(EnvironmentContract, StatesLieWithinTheirRanges) {
  for (const EnvironmentEntry& entry : fullRegistry().environments) {
    const auto environment = limited(entry);
    const Task& task = environment->task();
    Random random(4);
    environment->reset(random);
    for (int step = 0; step < 5000; ++step) {
      for (std::size_t d = 0; d < task.state.size(); ++d) {
        const StateVariable& v = task.state[d];
        const double x = environment->state()[d];
        if (v.whole) {
          ASSERT_EQ(x, std::round(x)) << entry.name << " " << v.key;
          ASSERT_GE(x, v.low) << entry.name << " " << v.key;
          ASSERT_LE(x, v.high) << entry.name << " " << v.key;
        }
        if (v.period) {
          ASSERT_LE(std::abs(x), *v.period) << entry.name << " " << v.key;
        }
      }
      if (environment->step(anyAction(*environment, random)).ending != Ending::None) environment->reset(random);
    }
  }
}

TEST(EnvironmentContract, EveryEpisodeHasTheWholeStepLimit) {
  for (const EnvironmentEntry& entry : fullRegistry().environments) {
    constexpr int kLimit = 40, kEpisodes = 200;
    const auto environment = limited(entry, kLimit);
    Random random(6);
    int cutOff = 0;
    for (int episode = 0; episode < kEpisodes; ++episode) {
      environment->reset(random);
      for (int step = 1;; ++step) {
        const Ending ending = environment->step(anyAction(*environment, random)).ending;
        ASSERT_LE(step, kLimit) << entry.name;
        if (ending == Ending::Truncated) {
          ASSERT_EQ(step, kLimit) << entry.name << ", episode " << episode;
        }
        cutOff += ending == Ending::Truncated;
        if (ending != Ending::None) break;
      }
    }
    EXPECT_GT(cutOff + (entry.name == "random-walk" || entry.name == "chain" || entry.name == "leo"), 0) << entry.name;
  }
}

TEST(EnvironmentContract, PlacingPutsTheBodyThere) {
  for (const EnvironmentEntry& entry : fullRegistry().environments) {
    const auto environment = limited(entry);
    Random random(7);
    environment->reset(random);
    std::vector<std::vector<double>> seen;
    for (int step = 0; step < 300; ++step) {
      if (environment->step(anyAction(*environment, random)).ending != Ending::None) environment->reset(random);
      if (step % 30 == 0) seen.emplace_back(environment->state().begin(), environment->state().end());
    }
    for (const auto& state : seen) {
      if (!checkState(environment->task(), state)) continue;
      environment->reset(random);
      if (!environment->place(state)) continue;
      for (std::size_t d = 0; d < state.size(); ++d)
        EXPECT_NEAR(environment->state()[d], state[d], 1e-6 * std::max(1.0, std::abs(state[d])))
            << entry.name << " " << environment->task().state[d].key;
    }
  }
}

// Measures are of one episode: what came before a placement is not in them.
TEST(EnvironmentContract, MeasuresBeginAnewWithAPlacement) {
  for (const EnvironmentEntry& entry : fullRegistry().environments) {
    const auto walked = limited(entry), fresh = limited(entry);
    if (walked->task().measures.empty()) continue;
    Random random(9), other(10);
    walked->reset(random);
    fresh->reset(other);
    const std::vector<double> begin(fresh->state().begin(), fresh->state().end());
    for (int step = 0; step < 200; ++step)
      if (walked->step(anyAction(*walked, random)).ending != Ending::None) walked->reset(random);
    if (!walked->place(begin) || !fresh->place(begin)) continue;
    for (std::size_t m = 0; m < walked->measures().size(); ++m)
      EXPECT_NEAR(walked->measures()[m], fresh->measures()[m], 1e-9)
          << entry.name << " " << walked->task().measures[m].key;
  }
}

TEST(EnvironmentContract, APictureShowsThePose) {
  for (const EnvironmentEntry& entry : fullRegistry().environments) {
    const auto environment = limited(entry);
    Random random(8);
    environment->reset(random);
    const std::vector<double> first = environment->pose();
    std::vector<double> other = first;
    for (int step = 0; step < 200 && other == first; ++step) {
      if (environment->step(anyAction(*environment, random)).ending != Ending::None) break;
      other = environment->pose();
    }
    if (other == first) continue;
    Scene a, b;
    environment->draw(first, a);
    environment->draw(other, b);
    EXPECT_TRUE(differ(a, b)) << entry.name;
  }
}

}  // namespace surefoot
