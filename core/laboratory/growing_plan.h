// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a plan whose lives grow (plan_growth.h): lives, looks, and lives on until nothing more is wanted.
#pragma once

#include <functional>

#include "core/laboratory/laboratory.h"

namespace surefoot {

/// `live` runs the missing lives of a plan whose numbers are fixed.
Result<LabResult> runGrowing(const Registry& registry, const Plan& plan, Store& store,
                             const std::function<Result<LabResult>(const Plan&)>& live);

}  // namespace surefoot
