// SPDX-License-Identifier: GPL-3.0-or-later
// The Q-function that can act as guardian (policy.guardian = FILE): named in settings, carried along in a life's file.
#pragma once

#include <string>

#include "core/experiment/configuration.h"
#include "core/files/tensor_file.h"

namespace surefoot {

/// Where the settings name a file as guardian, they say q-function from then on; the result is the file: null if they
/// name none. A path that does not begin at the root lies in `folder`.
Result<std::shared_ptr<const TensorFile>> takeTeacher(std::vector<Assignment>& assignments, const std::string& folder);

/// The teacher as a part of a life's file.
void packTeacher(TensorFile& life, const TensorFile& teacher);
/// The teacher in a life's file, checked as a file of its own; null: it has none.
Result<std::shared_ptr<const TensorFile>> teacherIn(const TensorFile& life);

}  // namespace surefoot
