// SPDX-License-Identifier: GPL-3.0-or-later
// How names of conditions are shown: with a true minus, and in groups. "pre(2): TRL -50" belongs to the group "pre(2)".
// In this group its name is "TRL −50": it is the bar "−50" of the family "TRL".
#pragma once

#include <QString>
#include <string>
#include <vector>

namespace surefoot {

/// The name with a true minus before its numbers.
QString shownName(const std::string& name);
/// The part of the name before ": "; empty: the name has no group.
std::string groupOf(const std::string& name);
/// "pre-learned on scenario 2"
QString groupTitle(const std::string& group);
/// The part of the name after ": ".
QString nameInGroup(const std::string& name);

/// How conditions are put together in a figure.
struct NameGroups {
  struct Run {
    QString title;
    std::size_t first = 0, last = 0;  ///< places in `order`
  };
  std::vector<std::size_t> order;  ///< indices of the names; names of one group are neighbours
  std::vector<QString> labels;     ///< one label per place
  std::vector<Run> families;       ///< neighbours that differ by a number only
  std::vector<Run> groups;         ///< the groups that have a title
};
NameGroups groupNames(const std::vector<std::string>& names);

}  // namespace surefoot
