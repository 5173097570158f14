// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plans/plan_condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/environment_library.h"
#include "core/saved/q_file.h"
#include "core/saved/teacher_file.h"

namespace surefoot {

namespace {

constexpr int kMostPool = 1'000'000;
constexpr std::int64_t kMostEpisodes = 1'000'000'000;

/// The seed of what `text` describes, in this plan.
std::uint64_t seedFor(std::string_view text, const PlanHead& head) {
  Hash64 hash;
  hash.add(head.seed);
  hash.add(text);
  if (!head.series.empty()) hash.add(head.series);
  return hash.value();
}

/// Makes one condition; everything that it needs to know of the plan is in `head`.
class ConditionMaker {
 public:
  ConditionMaker(const Registry& registry, const std::string& path, const PlanHead& head)
      : registry_(registry),
        path_(path),
        head_(head) {}

  Result<Condition> make(const Combination& c, int line) {
    const auto refuse = [&](const std::string& sentence) { return planError(path_, line, sentence); };
    Draft draft;
    if (const Status s = read(c, draft); !s) return s.error();
    auto teacher = takeTeacher(draft.assignments, std::filesystem::path(path_).parent_path().string());
    if (!teacher) return refuse(teacher.error().message);
    auto configuration = configure(registry_, draft.names, draft.assignments);
    if (!configuration) return refuse(configuration.error().message);
    if (const Status s = checkPolicy(draft); !s) return refuse(s.error().message);

    Condition condition;
    Configuration& now = condition.configuration = std::move(*configuration);
    now.teacher = std::move(*teacher);
    now.lives = head_.lives;
    now.minutes = draft.minutes;
    now.episodes = draft.episodes;
    if (!now.minutes && !now.episodes)
      return refuse("minutes or episodes: how long a life is must be given, e.g. minutes = 9.");
    condition.varied = c.varied;
    condition.text = describe(registry_, now);
    if (now.teacher) condition.text += " guardian=" + contentOf(*now.teacher);
    if (const Status s = addPreLearning(c, draft, condition, line); !s) return s.error();
    if (!draft.file.empty())
      if (const Status s = readStart(draft.file, condition); !s) return refuse(s.error().message);
    now.seed = !head_.paired ? seedFor(condition.text, head_) : head_.series.empty() ? head_.seed : seedFor("", head_);
    if (now.minutes) condition.text += fmt::format(" minutes={}", *now.minutes);
    if (now.episodes) condition.text += fmt::format(" episodes={}", *now.episodes);
    condition.name = nameOf(c, draft.name, true);
    if (condition.name.empty()) condition.name = draft.names.policy;
    condition.name = head_.system.prefix + condition.name;
    if (const std::string unknown = placeholderIn(condition.name); !unknown.empty())
      return planError(path_, c.where.at("name")->line,
                       fmt::format("name: {} is none of the condition's own settings.", unknown));
    condition.reference = nameOf(c, draft.reference, false);
    if (!condition.reference.empty()) condition.reference = head_.system.prefix + condition.reference;
    if (const Status s = tryOut(condition); !s) return refuse(s.error().message);
    return condition;
  }

 private:
  /// The settings with which a condition, or its pre-learning, is configured.
  struct Draft {
    Names names;
    std::vector<Assignment> assignments;
    std::string name, reference, file;
    std::optional<double> minutes, until, preMinutes;
    std::optional<std::int64_t> episodes, cap;
    int pool = 5;
  };

