// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson: steps that ask, each with what the window shows and what must be done. Read from a file by readLesson().
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
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

/// A condition or a number with its text, for messages.
struct LessonCondition {
  std::string text;
  Expression expression;
  std::vector<int> reads{};  ///< the places of the quantities that it names
};

/// Markdown with numbers that are computed when it is shown: "It fell {observed(2)} times."
struct LessonText {
  std::vector<std::string> between{};      ///< one more than numbers
  std::vector<LessonCondition> numbers{};  ///< the numbers between them
  bool empty() const { return between.empty(); }
};

/// What a person's hand does to a life.
struct LessonAction {
  enum class Kind {
    Set,
    Policy,
    Agent,     ///< another learning rule: a new life begins with it
    Scenario,  ///< the task deviates from the actual system from the next episode on
    Seed,      ///< a new life begins with other random numbers
    Restart,   ///< the life begins again
    Transfer,  ///< a new life begins with what this one has learned
    Run,
    Place,  ///< a new episode begins in a state
    Push    ///< by an impulse [N s]
  };
  Kind kind = Kind::Restart;
  std::string key{}, value{};   ///< of Set; the value also of Policy, Agent, Scenario
  LessonAmount amount{};        ///< of Run
  std::uint64_t seed = 0;       ///< of Seed
  std::vector<double> state{};  ///< of Place; the impulse of Push
};
using LessonActions = std::vector<LessonAction>;

/// A number is said before it is seen.
struct LessonPrediction {
  std::string question, unit;
  double low = 0.0, high = 1.0;
  LessonCondition of;  ///< a number
  LessonAmount after;
  LessonActions then{};  ///< done once it is said, before the run
  bool turbo = true;
};

/// The run that is shown when a step begins. Without an end it goes on while one looks.
struct LessonRun {
  std::optional<LessonCondition> until{};
  std::optional<LessonAmount> amount{};
  bool turbo = false;
  bool ends() const { return until || amount; }
};

/// Several lives of each of a few ways, with the same seeds for all.
struct LessonLives {
  struct Way {
    std::string label;       ///< its name in expressions: least("ε stays 0.25")
    std::string title = {};  ///< the label in the language of the reader
    LessonActions first{};   ///< from the lesson's start
    std::size_t place = 0;   ///< counted over all steps
  };
  int count = 10;
  std::string title{};
  LessonCondition of;
  LessonAmount after;
  std::vector<Way> ways{};
};

struct NumberQuestion {
  std::string question;
  LessonCondition answer;
  double tolerance = 0.0;
  std::string unit{};
};
struct ChoiceQuestion {
  std::string question;
  std::vector<std::string> options, remarks;  ///< a remark for a wrong option, or none
  std::size_t answer = 0;                     ///< from 0
  std::string why{};                          ///< said with the right answer
  bool because = false, mistake = false;
};
struct OrderQuestion {
  std::string question;
  std::vector<std::string> options;
  std::vector<std::size_t> answer;  ///< the options in the right order, from 0
};
struct PointQuestion {
  enum class On { Map, Fall, ActionRow };
  std::string question;
  On on = On::Map;
  LessonCondition accept;
  std::vector<double> right{}, wrong{};  ///< a place (or a number) that is accepted, and one that is not: for tests
};
/// Kept, and shown beside a model answer; never marked by the program.
struct WordsQuestion {
  std::string question, model;
};
/// Which of the two ways of the step's lives has the smaller mean, or can one not tell?
struct CompareQuestion {
  std::string question;
};
using LessonQuestion =
    std::variant<NumberQuestion, ChoiceQuestion, OrderQuestion, PointQuestion, WordsQuestion, CompareQuestion>;

struct LessonStep {
  TextPlace at{};
  std::string title{}, hint{};
  LessonText say{};
  std::vector<std::string> show{};  ///< panels and knobs; empty: those of the step before
  LessonActions begin{};
  std::optional<LessonPrediction> predict{};
  std::optional<LessonRun> run{};
  std::optional<LessonLives> lives{};
  std::optional<LessonQuestion> ask{};
  std::optional<LessonCondition> observe{};  ///< kept when the step's run ends, or when the step is left
  std::optional<LessonCondition> done{}, par{};
  std::string task{};                     ///< the task in one sentence
  std::optional<LessonAmount> attempt{};  ///< how much of a life is one attempt at the task
  std::vector<LessonCondition> expect{};  ///< what the text says: it holds at the end of the step
  LessonActions solution{}, wrong{};
  double minutes = 0.0;  ///< for the teacher
};

/// What a kiosk shows of a lesson: the same robot twice, that explores equally often in two ways.
struct LessonKiosk {
  std::string question, note, explain;
  std::string word;             ///< with Ctrl+Shift+K and this word one leaves it
  double share = 0.1;           ///< of exploring steps, at first
  std::int64_t episodes = 300;  ///< then the sentence becomes a result
};

/// "predict", "watch", "choose, because", "task" …: what a step asks of a person, in a word or two.
std::string kindOf(const LessonStep& step);
/// The question of a step, in the student's words; empty: there is none.
std::string questionOf(const LessonStep& step);

struct Lesson {
  std::string name;    ///< of its file, without number and ending
  std::string number;  ///< in front of its file's name, without zeros: "5"; empty: none
  std::string title{}, goal{}, line{}, about{}, chapter{}, language = "en";
  double minutes = 10.0;
  int level = 1;
  std::vector<std::string> needs{};
  Configuration start{};
  std::map<std::string, std::pair<double, double>> ranges{};  ///< of sliders, by the keys of their parameters
  bool seedOfStudent = false;                                 ///< the seed comes from the student's name
  std::vector<LessonStep> steps{};
  std::optional<LessonKiosk> kiosk{};
  std::vector<LessonQuantity> quantities{};  ///< the places of all conditions' values
  std::size_t ways = 0;                      ///< of all steps' lives
  std::string notes{};                       ///< for the teacher
  std::vector<std::string> discuss{};
  std::uint64_t hash = 0;  ///< of the file's text
};

/// The seed of a student's lives: of a lesson whose seed is the student's it is a hash of the name, 1 to 999,999.
std::uint64_t seedOf(const Lesson& lesson, const std::string& student);

}  // namespace surefoot
