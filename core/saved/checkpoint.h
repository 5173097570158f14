// SPDX-License-Identifier: GPL-3.0-or-later
// A life in a file: a Q-function with everything else that the life needs to go on as if it had never stopped, bit for
// bit, in the middle of an episode, too.
#pragma once

#include "core/experiment/configuration.h"
#include "core/files/tensor_file.h"

namespace surefoot {

/// `configuration` is the one that the life began with. Life::keepInputs() must have been called before its first step.
TensorFile checkpointOf(const Life& life, const Configuration& configuration, bool keepRows);

struct Resumed {
  Configuration configuration;  ///< the one that the life began with
  std::unique_ptr<Life> life;
  bool keepRows = false;
};

/// Longer limits than those of the file let the life go on for longer.
struct NewLimits {
  std::optional<double> minutes;
  std::optional<std::int64_t> episodes;
};

/// Whose lives may be gone on with (lives_version.h).
enum class Versions {
  Same,  ///< only those of this program; others are refused
  Any    ///< others, too; the life notes at which step, as a change of "lives_version"
};

Result<Resumed> resume(const Registry& registry, std::shared_ptr<const TensorFile> file, const NewLimits& limits,
                       Versions versions = Versions::Same);

/// Whether a checkpoint's life was lived by a version of the same lives.
Status checkLivesVersion(const TensorFile& file);

/// The key of that change.
inline constexpr const char* kOtherLives = "lives_version";

}  // namespace surefoot
