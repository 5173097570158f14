// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson: steps that ask, each with what the window shows and what must be done. Read from a file by readLesson().
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/experiment/configuration.h"
#include "core/expression/expression.h"
#include "core/files/toml_tree.h"
#include "core/lessons/lesson_words.h"

namespace surefoot {

/// How long a life goes on: "200 episodes", "20 minutes" (simulated), "5000 steps".
struct LessonAmount {
  enum class Unit { Episodes, Minutes, Steps };
  double value = 0.0;
  Unit unit = Unit::Episodes;
};

/// A condition with its text, for messages.
struct LessonCondition {
  std::string text;
  Expression expression;
  std::vector<int> reads{};  ///< the places of the quantities that it names
};

/// What a person's hand does to a life.
struct LessonAction {
  enum class Kind { Set, Policy, Restart, Run };
  Kind kind = Kind::Restart;
  std::string key{}, value{};  ///< of Set, Policy
  LessonAmount amount{};       ///< of Run
};

/// A number is said before it is seen.
struct LessonPrediction {
  std::string unit;
  double low = 0.0, high = 1.0;
  LessonCondition of;  ///< a number
  LessonAmount after;
};

/// The run that is shown when a step begins.
struct LessonRun {
  std::optional<LessonCondition> until;
  bool turbo = false;
};

struct NumberQuestion {
  LessonCondition answer;
  double tolerance = 0.0;
  std::string unit{};
};
struct ChoiceQuestion {
  std::vector<std::string> options, remarks;  ///< a remark for a wrong option, or none
  std::size_t answer = 0;                     ///< from 0
  bool because = false;
};
struct OrderQuestion {
  std::vector<std::string> options;
  std::vector<std::size_t> answer;  ///< the options in the right order, from 0
};
struct PointQuestion {
  enum class On { Map, Fall, ActionRow };
  On on = On::Map;
  LessonCondition accept;
};
/// Kept, and shown beside a model answer; never marked by the program.
struct WordsQuestion {
  std::string model;
};
/// Which of two lives is better, or can one not tell?
struct CompareQuestion {
  std::vector<std::string> options;
  std::string plan;  ///< the file whose lives answer it
};
using LessonQuestion =
    std::variant<NumberQuestion, ChoiceQuestion, OrderQuestion, PointQuestion, WordsQuestion, CompareQuestion>;

struct LessonStep {
  TextPlace at{};
  std::string say{}, hint{};
  std::vector<std::string> show{};  ///< panels and knobs; empty: those of the step before
  std::vector<LessonAction> begin{};
  std::optional<LessonPrediction> predict{};
  std::optional<LessonRun> run{};
  std::optional<LessonQuestion> ask{};
  std::optional<LessonCondition> done{}, par{};
  std::vector<LessonAction> solution{};
  double minutes = 0.0;  ///< for the teacher
};

struct Lesson {
  std::string name;  ///< of its file, without number and ending
  std::string title{}, goal{}, line{}, chapter{}, language = "en";
  double minutes = 10.0;
  int level = 1;
  std::vector<std::string> needs{};
  Configuration start{};
  bool seedOfStudent = false;  ///< the seed comes from the student's name
  std::vector<LessonStep> steps{};
  std::vector<LessonQuantity> quantities{};  ///< the places of all conditions' values
  std::string notes{};                       ///< for the teacher
  std::vector<std::string> discuss{};
};

}  // namespace surefoot
