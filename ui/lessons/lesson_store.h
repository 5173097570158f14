// SPDX-License-Identifier: GPL-3.0-or-later
// What was done in the lessons, kept in a folder: a file for each lesson (hand_in.h). The window's thread.
#pragma once

#include <QString>
#include <map>

#include "core/lessons/hand_in.h"

namespace surefoot {

class LessonStore {
 public:
  /// The folder is made when something is kept there first. `student`: whose it is; empty: nobody's in particular.
  LessonStore(QString folder, QString student);

  /// What was done before, or an empty one.
  HandIn handIn(const Lesson& lesson);
  /// One more line. An error: the file cannot be written; the line is still known here.
  Status add(const Lesson& lesson, const LessonMark& mark);
  /// Forgets a lesson, and its file.
  Status forget(const Lesson& lesson);
  const QString& student() const { return student_; }
  const QString& folder() const { return folder_; }

 private:
  struct Kept {
    HandIn handIn;
    std::string text;  // of the file
    HandInWriter writer;
  };
  Kept& kept(const Lesson& lesson);
  std::string pathOf(const Lesson& lesson) const;

  const QString folder_, student_;
  std::map<std::string, Kept> kept_;
};

}  // namespace surefoot
