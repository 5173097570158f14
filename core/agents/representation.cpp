// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/representation.h"

#include <fmt/format.h>

#include "core/basics/expects.h"
#include "core/files/json_difference.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

void RepresentationSettings::declare(const std::string& features, Fields& f) {
  if (features == "tile-coder") tiles.declare(f);
  if (features == "radial-basis") gaussians.declare(f);  // a table has nothing to set
}

namespace {

template <class F>
Result<AnyFeatures> any(Result<F> features) {
  if (!features) return features.error();
  return AnyFeatures(std::move(*features));
}

}  // namespace

Result<AnyFeatures> makeFeatures(const Task& task, const std::string& features, const RepresentationSettings& s) {
  if (features == "table") return any(Table::create(task));
  if (features == "radial-basis") return any(RadialBasis::create(task, s.gaussians));
  expects(features == "tile-coder", "the names of feature maps were checked before");
  if (s.tiles.memory > 0) return any(HashedTileCoder::create(task, s.tiles));
  return any(TileCoder::create(task, s.tiles));
}

Status checkLayout(const TensorFile& stored, const std::string& name, const Json& layout,
                   const std::vector<std::size_t>& shape, bool growing) {
  const Json& about = stored.about;
  if (!about.contains("estimates") || !about["estimates"].is_object())
    return fileError(stored.name, "its description names no estimates; the file is damaged.");
  if (!about["estimates"].contains(name)) {
    std::vector<std::string> there;
    for (const auto& [key, value] : about["estimates"].items()) there.emplace_back(shortened(key));
    return fileError(stored.name, fmt::format("the agent needs the estimate \"{}\", and the file holds {}; choose the "
                                              "agent that it was learned by.",
                                              name, joinWords(there, "and")));
  }
  if (const auto found = firstDifference(about["estimates"][name], layout, ""))
    return fileError(stored.name,
                     fmt::format("its {} is {}, and {} in the configuration; set it alike, or carry the file "
                                 "over with `surefoot resample`.",
                                 found->where, found->theirs, found->ours));
  const Tensor* weights = stored.find(name + ".weights");
  const auto fits = [&](const std::vector<std::size_t>& theirs) {
    return theirs.size() == shape.size() && std::equal(theirs.begin() + 1, theirs.end(), shape.begin() + 1) &&
           (growing ? theirs[0] <= shape[0] : theirs[0] == shape[0]);
  };
  if (!weights || weights->type != ElementType::F64 || !fits(weights->shape))
    return fileError(stored.name,
                     fmt::format("the tensor \"{}.weights\" is missing, or not a table of {}{} numbers of type F64.",
                                 name, growing ? "at most " : "", fmt::join(shape, " × ")));
  return Done{};
}

}  // namespace surefoot
