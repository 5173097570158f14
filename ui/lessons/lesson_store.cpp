// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_store.h"

#include <QDir>
#include <QFile>
#include <utility>

#include "core/files/read_file.h"
#include "core/files/whole_file.h"

namespace surefoot {

LessonStore::LessonStore(QString folder, QString student) : folder_(std::move(folder)), student_(std::move(student)) {}

std::string LessonStore::pathOf(const Lesson& lesson) const {
  return QDir(folder_).filePath(QString::fromStdString(lesson.name) + QStringLiteral(".jsonl")).toStdString();
}

LessonStore::Kept& LessonStore::kept(const Lesson& lesson) {
  if (const auto found = kept_.find(lesson.name); found != kept_.end()) return found->second;
  Kept kept;
  const auto text = readText(pathOf(lesson));
  std::uint64_t check = 0;
  auto read = text ? parseHandIn(*text, &check) : Result<HandIn>(Error{"none"});
  // A lesson that was rewritten, or lives of another version, begin anew: what was done does not hold there.
  if (read && read->lessonHash == lesson.hash) {
    kept = {std::move(*read), *text, HandInWriter(check)};
  } else {
    kept.handIn.lesson = lesson.name;
    kept.handIn.student = student_.toStdString();
    kept.handIn.lessonHash = lesson.hash;
    kept.handIn.seed = seedOf(lesson, kept.handIn.student);
  }
  return kept_.emplace(lesson.name, std::move(kept)).first->second;
}

HandIn LessonStore::handIn(const Lesson& lesson) {
  return kept(lesson).handIn;
}

Status LessonStore::add(const Lesson& lesson, const LessonMark& mark) {
  Kept& kept = this->kept(lesson);
  if (kept.text.empty()) kept.text = kept.writer.header(kept.handIn);
  kept.text += kept.writer.line(mark);
  kept.handIn.marks.push_back(mark);
  QDir().mkpath(folder_);
  return writeWhole("lessons", pathOf(lesson), kept.text);
}

Status LessonStore::forget(const Lesson& lesson) {
  kept_.erase(lesson.name);
  const QString path = QString::fromStdString(pathOf(lesson));
  if (!QFile::exists(path) || QFile::remove(path)) return Done{};
  return Error{"The file " + path.toStdString() + " cannot be removed."};
}

}  // namespace surefoot
