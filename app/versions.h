// SPDX-License-Identifier: GPL-3.0-or-later
// The program and everything that it is made of, with versions: `surefoot --version --json`, Help › About.
#pragma once

#include <string>
#include <vector>

namespace surefoot {

struct PartVersion {
  std::string name, version;
};

/// Program, lives, compiler, system, then the libraries: of shared ones what is loaded now.
std::vector<PartVersion> partVersions();

/// The same as one JSON object, with the libraries in one of their own.
std::string versionsAsJson();

/// Those of the window's libraries; none in a build without it.
std::vector<PartVersion> windowVersions();

}  // namespace surefoot
