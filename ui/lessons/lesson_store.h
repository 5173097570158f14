// SPDX-License-Identifier: GPL-3.0-or-later
// What was done in the lessons, kept in a folder: a file for each lesson (hand_in.h). The window's thread.
#pragma once

#include <QString>
#include <map>

#include "core/lessons/handed_in/hand_in.h"
#include "ui/lessons/driver/lesson_draft.h"
#include "ui/support/file_lock.h"

namespace surefoot {

class LessonStore {
 public:
  /// The folder is made when something is kept there first.
  explicit LessonStore(QString folder) : own_(std::move(folder)) {}
  /// In a class the files are in its folder, with the student's name in front. While it cannot be written to, they are
  /// in the own folder. An error: another student of this name is there now.
  Status setClass(const QString& folder, const QString& student);

  /// What was done before, or an empty one.
  HandIn handIn(const Lesson& lesson);
  /// One more line. An error: the file cannot be written; the line is still known here.
  Status add(const Lesson& lesson, const LessonMark& mark);
  /// Forgets a lesson, and its file.
  Status forget(const Lesson& lesson);
  /// What is chosen or typed and not given yet; kept here only, never in a class.
  LessonDrafts drafts(const Lesson& lesson) const;
  void keepDrafts(const Lesson& lesson, const LessonDrafts& drafts) const;
  /// A lesson's text that was not saved, from before; empty: none.
  QString draft() const;
  /// Keeps it, or forgets it (empty).
  void keepDraft(const QString& text) const;
  const QString& student() const { return student_; }
  /// The folder of a class; empty: there is none.
  const QString& classFolder() const { return class_; }

 private:
  struct Kept {
    HandIn handIn;
    std::string text;  // of the file
    HandInWriter writer;
  };
  Kept& kept(const Lesson& lesson);
  std::string pathOf(const Lesson& lesson, const QString& folder) const;
  std::string draftsOf(const Lesson& lesson) const;  // the path of their file

  const QString own_;
  QString class_, student_;
  FileLock present_;
  std::map<std::string, Kept> kept_;
};

}  // namespace surefoot
