// SPDX-License-Identifier: GPL-3.0-or-later
// Values of actions that share weights (ActionTiles): one look-up of a state's tile brings a block of weights, in which
// every action has a column.
#pragma once

#include "core/features/action_tiles.h"
#include "core/values/weight_table.h"

namespace surefoot {

/// q_a ← Σ_k w(feature k, column of a in tiling k), in the order of the tilings. `features` has one feature of each
/// tiling, and each has `columns` columns. Hot.
void sumShared(const WeightTable& weights, std::span<const Index> features, std::size_t columns,
               const ActionTiles& tiles, std::span<double> q);

}  // namespace surefoot
