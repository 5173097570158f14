// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>

#include "app/commands/lessons_grading.h"
#include "app/process/resources.h"
#include "app/reports/figures.h"
#include "core/files/whole_file.h"
#include "core/lessons/lesson_check.h"
#include "core/lessons/reading/lesson_library.h"
#include "core/lessons/reading/lesson_reading.h"
#include "core/text/printable.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

constexpr std::uint64_t kSeed = 1;  // a student's, in lessons with a seed for each

int listLessons(const Registry& registry) {
  std::string text, chapter;
  for (const ShelvedLesson& one : lessonsIn(registry, resourceFolder("lessons"))) {
    if (!one.lesson) {
      text += fmt::format("  {}: it has an error; `surefoot lessons check` tells it\n", one.file());
      continue;
    }
    const Lesson& lesson = *one.lesson;
    if (lesson.chapter != chapter) text += fmt::format("{}{}\n", text.empty() ? "" : "\n", chapter = lesson.chapter);
    text += fmt::format("  {:>2} {:<36} {:>3.0f} min, level {}\n     {}\n", lesson.number, lesson.title, lesson.minutes,
                        lesson.level, lesson.line);
  }
  if (text.empty()) return fail({"lessons: they come with the program, and none were found beside it."});
  return print(text);
}

/// What is wrong in a lesson's file: when it is read, or when its solutions are lived through.
std::vector<Complaint> complaintsOf(const Registry& registry, const ShelvedLesson& one, std::vector<ToldStep>* told) {
  std::vector<Complaint> all = one.complaints;
  if (!one.lesson) return all;
  const std::uint64_t seed = one.lesson->seedOfStudent ? kSeed : one.lesson->start.seed;
  for (Complaint& c : liveThrough(registry, *one.lesson, seed, told)) all.push_back(std::move(c));
  return all;
}

Result<std::vector<ShelvedLesson>> lessonsNamed(const Registry& registry, const LessonsRequest& request) {
  if (request.words.size() == 1) return lessonsIn(registry, resourceFolder("lessons"));
  std::vector<ShelvedLesson> all;
  for (std::size_t i = 1; i < request.words.size(); ++i) {
    auto one = readLessonFile(registry, request.words[i]);
    if (!one) return one.error();
    all.push_back(std::move(*one));
  }
  return all;
}

int checkLessons(const Registry& registry, const LessonsRequest& request) {
  const auto lessons = lessonsNamed(registry, request);
  if (!lessons) return fail(lessons.error());
  std::size_t wrong = 0;
  for (const ShelvedLesson& one : *lessons) {
    std::vector<ToldStep> told;
    const auto complaints = complaintsOf(registry, one, request.show ? &told : nullptr);
    std::string text;
    for (std::size_t i = 0; i < told.size(); ++i)
      text += fmt::format("{}. {} ({})\n{}\n{}\n", i + 1, one.lesson->steps[i].title, kindOf(one.lesson->steps[i]),
                          told[i].say, told[i].came);
    wrong += !complaints.empty();
    for (const Complaint& c : complaints) text += complaintText(one.path, c) + "\n";
    if (complaints.empty())
      text += fmt::format("{}: well, {} steps lived through\n", one.path, one.lesson->steps.size());
    if (const int code = print(text); code != 0) return code;
  }
  if (lessons->empty()) return fail({"lessons: they come with the program, and none were found beside it."});
  return wrong == 0 ? 0 : fail({fmt::format("lessons: {} of {} need mending.", wrong, lessons->size())});
}

/// A lesson by its name, its number or its file.
Result<ShelvedLesson> findLesson(const Registry& registry, const std::string& name) {
  std::error_code error;
  if (std::filesystem::is_regular_file(name, error)) return readLessonFile(registry, name);
  std::vector<std::string> names;
  for (ShelvedLesson& one : lessonsIn(registry, resourceFolder("lessons"))) {
    if (!one.lesson) continue;
    if (one.lesson->name == name || one.lesson->number == name) return std::move(one);
    names.push_back(one.lesson->name);
  }
  return Error{fmt::format("lessons handout: there is no lesson \"{}\"; there are {}.", printable(shortened(name)),
                           joinWords(names))};
}

int printHandout(const Registry& registry, const LessonsRequest& request) {
  if (request.words.size() != 2) return fail({"lessons handout: it takes the name or the file of one lesson."});
  if (!request.out) return fail({"lessons handout: --out FILE.pdf is needed."});
  if (!FigureDrawer::canDraw()) return fail({"lessons handout: this program was built without Qt and cannot draw."});
  const auto one = findLesson(registry, request.words[1]);
  if (!one) return fail(one.error());
  if (!one->lesson) return fail({complaintText(one->path, one->complaints.at(0))});
  auto file = WholeFile::createNew("--out", *request.out);
  if (!file) return fail(file.error());
  std::vector<ToldStep> told;
  const std::uint64_t seed = one->lesson->seedOfStudent ? kSeed : one->lesson->start.seed;
  if (request.solutions) static_cast<void>(liveThrough(registry, *one->lesson, seed, &told));
  const std::string pdf = FigureDrawer().handout(registry, *one->lesson, told);
  if (const Status s = file->commit(pdf); !s) return fail(s.error());
  return print(*request.out + "\n");
}

}  // namespace

int lessonsCommand(const Registry& registry, const LessonsRequest& request) {
  if (request.words.empty()) return listLessons(registry);
  if (request.words[0] == "check") return checkLessons(registry, request);
  if (request.words[0] == "grade") return gradeLessons(registry, request);
  if (request.words[0] == "handout") return printHandout(registry, request);
  return fail(
      {fmt::format("lessons: it takes check, grade or handout, not \"{}\": `surefoot lessons check "
                   "FILE…`; without a word it lists the program's lessons.",
                   request.words[0])});
}

}  // namespace surefoot
