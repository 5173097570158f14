// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_store.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/files/limited_json.h"
#include "core/files/read_file.h"
#include "core/files/whole_file.h"

namespace surefoot {

Status LessonStore::setClass(const QString& folder, const QString& student) {
  if (!folder.isEmpty()) {
    FileLock present = FileLock::take(QDir(folder).filePath(QStringLiteral(".%1.lock").arg(student)));
    if (!present.held() && QFileInfo(folder).isWritable())
      return Error{
          QObject::tr("Another %1 is in this class now; take another name, such as %1 2.").arg(student).toStdString()};
    present_ = std::move(present);
  }
  class_ = folder;
  student_ = student;
  kept_.clear();
  return Done{};
}

std::string LessonStore::pathOf(const Lesson& lesson, const QString& folder) const {
  const QString name = QString::fromStdString(lesson.name);
  const QString file = student_.isEmpty() ? name : QStringLiteral("%1 %2").arg(student_, name);
  return QDir(folder).filePath(file + QStringLiteral(".jsonl")).toStdString();
}

std::string LessonStore::draftsOf(const Lesson& lesson) const {
  return QString::fromStdString(pathOf(lesson, own_))
      .replace(QStringLiteral(".jsonl"), QStringLiteral(".drafts.json"))
      .toStdString();
}

LessonStore::Kept& LessonStore::kept(const Lesson& lesson) {
  if (const auto found = kept_.find(lesson.name); found != kept_.end()) return found->second;
  Kept kept;
  std::uint64_t check = 0;
  auto text = readText(pathOf(lesson, class_.isEmpty() ? own_ : class_));
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
  if (class_.isEmpty()) {
    QDir().mkpath(own_);
    return writeWhole("lessons", pathOf(lesson, own_), kept.text);
  }
  const Status s = QDir(class_).exists()
                       ? writeWhole("lessons", pathOf(lesson, class_), kept.text)
                       : Status(Error{QObject::tr("The class's folder is gone: %1.").arg(class_).toStdString()});
  if (s) return s;
  QDir().mkpath(own_);
  if (const Status here = writeWhole("lessons", pathOf(lesson, own_), kept.text); !here) return here;
  return Error{s.error().message + ' ' +
               QObject::tr("It is kept on this computer, and goes there when it can.").toStdString()};
}

namespace {
constexpr const char* kDraft = "draft.toml";
constexpr std::size_t kLongestDrafts = 1u << 20;  // [bytes]
}  // namespace

QString LessonStore::draft() const {
  const auto text = readText(QDir(own_).filePath(QLatin1String(kDraft)).toStdString());
  return text ? QString::fromStdString(*text) : QString();
}

void LessonStore::keepDraft(const QString& text) const {
  const QString path = QDir(own_).filePath(QLatin1String(kDraft));
  if (text.isEmpty()) return static_cast<void>(QFile::remove(path));
  QDir().mkpath(own_);
  const Status kept = writeWhole("draft", path.toStdString(), text.toStdString());
  static_cast<void>(static_cast<bool>(kept));  // a help, no promise
}

LessonDrafts LessonStore::drafts(const Lesson& lesson) const {
  LessonDrafts drafts;
  const auto text = readText(draftsOf(lesson));
  const nlohmann::json json = text ? parseJson(*text, kLongestDrafts) : nlohmann::json();
  if (!json.is_object() || json.value("lesson_hash", nlohmann::json()) != lesson.hash) return drafts;
  for (const nlohmann::json& one : json.value("drafts", nlohmann::json::array()))
    if (one.is_array() && one.size() == 3 && one[0].is_number_unsigned() && one[1].is_string() && one[2].is_string())
      drafts[one[0].get<std::size_t>()] = {one[1].get<std::string>(), one[2].get<std::string>()};
  return drafts;
}

void LessonStore::keepDrafts(const Lesson& lesson, const LessonDrafts& drafts) const {
  if (drafts.empty()) return;
  nlohmann::json json = {{"lesson_hash", lesson.hash}, {"drafts", nlohmann::json::array()}};
  for (const auto& [step, draft] : drafts) json["drafts"].push_back({step, draft.answer, draft.because});
  QDir().mkpath(own_);
  const Status kept = writeWhole("drafts", draftsOf(lesson), json.dump());
  static_cast<void>(static_cast<bool>(kept));  // a help, no promise
}

Status LessonStore::forget(const Lesson& lesson) {
  kept_.erase(lesson.name);
  QFile::remove(QString::fromStdString(draftsOf(lesson)));
  const QString path = QString::fromStdString(pathOf(lesson, class_.isEmpty() ? own_ : class_));
  if (!QFile::exists(path) || QFile::remove(path)) return Done{};
  return Error{QObject::tr("The file %1 cannot be removed.").arg(path).toStdString()};
}

}  // namespace surefoot
