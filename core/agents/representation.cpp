// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/representation.h"

#include <fmt/format.h>

#include "core/basics/expects.h"
#include "core/files/json_difference.h"
#include "core/files/refused_tensor.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

void RepresentationSettings::declare(const std::string& features, Fields& f) {
  if (features == "tile-coder") tiles.declare(f);
  if (features == "radial-basis") gaussians.declare(f);  // a table has nothing to set
}

namespace {

/// Every `from` in a text becomes `to`.
std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size()) text.replace(at, from.size(), to);
  return text;
}

/// Feature maps name their settings as those of q̂; other estimates have another prefix.
template <class F>
Result<AnyFeatures> any(Result<F> features, const std::string& prefix) {
  if (features) return AnyFeatures(std::move(*features));
  return Error{replaced(features.error().message, "features.", prefix)};
}

}  // namespace

Result<AnyFeatures> makeFeatures(const Task& task, const std::string& features, const RepresentationSettings& s,
                                 const std::string& prefix) {
  if (features == "table") return any(Table::create(task), prefix);
  if (features == "radial-basis") return any(RadialBasis::create(task, s.gaussians), prefix);
  expects(features == "tile-coder", "the names of feature maps were checked before");
  if (s.tiles.memory > 0) return any(HashedTileCoder::create(task, s.tiles), prefix);
  return any(TileCoder::create(task, s.tiles), prefix);
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
    return refusedTensor(stored, name + ".weights",
                         fmt::format("is missing, or not a table of {}{} numbers of type F64",
                                     growing ? "at most " : "", fmt::join(shape, " × ")));
  return Done{};
}

}  // namespace surefoot
