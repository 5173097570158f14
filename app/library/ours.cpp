// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library/ours.h"

#include "app/process/resources.h"
#include "core/basics/version.h"
#include "core/environment_library.h"
#include "core/environment_programs.h"
#include "core/register/register.h"
#include "physics/register.h"
#include "physics/world/box2d_binding.h"

namespace surefoot {

namespace {

Result<const Registry*> make() {
  if (const Status s = bindBox2d(); !s) return s.error();
  auto* registry = new Registry;  // never given back: threads may still live lives when the process ends
  registerCore(*registry);
  registerPhysics(*registry);
  registry->files->setShelf(resourceFolder("robots"));
  registry->programs->setModules(resourceFolder("robots/child"));
  return registry;
}

}  // namespace

Result<const Registry*> ourRegistry() {
  static const auto* registry = new Result<const Registry*>(make());
  return *registry;
}

}  // namespace surefoot

const char* surefoot_version(void) {
  return surefoot::kVersion;
}
