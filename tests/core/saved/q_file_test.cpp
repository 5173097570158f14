// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/saved/q_file.h"

#include "core/saved/carry_over.h"
#include "core/saved/checkpoint.h"
#include "core/saved/journal.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

struct Learner {
  const char* agent;
  const char* features;
  std::vector<Assignment> assignments;
};
const std::vector<Learner> kLearners = {
    {"sarsa", "tile-coder", {}},
    {"sarsa-2q", "tile-coder", {{"negative.scale", "0.5"}, {"positive.pole_angle_from", "-0.5"}}},
    {"q-learning", "radial-basis", {}},
    {"expected-sarsa", "tile-coder", {{"features.memory", "50000"}}},
    {"sarsa-2q", "tile-coder", {{"positive.memory", "60000"}, {"shaping.rewards", "losses"}}}};

Configuration configurationOf(const Registry& r, const Learner& learner) {
  Names names;
  names.agent = learner.agent, names.features = learner.features;
  auto c = configure(r, names, learner.assignments);
  EXPECT_TRUE(c) << c.error().message;
  c->episodes = 60;
  return *c;
}

void live(Life& life, std::int64_t steps = std::numeric_limits<std::int64_t>::max()) {
  for (std::int64_t i = 0; i < steps && !life.finished(); ++i) life.step();
}

/// Through bytes and back, as through a disk.
std::shared_ptr<const TensorFile> throughBytes(const TensorFile& file) {
  auto read = TensorFile::parse(file.write(), "q.safetensors");
  EXPECT_TRUE(read) << read.error().message;
  return std::make_shared<const TensorFile>(std::move(*read));
}

}  // namespace

TEST(QFile, LoadedAndAskedItAnswersBitForBit) {
  const Registry r = fullRegistry();
  for (const Learner& learner : kLearners) {
    Configuration c = configurationOf(r, learner);
    const auto life = lifeOf(r, c);
    live(*life);
    const auto file = throughBytes(qFileOf(*life, c));
    const auto again = configurationOf(r, *file);
    ASSERT_TRUE(again) << again.error().message;
    Configuration begun = *again;
    beginWith(begun, file);
    const auto other = makeLife(r, begun, 0, false);
    ASSERT_TRUE(other) << other.error().message;
    const ActionValueFunction &a = life->agent().values(), &b = (*other)->agent().values();
    Random random(3);
    std::vector<double> qa(5), qb(5);
    for (int i = 0; i < 1000; ++i) {
      const std::vector<double> s = {random.uniform(-1.4, 1.4), random.uniform(-16, 16), random.uniform(-30, 30)};
      for (const Layer layer : {Layer::Sum, Layer::Positive, Layer::Negative}) {
        a.evaluate(s, layer, qa);
        b.evaluate(s, layer, qb);
        ASSERT_EQ(qa, qb) << learner.agent << " " << learner.features;
      }
      ASSERT_EQ(a.visits(s), b.visits(s));
    }
    EXPECT_TRUE((*other)->preLearned());
  }
}

TEST(QFile, AMismatchNamesBothValues) {
  const Registry r = fullRegistry();
  const Configuration c = pendulumConfiguration(r);
  const auto file = throughBytes(qFileOf(*lifeOf(r, c), c));
  const auto refusal = [&](const char* agent, const char* features, const char* environment,
                           const std::vector<Assignment>& assignments) {
    Names names;
    names.agent = agent, names.features = features, names.environment = environment;
    auto other = configure(r, names, assignments);
    EXPECT_TRUE(other);
    beginWith(*other, file);
    const auto life = makeLife(r, *other, 0, false);
    return life ? std::string("accepted") : life.error().message;
  };
  const auto contains = [](const std::string& text, const std::vector<const char*>& words) {
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << word << ": " << text;
  };
  EXPECT_EQ(refusal("q-learning", "tile-coder", "pendulum", {{"environment.damping", "0.01"}}), "accepted");
  contains(refusal("sarsa", "tile-coder", "pendulum", {{"features.tilings", "8"}}), {"tilings", "16", "8"});
  contains(refusal("sarsa", "tile-coder", "pendulum", {{"features.pole_rate", "12"}}),
           {"tile_width of pole_rate", "1.047", "0.523"});
  contains(refusal("sarsa-2q", "tile-coder", "pendulum", {}), {"positive", "holds q"});
  contains(refusal("sarsa", "radial-basis", "pendulum", {}), {"kind", "tile-coder", "radial-basis"});
  contains(refusal("sarsa", "tile-coder", "mountain-car", {}), {"pole_angle", "velocity"});
}

