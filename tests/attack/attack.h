// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program on files made to harm: within ten seconds and 4 GB of addresses.
#pragma once

#include "tests/app/program.h"

namespace surefoot {

inline std::string times(int n, const std::string& text) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

inline std::string written(const std::string& path, const std::string& content) {
  std::ofstream(path) << content;
  return path;
}

inline Finished surefootInBounds(const std::string& arguments, int kilobytes = 4'000'000) {
  const Folder folder;
  const std::string out = folder.file("out"), err = folder.file("err");
  const std::string command = "(ulimit -v " + std::to_string(kilobytes) + "; timeout -s KILL 10 " SUREFOOT_PROGRAM " " +
                              arguments + ") >" + out + " 2>" + err + " </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contentOf(out), contentOf(err)};
}

/// One sentence, the code and the words.
inline void expectRefusalInBounds(const std::string& arguments, int code, const std::vector<std::string>& words,
                                  int kilobytes = 4'000'000) {
  const Finished run = surefootInBounds(arguments, kilobytes);
  EXPECT_EQ(run.code, code) << arguments << "\n" << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << arguments << "\n" << run.err;
  for (const std::string& word : words)
    EXPECT_NE(run.err.find(word), std::string::npos) << arguments << "\n" << run.err;
}

}  // namespace surefoot
