// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/open_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/files/read_file.h"
#include "core/registry.h"
#include "core/saved/followable.h"
#include "core/text/printable.h"
#include "core/text/words.h"

namespace surefoot {

OpenLine::OpenLine(CLI::App& app) : window(app) {
  app.add_option("FILE", file,
                 "a file to open: a robot, a lesson, a plan, a store of results, a session, a checkpoint, a journal or "
                 "a Q-function")
      ->type_name("");
  addOption(app, "--follow", follow,
            "look at results or a checkpoint while another process writes them; nothing is written, and no life begins",
            "FILE");
  addOption(app, "--page", page, fmt::format("begin on this page: {}", joinWords(pages(), "or")), "NAME");
  addOption(app, "--language", language,
            fmt::format("the window's language, this time: {}", joinWords(languages(), "or")), "CODE");
  app.add_flag("--new-window", newWindow, "open a window of its own, as without this option");
  app.add_flag("--reuse-window", reuseWindow, "open FILE in the window that is there already, if there is one");
}

Status OpenLine::nothingBeside(const std::vector<std::string>& allowed, const std::string& why) const {
  for (const CLI::Option* option : window.get_options())
    if (const std::string name = option->get_name();
        option->count() > 0 && std::find(allowed.begin(), allowed.end(), name) == allowed.end())
      return Error{fmt::format("{}, so {} has no place beside it.", why, name)};
  return Done{};
}

Status OpenLine::check() const {
  if (newWindow && reuseWindow) return Error{"--new-window and --reuse-window exclude each other."};
  if (page && std::find(pages().begin(), pages().end(), *page) == pages().end())
    return unknownName("--page", *page, pages());
  if (language && std::find(languages().begin(), languages().end(), *language) == languages().end())
    return unknownName("--language", *language, languages());
  if (follow) {
    const std::string why = fmt::format("--follow: it only looks at {}", *follow);
    if (const Status s = nothingBeside({"--follow", "--allow-programs", "--language", "--new-window"}, why); !s)
      return s;
    const auto what = followableAt(*follow);
    return what ? Status(Done{}) : Status(what.error());
  }
  const std::vector<std::string> allowed = {"FILE",           "--allow-programs", "--turbo", "--new-window",
                                            "--reuse-window", "--student",        "--class", "--json",
                                            "--log",          "--language"};
  if (reuseWindow)
    if (const Status s =
            nothingBeside({"FILE", "--reuse-window"}, "--reuse-window: the window that is there stays as it is");
        !s)
      return s;
  if (file.empty()) return Done{};
  if (const Status s = nothingBeside(allowed, fmt::format("FILE: {} is opened as it is", printable(file))); !s)
    return s;
  const auto head = readHead(file, 1);
  return head ? Status(Done{}) : Status(head.error());
}

void OpenLine::complete(WindowRequest& request) const {
  request.follow = follow;
  request.language = language;
  std::error_code error;
  if (!file.empty()) request.file = std::filesystem::absolute(file, error).string();
  request.reuseWindow = reuseWindow;
  if (page) request.page = static_cast<int>(std::find(pages().begin(), pages().end(), *page) - pages().begin());
}

const std::vector<std::string>& OpenLine::pages() {
  static const std::vector<std::string> names = {"live", "experiment", "lessons", "robot"};
  return names;
}

const std::vector<std::string>& OpenLine::languages() {
  static const std::vector<std::string> codes = {"en", "nl", "de"};
  return codes;
}

bool OpenLine::isFile(const std::string& word) {
  std::error_code error;
  if (word.starts_with('-')) return false;
  if (word.find('/') != std::string::npos || std::filesystem::is_regular_file(word, error)) return true;
  const auto ending = std::filesystem::path(word).extension();
  return ending == ".toml" || ending == ".surefoot" || ending == ".safetensors" || ending == ".sqlite" ||
         ending == ".jsonl";
}

}  // namespace surefoot
