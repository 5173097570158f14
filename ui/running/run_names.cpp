// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/running/run_names.h"
#include "ui/language/from_core.h"

#include <vector>

namespace surefoot {

namespace {

template <class Entry>
std::string titleOf(const std::vector<Entry>& entries, const std::string& name) {
  for (const Entry& entry : entries)
    if (entry.name == name) return fromCore(entry.title).toStdString();
  return name;
}

/// The policies under which at least one episode ended; a policy that was left again before that does not count.
std::vector<std::string> policiesLived(const RunCurve& curve) {
  std::vector<std::string> lived;
  for (const CurvePiece& piece : curve.pieces) {
    if (piece.points.empty()) continue;
    const bool any = lived.empty() || piece.points.back().episode > piece.points.front().episode;
    if (any && (lived.empty() || lived.back() != piece.policy)) lived.push_back(piece.policy);
  }
  if (lived.empty() && !curve.pieces.empty()) lived.push_back(curve.pieces.back().policy);
  return lived;
}

}  // namespace

std::string policiesOf(const RunCurve& curve, const Registry& registry) {
  constexpr std::size_t kMost = 3;
  const std::vector<std::string> lived = policiesLived(curve);
  std::string text;
  for (std::size_t i = 0; i < lived.size(); ++i) {
    const bool leftOut = lived.size() > kMost && i > 0 && i + 1 < lived.size();
    if (leftOut && i > 1) continue;
    if (i > 0) text += " → ";
    text += leftOut ? "…" : titleOf(registry.policies, lived[i]);
  }
  return text;
}

std::string nameOf(const RunCurve& curve, const Registry& registry) {
  std::string text = policiesOf(curve, registry);
  for (const std::string& more : {titleOf(registry.agents, curve.agent), curve.began})
    if (!more.empty()) text += (text.empty() ? "" : ", ") + more;
  return text;
}

}  // namespace surefoot
