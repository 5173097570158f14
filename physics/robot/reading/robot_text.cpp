// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/reading/robot_text.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace surefoot {

std::string wrongRobotName(std::string_view name) {
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  if (!name.empty() && name.size() <= 40 && std::all_of(name.begin(), name.end(), fits)) return {};
  std::string near;
  for (const char c : name.substr(0, 40)) {
    const char small = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (fits(small))
      near += small;
    else if (!near.empty() && near.back() != '-')
      near += '-';
  }
  while (near.ends_with('-')) near.pop_back();
  return "a robot's name has letters a to z, digits and hyphens only, at most 40" +
         (near.empty() ? "" : " (did you mean " + near + "?)") + ".";
}

std::string renamedRobot(std::string_view text, std::string_view name) {
  std::string title(name);
  std::replace(title.begin(), title.end(), '-', ' ');
  if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  std::string renamed;
  bool head = true;  // the lines before the first table
  while (!text.empty()) {
    const auto end = text.find('\n');
    const std::string_view line = text.substr(0, end == std::string_view::npos ? end : end + 1);
    text.remove_prefix(line.size());
    head = head && !line.starts_with('[');
    if (head && line.starts_with("name = "))
      renamed += "name = \"" + std::string(name) + "\"\n";
    else if (head && line.starts_with("title = "))
      renamed += "title = \"" + title + "\"\n";
    else
      renamed += line;
  }
  return renamed;
}

}  // namespace surefoot
