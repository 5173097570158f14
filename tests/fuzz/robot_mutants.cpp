// SPDX-License-Identifier: GPL-3.0-or-later
// Robots whose numbers were changed at random: robot_mutants COUNT SEED FILE… . Tells how many lived, and those that
// took longer than two seconds.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "tests/fuzz/use_robot.h"

namespace {

std::string changed(const std::string& text, surefoot::Random& random) {
  static const std::regex kNumber("[0-9]+(\\.[0-9]+)?(e-?[0-9]+)?");
  std::vector<std::pair<std::size_t, std::size_t>> numbers;
  for (std::sregex_iterator it(text.begin(), text.end(), kNumber), end; it != end; ++it)
    numbers.emplace_back(it->position(), it->length());
  std::string mutant = text;
  const int changes = 1 + static_cast<int>(random.uniform() * 3);
  for (int i = 0; i < changes; ++i) {
    const auto [at, length] = numbers[static_cast<std::size_t>(random.uniform() * static_cast<double>(numbers.size()))];
    if (mutant.size() != text.size()) break;  // one change of another length, or several of the same
    const double now = std::strtod(text.c_str() + at, nullptr);
    static constexpr const char* kExtreme[] = {"0",    "-1",  "1e300", "1e-300", "1e6",
                                               "1e-6", "nan", "inf",   "-0.0",   "1e9"};
    std::string to = kExtreme[static_cast<std::size_t>(random.uniform() * 10)];
    if (random.uniform() < 0.6) to = std::to_string(now * std::pow(10.0, random.uniform(-3, 3)));
    mutant.replace(at, length, to);
  }
  return mutant;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return std::fprintf(stderr, "robot_mutants COUNT SEED FILE…\n"), 2;
  std::vector<std::string> texts;
  for (int i = 3; i < argc; ++i) {
    std::ifstream in(argv[i], std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  surefoot::Random random(std::strtoull(argv[2], nullptr, 10));
  const long count = std::strtol(argv[1], nullptr, 10);
  long lived = 0, slow = 0;
  double longest = 0.0;
  for (long i = 0; i < count; ++i) {
    const std::string mutant = changed(texts[static_cast<std::size_t>(i) % texts.size()], random);
    std::ofstream("robot_mutants.last", std::ios::binary) << mutant;  // what a crash was about
    const auto begun = std::chrono::steady_clock::now();
    lived += surefoot::useRobot(mutant);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    longest = std::max(longest, seconds);
    if (seconds < 2.0) continue;
    ++slow;
    std::ofstream("robot_mutants.slow" + std::to_string(slow), std::ios::binary) << mutant;
  }
  std::printf("%ld mutants, %ld lived, %ld took over 2 s, the longest %.2f s\n", count, lived, slow, longest);
  return slow == 0 ? 0 : 1;
}