TEST(QFile, AnUnknownMajorVersionOrKindIsRefused) {
  const Registry r = fullRegistry();
  const Configuration c = pendulumConfiguration(r);
  TensorFile file = qFileOf(*lifeOf(r, c), c);
  EXPECT_TRUE(checkKind(file, {"q-function"}));
  EXPECT_FALSE(checkKind(file, {"checkpoint"}));
  file.about["format"] = "1.7";
  EXPECT_TRUE(checkKind(file, {"q-function"})) << "a newer minor version adds, it changes nothing";
  file.about["format"] = "2.0";
  const Status status = checkKind(file, {"q-function"});
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().message.find("2.0"), std::string::npos) << status.error().message;
}

// A description may say anything: what it says is checked before memory is taken, and nothing is believed.
TEST(QFile, ADamagedDescriptionIsASentence) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(r);
  const TensorFile good = qFileOf(*lifeOf(r, c), c);
  const auto opened = [&](const TensorFile& file) {
    auto configuration = configurationOf(r, file);
    if (!configuration) return configuration.error().message;
    beginWith(*configuration, std::make_shared<const TensorFile>(file));
    const auto life = makeLife(r, *configuration, 0, false);
    return life ? std::string() : life.error().message;
  };
  EXPECT_EQ(opened(good), "");
  for (const char* key : {"configuration", "state", "actions", "estimates"})
    for (const Json& damage : {Json(nullptr), Json(3), Json("x"), Json::array({1, 2}), Json::object()}) {
      TensorFile bad = good;
      bad.about[key] = damage;
      EXPECT_NE(opened(bad), "") << key << " " << damage;
    }
  TensorFile huge = good;
  huge.about["configuration"]["parameters"]["features.scale"] = 4.5;  // a table of 600 MB that the file does not hold
  EXPECT_NE(opened(huge).find("tile_width"), std::string::npos) << opened(huge);
  TensorFile strange = good;
  strange.about["configuration"]["parameters"]["features.scales"] = 1;
  EXPECT_NE(opened(strange).find("features.scale"), std::string::npos) << opened(strange);
  TensorFile missing = good;
  missing.tensors.pop_back();
  EXPECT_NE(opened(missing), "");
}

// Saved in the middle of an episode, between two, with every kind of agent, with commands before and behind.
TEST(Checkpoint, AResumedLifeIsTheUninterruptedOne) {
  const Registry r = fullRegistry();
  for (const Learner& learner : kLearners) {
    Configuration c = configurationOf(r, learner);
    c.commands = {{300, "policy.epsilon", "0.2"},
                  {310, "environment.damping", "0.02"},
                  {900, "policy", "softmax"},
                  {1200, "environment.fall_reward", "-300"},
                  {1205, "push", "0.05"},
                  {3000, "push", "-0.05"},
                  {3001, "policy.temperature", "0.5"}};
    const auto whole = makeLife(r, c, 0, true);
    ASSERT_TRUE(whole) << whole.error().message;
    live(**whole);
    for (const std::int64_t stop : {0, 1, 305, 1000, 1206, 2500, 3000}) {
      auto first = makeLife(r, c, 0, true);
      (*first)->keepInputs();
      live(**first, stop);
      const auto file = throughBytes(checkpointOf(**first, c, true));
      auto resumed = resume(r, file, {});
      ASSERT_TRUE(resumed) << resumed.error().message;
      EXPECT_EQ(resumed->life->steps(), stop);
      EXPECT_EQ(resumed->life->hash(), (*first)->hash());
      const auto state = resumed->life->environment().state(), expected = (*first)->environment().state();
      EXPECT_TRUE(std::equal(state.begin(), state.end(), expected.begin(), expected.end()));
      live(*resumed->life);
      EXPECT_EQ(resumed->life->hash(), (*whole)->hash()) << learner.agent << " " << learner.features << " at " << stop;
      EXPECT_EQ(resumed->life->log().rows().size(), (*whole)->log().rows().size());
      EXPECT_EQ(resumed->life->changes().size(), (*whole)->changes().size());
      EXPECT_EQ(resumed->life->agent().statesOutside(), (*whole)->agent().statesOutside());
    }
  }
}

TEST(Checkpoint, OfOtherEnvironmentsToo) {
  const Registry r = fullRegistry();
  for (const EnvironmentEntry& environment : r.environments) {
    Names names;
    names.environment = environment.name;
    auto c = configure(
        r, names,
        {{"policy.epsilon_schedule", "linear"}, {"policy.epsilon_per", "steps"}, {"policy.epsilon_end", "0.5"}});
    ASSERT_TRUE(c) << c.error().message;
    c->episodes = 30;
    const auto whole = lifeOf(r, *c), first = lifeOf(r, *c);
    first->keepInputs();
    live(*whole);
    live(*first, whole->steps() / 2);
    auto resumed = resume(r, throughBytes(checkpointOf(*first, *c, false)), {});
    ASSERT_TRUE(resumed) << environment.name << ": " << resumed.error().message;
    live(*resumed->life);
    EXPECT_EQ(resumed->life->hash(), whole->hash()) << environment.name;
  }
}

