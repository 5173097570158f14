// SPDX-License-Identifier: GPL-3.0-or-later
// What a student did in a lesson: JSON lines, appended one by one. The first says whose it is; each other line is one
// thing that was said or done at a step, with the life it was done in, so that it can be lived again. Every line ends
// with a check of itself and all lines before it: a line that was edited, moved or left out is told.
#pragma once

#include "core/lessons/life_record.h"

namespace surefoot {

/// One line.
struct LessonMark {
  enum class Kind {
    Arrived,   ///< came to the step (for the first time, or again)
    Said,      ///< predicted `value`
    Lived,     ///< the lives of the way `text` came to `values`
    Observed,  ///< the run came to `value`
    Answered,  ///< a question: `text` what was answered, `right` whether that is right
    Done,      ///< the task; `right` whether its par was kept, too
    Words,     ///< own words: `text`; `right` whether they agree with the model answer, by the student
    HintTaken,
    Finished  ///< the lesson
  };
  Kind kind = Kind::Arrived;
  std::size_t step = 0;  ///< from 0
  double value = 0.0;
  std::vector<double> values{};
  bool right = false;
  std::string text{}, because{};
  double seconds = 0.0;                                ///< spent in the step so far, by a clock that never jumps
  std::shared_ptr<const LifeRecord> life{}, before{};  ///< at that moment, where it matters
};

struct HandIn {
  std::string lesson, student;
  std::uint64_t lessonHash = 0;  ///< of the lesson's text when it was begun
  std::uint64_t seed = 1;
  int livesVersion = 0;
  std::vector<LessonMark> marks{};
  /// What is wrong with the text: lines (from 1) whose check fails, or that are no marks.
  std::vector<std::size_t> edited{}, damaged{};

  /// The step (from 0) that is not done yet; the number of steps when all are.
  std::size_t reached(const Lesson& of) const;
  bool finished() const;
  const LessonMark* last(LessonMark::Kind kind, std::size_t step) const;
};

/// Text for a file, line by line; each call continues the check.
class HandInWriter {
 public:
  /// Goes on behind lines that were read; 0: a new file.
  explicit HandInWriter(std::uint64_t check = 0) : check_(check) {}
  std::string header(const HandIn& handIn);
  std::string line(const LessonMark& mark);
  std::uint64_t check() const { return check_; }

 private:
  std::string checked(Json json);
  std::uint64_t check_;
};

/// Reads whatever can be read. An error: it is no hand-in at all. `check`: where a writer goes on.
Result<HandIn> parseHandIn(const std::string& text, std::uint64_t* check = nullptr);

}  // namespace surefoot
