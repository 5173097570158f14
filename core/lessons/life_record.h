// SPDX-License-Identifier: GPL-3.0-or-later
// A life of a lesson in a few lines, so that it can be lived again, bit for bit, up to a step: what it began with, as
// far as it differs from the lesson's start, and everything that was done to it.
#pragma once

#include <atomic>
#include <memory>

#include "core/basics/typed_json.h"
#include "core/lessons/lesson.h"

namespace surefoot {

struct LifeRecord {
  /// The life whose Q-function this one began with; nullptr: that of the lesson's start.
  std::shared_ptr<const LifeRecord> learnedFrom{};
  std::string agent{}, scenario{}, policy{};
  std::uint64_t seed = 1;
  std::vector<Assignment> set{};       ///< parameters that are not as in the lesson's start
  std::vector<CommandText> changes{};  ///< what was done to it, with the steps
  std::int64_t steps = 0;              ///< steps of the life until now
  std::uint64_t hash = 0;              ///< Life::hash() now
};

/// `began`: the configuration at the life's beginning.
LifeRecord recordOf(const Lesson& lesson, const Configuration& began, const Life& life,
                    std::shared_ptr<const LifeRecord> learnedFrom);

/// The configuration at the life's beginning, without the changes.
Result<Configuration> startOf(const Registry& registry, const Lesson& lesson, const LifeRecord& record);

/// The configuration of a life that begins with what `from` has learned.
Configuration transferred(const Life& from, Configuration to);

/// A life with what it began with.
struct LifeInHand {
  Configuration began;  ///< the configuration at its beginning
  std::unique_ptr<Life> life;
  std::shared_ptr<const LifeRecord> learnedFrom{};
  StepTaken last{};  ///< if a step was made in hand
  /// The configuration as the life has it now.
  Configuration now() const;
};
/// Lives it again. An error: it cannot be lived so, or it comes out otherwise than the record says.
/// `interrupted`, set by anyone, ends it early, with an error.
Result<LifeInHand> relive(const Registry& registry, const Lesson& lesson, const LifeRecord& record,
                          const std::atomic<bool>* interrupted = nullptr);

Json asJson(const LifeRecord& record);
/// Nothing of the text is believed but its form: relive() tells the rest.
Result<LifeRecord> lifeRecordOf(const Json& json);

}  // namespace surefoot