// Every tensor of a checkpoint, missing or filled with other bytes: a sentence or a life, never a crash.
TEST(Checkpoint, ADamagedTensorIsASentence) {
  const Registry r = fullRegistry();
  const Configuration c = configurationOf(r, kLearners[4]);
  const auto life = lifeOf(r, c);
  life->keepInputs();
  live(*life, 1000);
  const TensorFile good = checkpointOf(*life, c, true);
  for (std::size_t i = 0; i < good.tensors.size(); ++i) {
    TensorFile bad = good;
    bad.tensors.erase(bad.tensors.begin() + static_cast<std::ptrdiff_t>(i));
    const bool newer = good.tensors[i].name == "learning.explored";  // files of older versions lack it
    EXPECT_EQ(static_cast<bool>(resume(r, std::make_shared<const TensorFile>(bad), {})), newer)
        << good.tensors[i].name << " is missing";
    bad = good;
    for (char& byte : bad.tensors[i].bytes) byte = '\x7f';
    auto resumed = resume(r, std::make_shared<const TensorFile>(bad), {});
    if (resumed) live(*resumed->life, 100);
  }
}

// −1 is no action, also where the hand-made controller's −2 is one.
TEST(Checkpoint, AnActionThatThereIsNotIsRefused) {
  const Registry r = fullRegistry();
  Names names;
  names.environment = "leo";
  auto c = configure(r, names, {{"features.memory", "4096"}});
  ASSERT_TRUE(c);
  c->minutes = 0.1;
  const auto life = lifeOf(r, *c);
  life->keepInputs();
  live(*life, 50);
  TensorFile file = checkpointOf(*life, *c, true);
  for (Tensor& t : file.tensors)
    if (t.name == "action") t.bytes.assign(t.bytes.size(), '\xff');
  const auto resumed = resume(r, std::make_shared<const TensorFile>(file), {});
  ASSERT_FALSE(resumed);
  EXPECT_NE(resumed.error().message.find("\"action\" is out of range"), std::string::npos) << resumed.error().message;
}

TEST(Journal, ALifeIsLivedAgainWithEverythingThatWasDoneToIt) {
  const Registry r = fullRegistry();
  Configuration c = configurationOf(r, kLearners[1]);
  c.commands = {{300, "policy.epsilon", "0.2"}, {900, "policy", "trl"}, {1205, "push", "0.05"}, {1205, "push", "0.01"}};
  const auto lives = runLives(r, c, {});
  ASSERT_TRUE(lives);
  const std::string text = journalOf(c, lives->front());
  auto journal = parseJournal(r, text, "j");
  ASSERT_TRUE(journal) << journal.error().message;
  EXPECT_EQ(journal->hash, lives->front().hash);
  const auto again = replay(r, *journal, {});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->hash, lives->front().hash);
  journal->configuration.commands.erase(journal->configuration.commands.begin());
  EXPECT_NE(replay(r, *journal, {})->hash, lives->front().hash) << "without one of them it is another life";
}

TEST(Journal, ADamagedOneIsASentence) {
  const Registry r = fullRegistry();
  Configuration c = configurationOf(r, kLearners[0]);
  c.commands = {{300, "policy.epsilon", "0.2"}};
  const std::string text = journalOf(c, runLives(r, c, {})->front());
  const auto message = [&](const std::string& damaged) {
    const auto journal = parseJournal(r, damaged, "j");
    return journal ? std::string() : journal.error().message;
  };
  EXPECT_EQ(message(text), "");
  for (std::size_t length = 0; length + 2 < text.size(); length += 7) EXPECT_NE(message(text.substr(0, length)), "");
  EXPECT_NE(message("").find("no journal"), std::string::npos);
  const auto second = text.find('\n') + 1;
  EXPECT_NE(message(text.substr(0, second) + "nonsense\n" + text.substr(second)).find("line 2"), std::string::npos);
  EXPECT_NE(message(text.substr(0, second) + "{\"step\":1e99,\"key\":\"a\",\"value\":\"b\"}\n").find("line 2"),
            std::string::npos);
}

// The same resolution: what is left is what the fit cannot close. A coarser one: a larger error, and it is told.
TEST(Resample, CarriesTheFunctionOver) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(r);
  c.minutes = 1.0;
  const auto life = lifeOf(r, c);
  live(*life);
  const ActionValueFunction& from = life->agent().values();
  const auto error = [&](const std::vector<Assignment>& assignments) {
    const auto to = lifeOf(r, pendulumConfiguration(r, "epsilon-greedy", assignments));
    return carryOver(from, const_cast<Agent&>(to->agent()), life->environment().task());
  };
  const CarriedError same = error({}), coarse = error({{"features.scale", "0.5"}});
  EXPECT_LT(same.rms, 0.1) << "of values from −100 to 200";
  EXPECT_GT(coarse.rms, 5 * same.rms);
  EXPECT_LT(coarse.rms, 10.0);
  EXPECT_GT(same.visited, 500);
  EXPECT_GE(same.largest, same.rms);
}

}  // namespace surefoot
