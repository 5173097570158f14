// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/file_kinds.h"

namespace surefoot {

namespace {
constexpr FileKind kKinds[] = {
    {"robot", "toml", true, "bodies, joints, motors, state and rewards of a robot of one's own, as text"},
    {"lesson", "toml", true, "steps, questions and tasks of a lesson, as text"},
    {"plan", "toml", true, "what an experiment lives: conditions, figures and claims, as text"},
    {"session", "surefoot", true, "a life with everything that it needs to go on in the window"},
    {"checkpoint", "safetensors", true, "a life with everything that it needs to go on"},
    {"Q-function", "safetensors", true, "what was learned, with everything that its numbers mean"},
    {"journal", "jsonl", true, "what was done to a life, by which it can be lived again"},
    {"store", "sqlite", true, "results of an experiment: every life and episode"},
    {"log", "csv", false, "a row an episode"},
};
}  // namespace

std::span<const FileKind> fileKinds() {
  return kKinds;
}

}  // namespace surefoot