  Status read(const Combination& c, Draft& draft) const {
    draft.reference = head_.reference;
    draft.assignments = head_.system.assignments;
    for (const auto& [key, value] : c.all) {
      Status status = Done{};
      if (key == "name")
        draft.name = value;
      else if (key == "reference")
        draft.reference = value;
      else if (key.starts_with("set."))
        draft.assignments.push_back({key.substr(4), value});
      else if (key == "minutes")
        status = readNumber(key, value, 1e-6, 1e6, draft.minutes);
      else if (key == "episodes")
        status = readCount(key, value, kMostEpisodes, draft.episodes);
      else if (key == "pre-learning.file")
        draft.file = value;
      else if (key == "environment")
        status = readEnvironment(value, draft.names.environment);
      else if (std::string* part = nameField(draft.names, key))
        *part = value;
      else if (key == "base")
        status = Error{fmt::format("base = {}: in a condition it is false: nothing of [base] holds there.", value)};
      else if (key == "set")
        status = Error{"set: it goes with the key of a parameter, e.g. set.features.scale = 1."};
      else if (key == "pre-learning" && value != "false")
        status = Error{fmt::format(
            "pre-learning = {}: it is false, or goes with a key, e.g. pre-learning.scenario = \"2\".", value)};
      else if (!key.starts_with("pre-learning"))
        status = unknownKey(key, {"name", "reference", "environment", "preset", "scenario", "agent", "features",
                                  "policy", "set", "minutes", "episodes", "pre-learning", "base"});
      if (!status) return planError(path_, c.where.at(key)->line, status.error().message);
    }
    draft.assignments.insert(draft.assignments.end(), head_.assignments.begin(), head_.assignments.end());
    if (hasPreset(draft.names.environment)) draft.names.preset = *head_.preset;
    return Done{};
  }

  /// A name, or the file of a robot: beside the plan, if its path does not begin at the root.
  Status readEnvironment(const std::string& value, std::string& name) const {
    const auto named = environmentNamed(registry_, environmentBeside(path_, value));
    if (!named) return named.error();
    name = *named;
    return Done{};
  }

  /// Whether the preset that all conditions shall have is one of this environment.
  bool hasPreset(const std::string& environment) const {
    return head_.preset && findPreset(registry_, environment, *head_.preset);
  }

  /// The settings under pre-learning; false: there are none.
  Result<bool> readPreLearning(const Combination& c, Draft& draft) const {
    const std::string prefix = "pre-learning.";
    bool wanted = false;
    for (const auto& [fullKey, value] : c.all) {
      if (fullKey == "pre-learning" && value == "false") return false;
      if (!fullKey.starts_with("pre-learning") || fullKey == "pre-learning.file") continue;
      wanted = true;
      const std::string key = fullKey.substr(std::min(fullKey.size(), prefix.size()));
      Status status = Done{};
      if (key == "scenario")
        draft.names.scenario = value;
      else if (key == "preset")
        draft.names.preset = value;
      else if (key == "policy")
        draft.names.policy = value;
      else if (key.starts_with("set."))
        draft.assignments.push_back({key.substr(4), value});
      else if (key == "until")
        status = readNumber(key, value, -1e6, 1e6, draft.until);
      else if (key == "cap")
        status = readCount(key, value, kMostEpisodes, draft.cap);
      else if (key == "minutes")
        status = readNumber(key, value, 1e-6, 1e9, draft.preMinutes);
      else if (key == "pool" && value == "each")
        draft.pool = 0;
      else if (key == "pool")
        status = readCount(key, value, kMostPool, draft.pool);
      else
        status = unknownKey(key, {"scenario", "preset", "policy", "set", "until", "minutes", "cap", "pool", "file"});
      if (!status) return planError(path_, c.where.at(fullKey)->line, "pre-learning: " + status.error().message);
    }
    if (hasPreset(draft.names.environment)) draft.names.preset = *head_.preset;
    return wanted;
  }

  /// The pre-learning without what is learned of risk beside it: that changes no value, so that conditions with and
  /// without it begin with the same Q-functions.
  Configuration withoutRisk(Configuration c) const {
    for (const auto& entry : c.parameters.all())
      if (entry.parameter.key.starts_with("risk."))
        static_cast<void>(static_cast<bool>(c.parameters.set(entry.parameter.key, entry.usual)));
    return c;
  }

