// SPDX-License-Identifier: GPL-3.0-or-later
// A life in a file: a Q-function with everything else that the life needs to go on as if it had never stopped, bit for
// bit, in the middle of an episode, too.
#pragma once

#include "core/experiment/configuration.h"
#include "core/files/tensor_file.h"

namespace surefoot {

/// The life began with `configuration`. Life::keepInputs() must have been called before its first step.
TensorFile checkpointOf(const Life& life, const Configuration& configuration, bool keepRows);

struct Resumed {
  Configuration configuration;  ///< the configuration at the life's beginning
  std::unique_ptr<Life> life;
  bool keepRows = false;
};

/// With longer limits than in its file a life goes on for longer.
struct NewLimits {
  std::optional<double> minutes;
  std::optional<std::int64_t> episodes;
};

/// Which program versions' lives may be continued (lives_version.h).
enum class Versions {
  Same,  ///< only lives of this program's version; others are refused
  Any    ///< others, too; the life notes the step, as a change of "lives_version"
};

Result<Resumed> resume(const Registry& registry, std::shared_ptr<const TensorFile> file, const NewLimits& limits,
                       Versions versions = Versions::Same);

/// Whether a checkpoint's life has the same version as the lives of this program.
Status checkLivesVersion(const TensorFile& file);

/// The key of that change.
inline constexpr const char* kOtherLives = "lives_version";

}  // namespace surefoot
