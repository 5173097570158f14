// SPDX-License-Identifier: GPL-3.0-or-later
// A life behind a handle.
#pragma once

#include <memory>

#include "app/library/handle.h"
#include "app/library/own_parts.h"
#include "core/experiment/configuration.h"

struct surefoot_life : surefoot::Handle {
  surefoot::Registry registry{};            ///< with the caller's own parts
  surefoot::Configuration configuration{};  ///< as the life began
  int index = 0;                            ///< which life of its seed
  std::shared_ptr<surefoot::Mishap> mishap = std::make_shared<surefoot::Mishap>();
  bool hasOwnPolicy = false;  ///< of the caller's
  std::unique_ptr<surefoot::Life> life{};
  double cpuSeconds = 0.0;

  const surefoot::Task& task() const { return life->environment().task(); }
};

namespace surefoot {

/// A call with a life.
template <class Work>
surefoot_status withLife(surefoot_life* life, const Work& work) {
  return call(life, "life", work);
}

}  // namespace surefoot
