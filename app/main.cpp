// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "app/commands/commands.h"
#include "app/completion/completion.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "app/process/resources.h"
#include "app/versions.h"
#include "core/basics/version.h"
#include "core/environment_library.h"
#include "core/environment_programs.h"
#include "core/register/register.h"
#include "core/text/printable.h"
#include "physics/register.h"

namespace surefoot {

int fail(const Error& error) {
  std::string sentence = printable(error.message);
  std::replace_if(
      sentence.begin(), sentence.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  std::fprintf(stderr, "surefoot: %s\n", sentence.c_str());
  return exitCode(error.kind);
}

void tell(const std::string& note) {
  if (!note.empty()) static_cast<void>(fail(Error{note}));  // only prints
}

void tellNote(const Store& store) {
  tell(store.note());
}

int print(const std::string& content) {
  const std::string text = printable(content);
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return kDone;
  if (errno == EPIPE) return kDone;  // the reader has enough, as in `… | head`
  return fail({fmt::format("standard output cannot be written: {}.", std::strerror(errno)), ErrorKind::File});
}

namespace {

/// An empty name is a mistake, for example an unset variable in a script; it must not lead to files in "/".
Status checkNoneIsEmpty(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view text = argv[i], before = argv[i - 1];
    if (text.starts_with("--") && text.ends_with('='))
      return Error{
          fmt::format("{}: it is empty; give a value, or leave the option away.", text.substr(0, text.size() - 1))};
    if (!text.empty()) continue;
    if (i > 1 && before.starts_with("--"))
      return Error{fmt::format("{}: it is empty; give a value, or leave the option away.", before)};
    return Error{fmt::format("argument {} is empty; a name or a value is needed there.", i)};
  }
  return Done{};
}

int run(int argc, char** argv) {
  reportFailedWrites();
  watchForInterrupt();
  Registry registry;
  registerCore(registry);
  registerPhysics(registry);
  registry.files->setShelf(resourceFolder("robots"));
  registry.programs->setModules(resourceFolder("robots/child"));
  registry.programs->stopWaitingWith(&watchForInterrupt());
  registry.programs->setRemark(tell);
  if (argc >= 2 && std::string_view(argv[1]) == "complete")  // asked by a shell: resources/completions
    return print(completionsText(complete(registry, {argv + 2, argv + argc})));
  if (const Status s = checkNoneIsEmpty(argc, argv); !s) return fail(s.error());
  static char option[] = "--help";
  if (argc == 3 && std::string_view(argv[1]) == "help") std::swap(argv[1], argv[2]);  // "help check"
  if (argc >= 2 && std::string_view(argv[argc - 1]) == "help") argv[argc - 1] = option;
  const Result<Request> request = parseCommandLine(registry, argc, argv);
  if (!request) return fail(request.error());
  if (std::holds_alternative<WindowRequest>(*request))  // Qt's file names must be UTF-8
    for (int i = 1; i < argc; ++i)
      if (!isUtf8(argv[i]))
        return fail({fmt::format("argument {}: it is no UTF-8 text, as names of files in the window must be.", i)});

  struct Dispatch {
    const Registry& registry;
    int argc;
    char** argv;
    int operator()(const ListRequest& r) const { return listCommand(registry, r); }
    int operator()(const ProbabilitiesRequest& r) const { return probabilitiesCommand(registry, r); }
    int operator()(const TrainRequest& r) const { return trainCommand(registry, r); }
    int operator()(const WindowRequest& r) const { return windowCommand(registry, r, argc, argv); }
    int operator()(const QueryRequest& r) const { return queryCommand(registry, r); }
    int operator()(const SliceRequest& r) const { return sliceCommand(registry, r); }
    int operator()(const RolloutRequest& r) const { return rolloutCommand(registry, r); }
    int operator()(const RobustnessRequest& r) const { return robustnessCommand(registry, r); }
    int operator()(const InspectRequest& r) const { return inspectCommand(registry, r); }
    int operator()(const ResampleRequest& r) const { return resampleCommand(registry, r); }
    int operator()(const CheckRequest& r) const { return checkCommand(registry, r); }
    int operator()(const NewRobotRequest& r) const { return newRobotCommand(registry, r); }
    int operator()(const ReplayRequest& r) const { return replayCommand(registry, r); }
    int operator()(const DifferenceRequest& r) const { return differenceCommand(registry, r); }
    int operator()(const BenchRequest& r) const { return benchCommand(registry, r); }
    int operator()(const ExperimentRequest& r) const { return experimentCommand(registry, r); }
    int operator()(const ReproduceRequest& r) const { return reproduceCommand(registry, r); }
    int operator()(const ExportRequest& r) const { return exportCommand(registry, r); }
    int operator()(const MergeRequest& r) const { return mergeCommand(r); }
    int operator()(const StatisticsRequest& r) const { return statisticsCommand(registry, r); }
    int operator()(const LessonsRequest& r) const { return lessonsCommand(registry, r); }
    int operator()(const HandbookRequest& r) const { return handbookCommand(registry, r); }
    int operator()(const PrintRequest& r) const { return print(r.text); }
    int operator()(const VersionRequest& r) const {
      return print(r.json ? versionsAsJson() : fmt::format("surefoot {}\n", kVersion));
    }
    int operator()(const ManualRequest& r) const { return manualCommand(registry, r); }
  };
  return std::visit(Dispatch{registry, argc, argv}, *request);
}

}  // namespace
}  // namespace surefoot

int main(int argc, char** argv) {
  try {
    return surefoot::run(argc, argv);
  } catch (const std::bad_alloc&) {
    return surefoot::fail({"there is not enough memory for this; take fewer tiles, tilings or lives."});
  } catch (const std::exception& error) {
    return surefoot::fail({std::string("something went wrong that should not: ") + error.what() + "."});
  }
}
