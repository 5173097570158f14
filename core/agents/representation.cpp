// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/representation.h"

#include <fmt/format.h>

#include "core/text.h"

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

/// "pole_angle", where that is what an entry of a list is about; else its number.
std::string nameOfEntry(const Json& entry, std::size_t number) {
  if (entry.is_object() && entry.contains("variable") && entry["variable"].is_string())
    return entry["variable"].get<std::string>();
  return fmt::format("entry {}", number + 1);
}

struct Difference {
  std::string where;
  std::string theirs, ours;
};

std::string shortText(const Json& json) {
  return std::string(shortened(json.dump(-1, ' ', true)));
}

/// The first place where two descriptions differ.
std::optional<Difference> firstDifference(const Json& theirs, const Json& ours, const std::string& where) {
  const auto inside = [&](const std::string& name) { return where.empty() ? name : name + " of " + where; };
  if (ours.is_object() && theirs.is_object()) {
    std::vector<std::string> keys;  // first what a person sets
    for (const char* key : {"kind", "tilings", "memory", "tile_width", "spacing", "width"})
      if (ours.contains(key)) keys.emplace_back(key);
    for (const auto& [key, value] : ours.items()) keys.push_back(key);
    for (const std::string& key : keys) {
      const Json& value = ours[key];
      if (!theirs.contains(key)) return Difference{inside(key), "nothing", shortText(value)};
      if (auto found = firstDifference(theirs[key], value, key == "variables" ? where : inside(key))) return found;
    }
    return std::nullopt;
  }
  if (ours.is_array() && theirs.is_array() && ours.size() == theirs.size()) {
    for (std::size_t i = 0; i < ours.size(); ++i)
      if (auto found = firstDifference(theirs[i], ours[i], nameOfEntry(ours[i], i))) return found;
    return std::nullopt;
  }
  if (theirs == ours) return std::nullopt;
  return Difference{where, shortText(theirs), shortText(ours)};
}

}  // namespace

Result<AnyFeatures> makeFeatures(const Task& task, const std::string& features, const RepresentationSettings& s) {
  if (features == "table") return any(Table::create(task));
  if (features == "radial-basis") return any(RadialBasis::create(task, s.gaussians));
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
