// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program as a user would.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/folder.h"

namespace surefoot {

struct Finished {
  int code = -1;
  std::string out, err;
};

inline std::string contentOf(const std::string& file) {
  const std::ifstream in(file);
  std::ostringstream text;  // in blocks: tests are compiled without optimisation
  text << in.rdbuf();
  return text.str();
}

/// A command of the shell.
inline Finished finish(const std::string& command) {
  const Folder folder;
  const std::string out = folder.file("out"), err = folder.file("err");
  const int status = std::system((command + " >" + out + " 2>" + err + " </dev/null").c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contentOf(out), contentOf(err)};
}

/// `arguments` as one would type them behind the program's name.
inline Finished surefoot(const std::string& arguments) {
  return finish(std::string("env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM ") + SUREFOOT_PROGRAM + " " +
                arguments);
}

/// The JSON that a command prints, which must succeed.
inline nlohmann::json run(const std::string& arguments) {
  const Finished finished = surefoot(arguments + " --json");
  EXPECT_EQ(finished.code, 0) << arguments << "\n" << finished.err;
  return finished.code == 0 ? nlohmann::json::parse(finished.out) : nlohmann::json::object();
}

/// The hash of the one life of `train`.
inline std::string hashOf(const std::string& arguments) {
  return run("train " + arguments)["lives"][0]["hash"];
}

/// One sentence on standard error, nothing on standard output, the expected code, and the words in it.
inline void expectRefusal(const std::string& arguments, int code, const std::vector<std::string>& words = {}) {
  const Finished run = surefoot(arguments);
  EXPECT_EQ(run.code, code) << arguments << "\n" << run.err;
  EXPECT_EQ(run.out, "") << arguments;
  EXPECT_TRUE(run.err.starts_with("surefoot: ")) << arguments << "\n" << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << arguments << "\n" << run.err;
  for (const std::string& word : words)
    EXPECT_NE(run.err.find(word), std::string::npos) << arguments << "\n" << run.err;
}

}  // namespace surefoot
