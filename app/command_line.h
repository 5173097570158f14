// SPDX-License-Identifier: GPL-3.0-or-later
// From arguments to a checked request. Every value is read as text and converted by the parsers of core/parameters.h.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/experiment/configuration.h"

namespace surefoot {

/// `surefoot list`
struct ListRequest {
  bool json = false;
};

/// `surefoot probabilities`
struct ProbabilitiesRequest {
  std::vector<double> q;
  std::string policy;
  std::vector<Assignment> assignments;
  bool json = false;
};

/// `surefoot train`, and `surefoot window` with the same options.
struct TrainRequest {
  Configuration configuration;
  int jobs = 1;
  bool json = false;
  std::optional<std::string> log;
  bool turbo = false;  ///< window only: start flat out
};
struct WindowRequest : TrainRequest {};

/// --help or --version: the text to print.
struct PrintRequest {
  std::string text;
};

using Request = std::variant<ListRequest, ProbabilitiesRequest, TrainRequest, WindowRequest, PrintRequest>;

Result<Request> parseCommandLine(const Registry& registry, int argc, char** argv);

}  // namespace surefoot
