// SPDX-License-Identifier: GPL-3.0-or-later
// One function a command, one file each. They return the program's exit code.
#pragma once

#include "app/requests/command_line.h"

namespace surefoot {

int listCommand(const Registry& registry, const ListRequest& request);
int probabilitiesCommand(const Registry& registry, const ProbabilitiesRequest& request);
int trainCommand(const Registry& registry, const TrainRequest& request);
int windowCommand(const Registry& registry, const WindowRequest& request, int argc, char** argv);

int queryCommand(const Registry& registry, const QueryRequest& request);
int sliceCommand(const Registry& registry, const SliceRequest& request);
int inspectCommand(const Registry& registry, const InspectRequest& request);
int resampleCommand(const Registry& registry, const ResampleRequest& request);
int benchCommand(const Registry& registry, const BenchRequest& request);
int experimentCommand(const Registry& registry, const ExperimentRequest& request);
int reproduceCommand(const Registry& registry, const ReproduceRequest& request);
int exportCommand(const Registry& registry, const ExportRequest& request);
int rolloutCommand(const Registry& registry, const RolloutRequest& request);
int robustnessCommand(const Registry& registry, const RobustnessRequest& request);
int exportPolicy(const Registry& registry, const ExportRequest& request);
int mergeCommand(const MergeRequest& request);
int statisticsCommand(const Registry& registry, const StatisticsRequest& request);
int lessonsCommand(const Registry& registry, const LessonsRequest& request);
int checkCommand(const Registry& registry, const CheckRequest& request);
int newRobotCommand(const Registry& registry, const NewRobotRequest& request);
int replayCommand(const Registry& registry, const ReplayRequest& request);
int differenceCommand(const Registry& registry, const DifferenceRequest& request);
int manualCommand(const Registry& registry, const ManualRequest& request);
int handbookCommand(const Registry& registry, const HandbookRequest& request);

/// Prints "surefoot: …" to standard error and returns the exit code of the error.
int fail(const Error& error);

/// Prints a note to standard error; the program goes on. An empty one is none.
void tell(const std::string& note);

/// Prints the note of a store, if it has one, to standard error.
void tellNote(const Store& store);

/// Writes text to standard output; an unwritable one (a full disk) is an error of its own.
int print(const std::string& text);

}  // namespace surefoot