  /// Everything of the condition but policy and step sizes, on its own scenario, until the reward is reached.
  Status addPreLearning(const Combination& c, Draft draft, Condition& condition, int line) const {
    constexpr std::int64_t kCap = 20'000;
    const auto refuse = [&](const std::string& sentence) {
      return planError(path_, line, "pre-learning: " + sentence);
    };
    draft.names.policy = "epsilon-greedy";
    std::erase_if(draft.assignments, [](const Assignment& a) { return !isInherited(a.key); });
    const auto wanted = readPreLearning(c, draft);
    if (!wanted) return wanted.error();
    if (!*wanted) return Done{};
    if (!draft.file.empty()) return refuse("with a file nothing is learned before; take the other keys away.");
    if (!draft.until && !draft.preMinutes)
      return refuse(
          "until is missing: the average reward at which it ends, e.g. until = 198; or minutes, how long it takes.");
    auto configuration = configure(registry_, draft.names, draft.assignments);
    if (!configuration) return refuse(configuration.error().message);
    if (const Status s = checkPolicy(draft); !s) return refuse(s.error().message);

    PreLearning pre{.configuration = std::move(*configuration), .pool = draft.pool, .text = {}};
    pre.configuration.until = draft.until;
    pre.configuration.minutes = draft.preMinutes;
    std::string length;
    if (draft.until) length += fmt::format(" until={}", *draft.until);
    if (draft.preMinutes) length += fmt::format(" minutes={}", *draft.preMinutes);
    if (draft.until || draft.cap) {
      const std::int64_t cap = draft.cap.value_or(kCap);
      pre.configuration.episodes = cap;
      length += fmt::format(" cap={}", cap);
    }
    pre.text = describe(registry_, pre.configuration) + length;
    pre.configuration.seed = seedFor(describe(registry_, withoutRisk(pre.configuration)) + length, head_);
    condition.text += fmt::format(" pre-learning=({}) pool={}", pre.text,
                                  pre.pool == 0 ? std::string("each") : std::to_string(pre.pool));
    condition.preLearning = std::move(pre);
    return Done{};
  }

  /// Everything a life is made from, except the parameters of its policy, which are in their ranges.
  static std::string partsOf(const Condition& condition) {
    const auto add = [](std::string& text, const Configuration& c) {
      const Names& n = c.names;
      for (const std::string* name : {&n.environment, &n.preset, &n.scenario, &n.agent, &n.features, &n.policy})
        text += *name + '\n';
      for (const auto& entry : c.parameters.all())
        if (!entry.parameter.key.starts_with("policy.")) text += fmt::format("{} ", entry.value);
      if (c.beganWith.is_object()) text += c.beganWith.value("content", "");
    };
    std::string text;
    add(text, condition.configuration);
    if (condition.preLearning) add(text, condition.preLearning->configuration);
    return text;
  }

  /// Makes a life on trial, with its pre-learning: this finds errors that no single check can see. Once for equal
  /// parts.
  Status tryOut(const Condition& condition) const {
    if (!head_.tried->insert(partsOf(condition)).second) return Done{};
    Configuration now = condition.configuration;
    if (condition.preLearning) {
      const Configuration& before = condition.preLearning->configuration;
      const auto lesson = makeLife(registry_, before, 0, false);
      if (!lesson) return lesson.error();
      auto file = std::make_shared<TensorFile>(qFileOf(**lesson, before));
      file->name = "pre-learning";
      now.start = std::move(file);
    }
    if (const auto life = makeLife(registry_, now, 0, false); !life) return life.error();
    return Done{};
  }

  Status readStart(const std::string& file, Condition& condition) {
    const std::filesystem::path path(file);
    auto read = readQFile(path.is_absolute() ? file : (std::filesystem::path(path_).parent_path() / path).string());
    if (!read) return read.error();
    beginWith(condition.configuration, std::move(*read));
    condition.text += " began-with=" + condition.configuration.beganWith["content"].get<std::string>();
    return Done{};
  }

  /// A parameter of a policy that is not chosen would have no effect.
  Status checkPolicy(const Draft& draft) const {
    const auto keys = policyKeys(**findEntry(registry_.policies, "policy", draft.names.policy));
    for (const Assignment& a : draft.assignments)
      if (a.key.starts_with("policy.") && std::find(keys.begin(), keys.end(), a.key) == keys.end())
        return Error{fmt::format("{}: it has no effect under the policy {}.", a.key, draft.names.policy)};
    return Done{};
  }

  static std::string* nameField(Names& names, const std::string& key) {
    if (key == "preset") return &names.preset;
    if (key == "scenario") return &names.scenario;
    if (key == "agent") return &names.agent;
    if (key == "features") return &names.features;
    return key == "policy" ? &names.policy : nullptr;
  }

  const Registry& registry_;
  const std::string& path_;
  const PlanHead& head_;
};

}  // namespace

Result<Condition> makeCondition(const Registry& registry, const std::string& path, const PlanHead& head,
                                const Combination& combination, int line) {
  return ConditionMaker(registry, path, head).make(combination, line);
}

}  // namespace surefoot
