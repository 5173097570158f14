// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of an episode as a line of text, as journals have them.
#pragma once

#include <string>

#include "core/basics/result.h"
#include "core/life/episode_inputs.h"

namespace surefoot {

/// {"random":["1f…",…],"start":[…],"actions":[…],"pushes":[[step,impulse],…]}; the random words are hexadecimal.
std::string textOf(const EpisodeInputs& inputs);
/// The same back, for this task: refused is what is no text of this kind, an action that there is not, a start that is
/// no state, a push beyond the actions.
Result<EpisodeInputs> inputsFrom(const std::string& text, const Task& task);

}  // namespace surefoot
