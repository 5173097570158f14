// SPDX-License-Identifier: GPL-3.0-or-later
// From arguments to a checked request. Every value is read as text and converted by the parsers of core/parameters.h.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/experiment/configuration.h"
#include "core/laboratory/laboratory.h"
#include "core/robustness/robustness_plan.h"
#include "core/saved/checkpoint.h"

namespace surefoot {

/// `surefoot list`
struct ListRequest {
  bool json = false;
  std::string robot{};  ///< only of this robot: a file, or a name
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
  std::string note{};  ///< what a person should know of the files that were read

  // `train` only: files.
  std::optional<std::string> save, journal, checkpoint;
  std::int64_t checkpointEvery = 0;           ///< steps
  std::shared_ptr<const TensorFile> resumed;  ///< the life goes on from here
  NewLimits limits;                           ///< for a life that goes on
  Versions versions = Versions::Same;         ///< for a life that goes on
  bool mayRewind = false;                     ///< Life::mayRewind
  std::optional<std::int64_t> mostSteps;      ///< limit of a life that is lived anew, if it has no other
};
struct WindowRequest : TrainRequest {
  std::optional<std::string> file{};             ///< opens this file, an absolute path
  bool reuseWindow = false;                      ///< in the window that is there already, if there is one
  std::optional<int> page{};                     ///< begins on this page, from 0
  std::optional<std::string> language{};         ///< of the window, instead of that in Preferences
  std::optional<std::string> follow{};           ///< looks at this file while another process writes it
  std::optional<std::string> lesson{}, kiosk{};  ///< begins with a lesson, or shows nothing else
  std::string student{}, classFolder{};          ///< answers are appended to a file of the student in a shared folder
  int resetAfter = 90;                           ///< [s] without a touch, after which a kiosk begins again
};

/// `surefoot query`: the learned values of one state.
struct QueryRequest {
  std::string file;
  std::optional<std::string> state, policy;
  std::vector<std::string> assignments;
  bool json = false;
};

/// `surefoot rollout`: what a Q-function does, step by step.
struct RolloutRequest {
  std::string file;
  std::optional<std::string> seconds, episodes, seed, state, scenario;
  std::string policy = "greedy";
  std::vector<std::string> assignments, pushes;
  std::optional<std::string> csv, npz;
  std::optional<std::string> film, size, appearance, strips;
  bool json = false;
};

/// `surefoot robustness`: falls of what one or two Q-functions have learned, over pushes and models.
struct RobustnessRequest {
  std::string file, second;
  RobustnessQuestion question;
  std::optional<std::string> jobs, csv;
  bool json = false;
};

/// `surefoot slice`: a plane through a Q-function.
struct SliceRequest {
  std::string file;
  std::optional<std::string> axes, at, points, out;
};

/// `surefoot inspect`: the contents of a file.
struct InspectRequest {
  std::string file;
  bool json = false;
};

/// `surefoot resample`: a Q-function in another resolution.
struct ResampleRequest {
  std::string file;
  std::vector<std::string> assignments;
  std::optional<std::string> save;
  bool json = false;
};

/// `surefoot replay`
struct ReplayRequest {
  std::string file;
  bool verify = false, json = false;
};

/// `surefoot difference`: the first place where two records of lives part.
struct DifferenceRequest {
  std::string first, second;
  bool json = false;
};

/// `surefoot bench`
struct BenchRequest {
  bool json = false;
};

/// `surefoot experiment`: a plan into a store.
struct ExperimentRequest {
  Plan plan{};
  std::string out;
  LabOptions lab{};
  bool resume = false, dryRun = false, json = false;
  bool otherVersion = false;  ///< go on with a store whose lives another version lived
};

/// `surefoot reproduce`: recipes of the thesis.
struct ReproduceRequest {
  std::vector<std::string> recipes;  ///< files
  std::string out;
  PlanChanges changes{};
  LabOptions lab{};
  std::vector<std::uint64_t> seeds{};  ///< master seeds; empty: the recipes' own
  bool dryRun = false;
  bool otherVersion = false;  ///< go on with stores whose lives another version lived
};

/// `surefoot export`
struct ExportRequest {
  std::string file;                ///< a store, or a Q-function
  std::optional<std::string> csv;  ///< of a store
  bool forSpreadsheets = false;
  std::optional<std::string> c;  ///< of a Q-function
  bool floats = false, selfTest = false;
};

/// `surefoot merge`
struct MergeRequest {
  std::vector<std::string> parts;
  std::optional<std::string> out;
  bool otherVersion = false;  ///< join lives of several versions
};

/// `surefoot statistics`
struct StatisticsRequest {
  std::string store;
  bool json = false, csv = false, latex = false;
};

/// `surefoot lessons`: nothing (the list), or a word and what it is about.
struct LessonsRequest {
  std::vector<std::string> words;
  bool show = false, solutions = false;
  std::optional<std::string> out;
};

/// `surefoot check`
struct CheckRequest {
  std::string file;
  bool json = false;
};

/// `surefoot new`
struct NewRobotRequest {
  std::string name, like = "segway";
};

/// `surefoot handbook`: its pages as HTML, into a new folder.
struct HandbookRequest {
  std::string folder;
  std::string language = "en";
};

/// --help: the text to print.
struct PrintRequest {
  std::string text;
};

/// --version, of the program alone or as JSON with all libraries.
struct VersionRequest {
  bool json = false;
};

/// `surefoot manual`: writes the manual pages; for packages, so `--help` does not name it.
struct ManualRequest {
  std::string folder, date;
};

using Request = std::variant<ListRequest, ProbabilitiesRequest, TrainRequest, WindowRequest, QueryRequest, SliceRequest,
                             RolloutRequest, RobustnessRequest, InspectRequest, ResampleRequest, ReplayRequest,
                             DifferenceRequest, BenchRequest, ExperimentRequest, ReproduceRequest, ExportRequest,
                             MergeRequest, StatisticsRequest, LessonsRequest, CheckRequest, NewRobotRequest,
                             HandbookRequest, PrintRequest, VersionRequest, ManualRequest>;

Result<Request> parseCommandLine(const Registry& registry, int argc, char** argv);

}  // namespace surefoot
