// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/handbook/html.h"

#include <fmt/format.h>
#include <md4c-html.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/files/whole_file.h"
#include "core/handbook/html_links.h"

namespace surefoot {

namespace fs = std::filesystem;

namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

constexpr const char* kStyle = R"(:root { color-scheme: light dark; --ink: #1f2328; --paper: #fafaf8; --quiet: #5f6671;
  --fill: #f1f3f5; --line: #e3e5e8; --accent: #0072b2; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e8eb; --paper: #16181c; --quiet: #9aa1ab; --fill: #2a2e35;
  --line: #33383f; --accent: #56b4e9; } }
body { margin: 0; display: flex; color: var(--ink); background: var(--paper); font: 16px/1.55 Roboto, sans-serif; }
nav { order: -1; flex: 0 0 240px; padding: 24px; border-right: 1px solid var(--line); font-size: 14px;
  box-sizing: border-box; position: sticky; top: 0; height: 100vh; overflow-y: auto; }
nav summary { color: var(--quiet); margin: 10px 0 4px; font-weight: 500; cursor: pointer; }
nav a { display: block; padding: 2px 0; color: var(--ink); text-decoration: none; }
nav details a { padding-left: 14px; }
nav a.here { color: var(--accent); font-weight: 500; }
main { flex: 1; min-width: 0; max-width: 760px; padding: 24px 40px 80px; overflow-x: auto; }
h1, h2, h3 { font-weight: 500; line-height: 1.25; }
a { color: var(--accent); }
code, pre { font: 14px/1.5 "Roboto Mono", monospace; background: var(--fill); border-radius: 4px; }
code { padding: 1px 4px; } pre { padding: 12px; overflow-x: auto; } pre code { padding: 0; }
table { border-collapse: collapse; } td, th { border: 1px solid var(--line); padding: 4px 10px; text-align: left; }
img { max-width: 100%; border: 1px solid var(--line); border-radius: 6px; }
blockquote { margin: 0 0 0 24px; color: var(--quiet); }
td:first-child code { white-space: nowrap; }
.up { display: none; } .pages { columns: 2; } .pages p { margin: 0; padding: 2px 0; }
@media (max-width: 800px) { body { display: block; } main { max-width: none; padding: 16px 20px; }
  .up { display: block; font-size: 14px; margin: 0; } .pages { columns: 1; }
  nav { border: 0; border-top: 1px solid var(--line); padding: 16px 20px 40px; height: auto; position: static; }
  nav a, nav summary { padding: 6px 0; margin: 0; } }
)";

/// "first-steps" becomes "first-steps.html" where a page is meant; `pictures` are the files that it shows.
std::string withFileNames(const HandbookPage& page, const Handbook& handbook, std::set<std::string>& pictures) {
  return withLinks(htmlOf(page), [&](std::string_view target, bool picture) {
    if (picture) pictures.emplace(target);
    const auto hash = std::min(target.find('#'), target.size());
    const bool isPage = !picture && pageNamed(handbook, target.substr(0, hash));
    return isPage ? fmt::format("{}.html{}", target.substr(0, hash), target.substr(hash)) : std::string(target);
  });
}

/// The sections, of which that of this page is open.
std::string navigation(const Handbook& handbook, const std::string& here, const HandbookSpeech& speech) {
  const HandbookPage* shown = pageNamed(handbook, here);
  std::string nav, section;
  for (const HandbookPage& page : handbook) {
    if (page.section != section) {
      const bool open = shown && shown->section == page.section;
      nav += fmt::format("{}<details{}>\n<summary>{}</summary>\n", section.empty() ? "" : "</details>\n",
                         open ? " open=\"open\"" : "", escaped(page.section));
      section = page.section;
    }
    nav += fmt::format("<a href=\"{}.html\"{}>{}</a>\n", page.name, page.name == here ? " class=\"here\"" : "",
                       escaped(page.title));
  }
  return fmt::format("<a href=\"index.html\">{}</a>\n{}</details>\n", escaped(speech.say("Handbook")), nav);
}

std::string wholePage(const Handbook& handbook, const std::string& name, const std::string& title,
                      const std::string& body, const HandbookSpeech& speech) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width\"/>\n<title>{} – Surefoot</title>\n"
      "<link rel=\"stylesheet\" href=\"style.css\"/>\n</head>\n<body>\n<main>\n"
      "<p class=\"up\"><a href=\"index.html\">{}</a></p>\n{}</main>\n<nav>\n{}</nav>\n</body>\n</html>\n",
      speech.code, escaped(title), escaped(speech.say("Handbook")), body, navigation(handbook, name, speech));
}

}  // namespace

std::string htmlOf(const HandbookPage& page) {
  std::string html = fmt::format("<h1>{}</h1>\n", escaped(page.title));
  const auto take = [](const MD_CHAR* part, MD_SIZE size, void* to) {
    static_cast<std::string*>(to)->append(part, size);
  };
  md_html(page.text.data(), static_cast<MD_SIZE>(page.text.size()), take, &html,
          MD_FLAG_TABLES | MD_FLAG_PERMISSIVEURLAUTOLINKS, MD_HTML_FLAG_XHTML);
  return html;
}

namespace {

Status writeInto(const fs::path& folder, const Handbook& handbook, const std::string& pictures,
                 const HandbookSpeech& speech) {
  const auto write = [&](const std::string& name, const std::string& content) {
    return writeWhole("handbook", (folder / name).string(), content);
  };
  if (const Status s = write("style.css", kStyle); !s) return s;
  std::string index = "<h1>Surefoot</h1>\n", section;
  std::set<std::string> shown;
  for (const HandbookPage& page : handbook) {
    if (page.section != section) {
      index += section.empty() ? "" : "</div>\n";
      index += fmt::format("<h2>{}</h2>\n<div class=\"pages\">\n", escaped(page.section));
      section = page.section;
    }
    index += fmt::format("<p><a href=\"{}.html\">{}</a></p>\n", page.name, escaped(page.title));
    const std::string body = withFileNames(page, handbook, shown);
    if (const Status s = write(page.name + ".html", wholePage(handbook, page.name, page.title, body, speech)); !s)
      return s;
  }
  if (const Status s = write("index.html", wholePage(handbook, "", speech.say("Handbook"), index + "</div>\n", speech));
      !s)
    return s;
  for (const std::string& picture : shown) {
    std::error_code error;
    fs::copy_file(fs::path(pictures) / picture, folder / picture, error);
    if (error)
      return Error{fmt::format("{}: it cannot be copied from {}: {}.", picture, pictures, error.message()),
                   ErrorKind::File};
  }
  return Done{};
}

}  // namespace

Status writeHtml(const Handbook& handbook, const std::string& pictures, const std::string& folder,
                 const HandbookSpeech& speech) {
  std::error_code error;
  if (fs::exists(folder, error))
    return Error{fmt::format("{}: it exists already; name a folder that does not.", folder), ErrorKind::File};
  fs::create_directories(folder, error);
  if (error) return Error{fmt::format("{}: it cannot be made: {}.", folder, error.message()), ErrorKind::File};
  const Status written = writeInto(folder, handbook, pictures, speech);
  if (!written) fs::remove_all(folder, error);  // all of it or nothing
  return written;
}

}  // namespace surefoot
