// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/lessons_grading.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <thread>

#include "app/process/interrupt.h"
#include "app/process/resources.h"
#include "core/experiment/work_pool.h"
#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "core/lessons/handed_in/grading.h"

namespace surefoot {

namespace {

namespace fs = std::filesystem;

/// The lessons that a hand-in can be of: those in the folder come before the program's.
std::map<std::string, Lesson> lessonsFor(const Registry& registry, const std::string& folder) {
  std::map<std::string, Lesson> all;
  for (const std::string& where : {resourceFolder("lessons"), folder})
    for (ShelvedLesson& one : lessonsIn(registry, where))
      if (one.lesson) all.insert_or_assign(one.lesson->name, std::move(*one.lesson));
  return all;
}

std::vector<fs::path> handInsIn(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error))
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

Grade gradeFile(const Registry& registry, const std::map<std::string, Lesson>& lessons, const fs::path& file,
                const std::atomic<bool>& interrupted) {
  Grade untrusted;
  untrusted.student = file.stem().string();
  untrusted.trusted = false;
  const auto refuse = [&](const std::string& why) {
    untrusted.remarks.push_back(file.filename().string() + ": " + why);
    return untrusted;
  };
  const auto text = readText(file.string());
  if (!text) return refuse(text.error().message);
  const auto handIn = parseHandIn(*text);
  if (!handIn) return refuse(handIn.error().message);
  untrusted.student = handIn->student, untrusted.lesson = handIn->lesson;
  const auto lesson = lessons.find(handIn->lesson);
  if (lesson == lessons.end()) return refuse("no lesson of this name is known; its file may lie beside the hand-ins.");
  return gradeOf(registry, lesson->second, *handIn, &interrupted);
}

}  // namespace

int gradeLessons(const Registry& registry, const LessonsRequest& request) {
  if (request.words.size() != 2) return fail({"lessons grade: it takes one folder."});
  const std::string& folder = request.words[1];
  std::error_code error;
  if (!fs::is_directory(folder, error))
    return fail({fmt::format("lessons grade: there is no folder {}.", folder), ErrorKind::File});
  std::optional<WholeFile> out;
  if (request.out) {
    auto file = WholeFile::createNew("--out", *request.out);
    if (!file) return fail(file.error());
    out.emplace(std::move(*file));
  }
  const auto files = handInsIn(folder);
  if (files.empty()) return fail({fmt::format("lessons grade: nothing was handed in in {}.", folder)});
  const auto lessons = lessonsFor(registry, folder);
  const std::atomic<bool>& interrupted = watchForInterrupt();
  std::vector<Grade> grades(files.size());
  WorkPool pool(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())), &interrupted);
  const Status done = pool.run(static_cast<std::int64_t>(files.size()),
                               [&](std::int64_t i) -> Status {
                                 const auto at = static_cast<std::size_t>(i);
                                 grades[at] = gradeFile(registry, lessons, files[at], interrupted);
                                 return Done{};
                               },
                               {});
  if (!done) return fail(done.error());
  if (interrupted) return kInterrupted;
  std::string table = gradesHead();
  for (const Grade& grade : grades) table += asCsv(grade);
  if (!out) return print(table);
  if (const Status s = out->commit(table); !s) return fail(s.error());
  const auto doubtful = std::count_if(grades.begin(), grades.end(), [](const Grade& g) { return !g.trusted; });
  return print(fmt::format("{}: {} hand-ins, {} to be looked at\n", *request.out, grades.size(), doubtful));
}

}  // namespace surefoot
