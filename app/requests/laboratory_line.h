// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the laboratory on the command line.
#pragma once

#include <CLI/CLI.hpp>

#include "app/requests/command_line.h"

namespace surefoot {

/// An option whose text is kept as it is.
void addOption(CLI::App& app, const std::string& name, std::optional<std::string>& value, const std::string& help,
               const std::string& type);
/// --set KEY=VALUE, as often as wanted.
void addAssignments(CLI::App& app, std::vector<std::string>& assignments, const std::string& help);

/// The options of `experiment`, as they were written.
struct ExperimentOptions {
  std::string plan;
  std::string out = "results.sqlite";
  std::optional<std::string> lives, seed, jobs, shard;
  std::vector<std::string> assignments;
  bool resume = false, dryRun = false, json = false, otherVersion = false;
};

/// The options of `reproduce`, as they were written.
struct ReproduceOptions {
  std::vector<std::string> list, seeds;
  std::string out = "reproduction", lives = "thesis";
  std::optional<std::string> jobs, preset;
  bool otherVersion = false, dryRun = false;
};

class LaboratoryLine {
 public:
  explicit LaboratoryLine(CLI::App& app);

  std::vector<CLI::App*> commands() const { return {experiment_, reproduce_, export_, merge_, statistics_}; }
  std::vector<CLI::App*> livingCommands() const { return {experiment_, reproduce_}; }
  /// The request of the command that was given, if it is one of these.
  std::optional<Result<Request>> request(const Registry& registry) const;

 private:
  CLI::App *experiment_, *reproduce_, *export_, *merge_, *statistics_;
  ExperimentOptions experimentOptions_;
  ReproduceOptions reproduceOptions_;
  ExportRequest exportOptions_;
  MergeRequest mergeOptions_;
  StatisticsRequest statisticsOptions_;
};

}  // namespace surefoot
