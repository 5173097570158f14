// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/register/register.h"

#include "core/agents/register.h"
#include "core/environments/register.h"
#include "core/policies/register.h"

namespace surefoot {

void registerCore(Registry& r) {
  r.features.push_back({{"tile-coder", "Tile coder", "Displaced grids of tiles, in a dense or hashed table."}});
  r.features.push_back({{"radial-basis", "Radial basis", "Gaussians on a grid, width and spacing set apart."}});
  r.features.push_back({{"table", "Table", "One value a state, for states of whole numbers."}});
  registerAgents(r);
  registerEnvironments(r);
  registerPolicies(r);
}

}  // namespace surefoot
