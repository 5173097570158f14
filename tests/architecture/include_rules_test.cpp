// SPDX-License-Identifier: GPL-3.0-or-later
// What each room may see. Its CMakeLists.txt says it (surefoot_room … SEES …); the compiler finds every header of the
// project whatever is said there, so it is checked here that files include no others, and that no room is in a circle.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using Rooms = std::map<std::string, std::set<std::string>>;  // a room, and those that it sees

const fs::path kSource = SUREFOOT_SOURCE;
constexpr const char* kFolders[] = {"core", "physics", "ui", "app"};

std::string textOf(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

Rooms readRooms() {
  const std::regex call(R"(surefoot_room\(([^)]*)\))");
  Rooms rooms;
  for (const char* folder : kFolders)
    for (const auto& entry : fs::recursive_directory_iterator(kSource / folder)) {
      if (entry.path().filename() != "CMakeLists.txt") continue;
      const std::string text = textOf(entry.path());
      std::smatch match;
      if (!std::regex_search(text, match, call)) continue;
      std::istringstream words(match[1].str());
      std::string name, word, part;
      words >> name;
      EXPECT_EQ(kSource / name, entry.path().parent_path()) << "a room has the name of its folder";
      std::set<std::string>& sees = rooms[name];
      while (words >> word)
        if (word == "SEES" || word == "LIBRARIES" || word == "SOURCES" || word == "HOT")
          part = word;
        else if (part == "SEES")
          sees.insert(word);
    }
  return rooms;
}

void eachInclude(
    const std::function<void(const std::string& room, const std::string& header, const std::string& where)>& check) {
  const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  for (const char* folder : kFolders)
    for (const auto& entry : fs::recursive_directory_iterator(kSource / folder)) {
      const auto extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      const std::string room = fs::relative(entry.path().parent_path(), kSource).string();
      std::ifstream in(entry.path());
      std::string line;
      std::smatch match;
      for (int number = 1; std::getline(in, line); ++number)
        if (std::regex_search(line, match, include))
          check(room, match[1].str(), entry.path().string() + ":" + std::to_string(number));
    }
}

bool matches(const std::string& text, const char* pattern) {
  return std::regex_search(text, std::regex(pattern));
}

}  // namespace

TEST(Rooms, IncludeOnlyWhatTheirCMakeListsSay) {
  const Rooms rooms = readRooms();
  EXPECT_GT(rooms.size(), 30u);
  int seen = 0;
  std::map<std::string, std::set<std::string>> used;
  eachInclude([&](const std::string& room, const std::string& header, const std::string& where) {
    if (room == "app" || !matches(header, "^(core|physics|ui|app)/")) return;  // the program sees all rooms
    ++seen;
    const std::string of = fs::path(header).parent_path().string();
    const auto found = rooms.find(room);
    ASSERT_NE(found, rooms.end()) << where << ": " << room << " is no room";
    EXPECT_TRUE(of == room || found->second.contains(of)) << where << ": " << room << " does not see " << of;
    used[room].insert(of);
  });
  EXPECT_GT(seen, 500);
  for (const auto& [room, sees] : rooms)
    for (const std::string& other : sees)
      EXPECT_TRUE(used[room].contains(other)) << room << " says that it sees " << other << ", and does not";
}

TEST(Rooms, HaveNoCircle) {
  const Rooms rooms = readRooms();
  std::set<std::string> good, open;
  const std::function<void(const std::string&)> visit = [&](const std::string& room) {
    if (good.contains(room)) return;
    ASSERT_TRUE(open.insert(room).second) << room << " sees itself by way of others";
    ASSERT_TRUE(rooms.contains(room)) << room << " is no room";
    for (const std::string& other : rooms.at(room)) visit(other);
    open.erase(room);
    good.insert(room);
  };
  for (const auto& [room, sees] : rooms) visit(room);
}

TEST(Rooms, KeepQtBox2dAndCommandLinesWhereTheyBelong) {
  eachInclude([](const std::string& room, const std::string& header, const std::string& where) {
    const bool core = room.starts_with("core"), physics = room.starts_with("physics"), ui = room.starts_with("ui");
    EXPECT_FALSE((core || physics) && matches(header, "^Q[A-Z]|^Qt[A-Z]")) << where << ": builds without Qt";
    EXPECT_FALSE(!physics && matches(header, "^box2d")) << where << ": Box2D belongs to physics/";
    EXPECT_FALSE((core || physics || ui) && matches(header, "^CLI/")) << where << ": command lines belong to app/";
    EXPECT_FALSE(core && matches(header, "^(physics|ui|app)/")) << where << ": core/ is below";
    EXPECT_FALSE(physics && matches(header, "^(ui|app)/")) << where << ": physics/ knows core/ alone";
    EXPECT_FALSE(ui && matches(header, "^(physics|app)/")) << where << ": ui/ sees environments through core/";
  });
}
