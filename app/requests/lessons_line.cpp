// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/lessons_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/requests/requests.h"
#include "core/text/printable.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

/// A name that can stand in a file's name on every system.
Status checkStudent(const std::string& name) {
  constexpr std::size_t kLongest = 40;
  const auto allowed = [](unsigned char c) { return std::isalnum(c) || c == ' ' || c == '-' || c == '_' || c >= 0x80; };
  const bool fine = !name.empty() && name.size() <= kLongest && isUtf8(name) && name.front() != ' ' &&
                    name.back() != ' ' && std::all_of(name.begin(), name.end(), allowed);
  if (fine) return Done{};
  return Error{fmt::format("--student: \"{}\" is no name here; it takes up to {} letters, digits, blanks, - and _.",
                           printable(shortened(name)), kLongest)};
}

}  // namespace

LessonsLine::LessonsLine(CLI::App& app, CLI::App& window)
    : lessons(app.add_subcommand("lessons", "list the lessons; check, grade or print them")) {
  lessons
      ->add_option("WORDS", request.words,
                   "check FILE … (all lessons if none is named): read them, and live through what their steps ask; "
                   "grade FOLDER: live what students handed in again; handout NAME: print a lesson; none: the list")
      ->type_name("");
  lessons->add_flag("--show", request.show, "with check: print what a student reads, with its numbers");
  lessons->add_flag("--solutions", request.solutions, "with handout: for the teacher");
  addOption(*lessons, "--out", request.out, "with grade or handout: the file to write, which must not exist yet",
            "FILE");
  addOption(window, "--lesson", lesson, "begin with this lesson: its name, or a file", "NAME");
  addOption(window, "--student", student, "whose answers they are", "NAME");
  addOption(window, "--class", classFolder, "a shared folder, where answers are kept", "FOLDER");
  addOption(window, "--kiosk", kiosk, "show this lesson's two robots on the whole screen, and nothing else", "NAME");
  addOption(window, "--reset-after", resetAfter, "with --kiosk: begin again after so many seconds without a touch [90]",
            "N");
}

Status LessonsLine::complete(WindowRequest& window) const {
  constexpr std::int64_t kLongestRest = 3600;
  window.lesson = lesson;
  window.kiosk = kiosk;
  if (student)
    if (const Status s = checkStudent(*student); !s) return s;
  window.student = student.value_or("");
  window.classFolder = classFolder.value_or("");
  if (classFolder && !student) return Error{"--class: --student NAME is needed with it, to keep answers apart."};
  std::error_code error;
  if (classFolder && !std::filesystem::is_directory(*classFolder, error))
    return Error{fmt::format("--class: there is no folder {}.", printable(*classFolder)), ErrorKind::File};
  if (lesson && kiosk) return Error{"--lesson and --kiosk exclude each other."};
  if (resetAfter && !kiosk) return Error{"--reset-after: it is for --kiosk."};
  if (!resetAfter) return Done{};
  const auto seconds = parseCount("--reset-after", *resetAfter, kLongestRest);
  if (!seconds) return seconds.error();
  window.resetAfter = static_cast<int>(*seconds);
  return Done{};
}

}  // namespace surefoot
