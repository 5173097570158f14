// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include "app/commands.h"
#include "app/exit_code.h"
#include "physics/register.h"

namespace surefoot {

int fail(const Error& error) {
  std::fprintf(stderr, "surefoot: %s\n", error.message.c_str());
  return exitCode(error.kind);
}

int print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return kDone;
  return fail({"standard output cannot be written; is the disk full?", ErrorKind::File});
}

namespace {

int run(int argc, char** argv) {
  Registry registry;
  registerCore(registry);
  registerPhysics(registry);
  const Result<Request> request = parseCommandLine(registry, argc, argv);
  if (!request) return fail(request.error());

  struct Dispatch {
    const Registry& registry;
    int argc;
    char** argv;
    int operator()(const ListRequest& r) const { return listCommand(registry, r); }
    int operator()(const ProbabilitiesRequest& r) const { return probabilitiesCommand(registry, r); }
    int operator()(const TrainRequest& r) const { return trainCommand(registry, r); }
    int operator()(const WindowRequest& r) const { return windowCommand(registry, r, argc, argv); }
    int operator()(const PrintRequest& r) const { return print(r.text); }
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
  }
}
