// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/examples.h"

#include <fmt/format.h>

namespace surefoot {

namespace {

struct Shown {
  std::string_view command, rest, does;
};

constexpr Shown kExamples[] = {
    {"train", "--minutes 9", "one life of nine simulated minutes on the pendulum"},
    {"train", "--minutes 9 --lives 200 --policy softmax --set policy.temperature=0.5 --json",
     "two hundred lives on all cores, with their intervals, as JSON"},
    {"train", "--minutes 60 --save learned.safetensors --journal life.jsonl", "keep what was learned, and how"},
    {"window", "", "the pendulum, already learning"},
    {"window", "--environment leo --turbo", "the walking robot LEO, flat out"},
    {"window", "session.surefoot", "go on with a session"},
    {"window", "--follow results.sqlite", "look at an experiment while another process runs it"},
    {"list", "", "everything that can be chosen or set, with formulas"},
    {"list", "segway --json", "what can be set of one robot, for a program"},
    {"query", "learned.safetensors --state '0.05;0'", "the values of every action where the pole leans by 0.05 rad"},
    {"slice", "learned.safetensors --axes pole_angle,pole_rate --out plane.csv",
     "the plane through the state of zeros"},
    {"inspect", "learned.safetensors", "how it was learned, and what it holds"},
    {"resample", "learned.safetensors --set features.tilings=8 --save coarse.safetensors",
     "the same function in half as many tilings"},
    {"replay", "life.jsonl --verify", "live it again, and fail unless it is the same life bit for bit"},
    {"difference", "first.jsonl second.jsonl", "where two lives part, and in what"},
    {"bench", "--json", "steps a second of every environment"},
    {"probabilities", "--q '1;2;3' --policy softmax --set policy.temperature=1",
     "how likely each of three actions is under Softmax"},
    {"handbook", "pages", "pages/index.html, and all others"},
    {"lessons", "", "the lessons, in order"},
    {"lessons", "check my-lesson.toml --show", "read a lesson, live through it, print what a student reads"},
    {"check", "hopper", "what a robot's file describes, after letting it move at random"},
    {"new", "roller --like segway", "begin roller.toml"},
    {"rollout", "learned.safetensors --seconds 25 --csv signals.csv", "every signal of 25 s without learning"},
    {"rollout", "learned.safetensors --film fall.webp --push 3:0.1", "a film in which it is pushed after 3 s"},
    {"robustness", "learned.safetensors --push 0..0.2:9 --scenario all", "falls over pushes and models"},
    {"experiment", "quick --dry-run", "what a plan would do, and how long it would take"},
    {"experiment", "plan.toml --out results.sqlite --resume", "run a plan, or go on with it"},
    {"reproduce", "4.6 --lives 40", "a figure of the thesis with forty lives a condition"},
    {"export", "results.sqlite --csv tables", "conditions, lives and episodes as CSV"},
    {"export", "learned.safetensors --c policy.c", "the greedy policy as C99"},
    {"merge", "part-1.sqlite part-2.sqlite --out results.sqlite", "join two shards"},
    {"statistics", "results.sqlite", "means, intervals and tests of every condition"},
};

}  // namespace

std::vector<Example> examplesOf(std::string_view command) {
  std::vector<Example> examples;
  for (const Shown& e : kExamples)
    if (e.command == command)
      examples.push_back(
          {fmt::format("surefoot {}{}{}", command, e.rest.empty() ? "" : " ", e.rest), std::string(e.does)});
  return examples;
}

std::string examplesText(std::string_view command) {
  std::string text;
  for (const Example& e : examplesOf(command)) text += fmt::format("  {}\n      {}\n", e.line, e.does);
  return text.empty() ? "" : "Examples:\n" + text;
}

}  // namespace surefoot
