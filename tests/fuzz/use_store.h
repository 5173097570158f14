// SPDX-License-Identifier: GPL-3.0-or-later
// Reads any bytes as a store: its pages as they are, or a good store in which the bytes say which values are others.
// Whatever the bytes, this must return.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <unistd.h>

#include <fstream>

#include "core/findings/findings.h"

namespace surefoot {

/// Reads from the front of some bytes; zeros behind their end.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}
  bool empty() const { return bytes_.empty(); }
  std::uint64_t take(int count) {
    std::uint64_t value = 0;
    for (; count > 0 && !bytes_.empty(); --count, bytes_.remove_prefix(1))
      value = value << 8 | static_cast<unsigned char>(bytes_.front());
    return value;
  }
  std::string text(std::size_t most) {
    const std::string text(bytes_.substr(0, take(1) % (most + 1)));
    bytes_.remove_prefix(std::min(bytes_.size(), text.size()));
    return text;
  }

 private:
  std::string_view bytes_;
};

/// A store with two conditions, two lives each and three episodes a life.
inline void makeSmallStore(const std::string& path) {
  StoredPlan plan{.title = "small", .version = "0", .seed = 1, .paired = false, .conditions = {}};
  for (const char* name : {"a", "b"})
    plan.conditions.push_back(
        {name, "a", "environment=cliff", R"({"environment":"cliff","policy":"greedy"})", 2, 0, 0});
  auto store = Store::create(path, plan);
  for (int c = 0; store && c < 2; ++c)
    for (int life = 0; life < 2; ++life)
      static_cast<void>(static_cast<bool>(store->save(
          {.condition = c, .life = life, .episodes = 3, .steps = 30, .falls = 1, .diverged = {}, .hash = 7},
          {{10, -1.0, 1, EndingCode::Fall}, {10, 1.0, 0, EndingCode::Success}, {10, 0.0, 0, EndingCode::End}}, {},
          {{0, "distance", 2.0}})));
}

/// Puts other values into rows that the bytes choose, whatever their type.
inline void changeValues(const std::string& path, Bytes bytes) {
  SQLite::Database db(path, SQLite::OPEN_READWRITE);
  constexpr const char* kTables[] = {"experiment", "conditions", "pre_learned", "lives",
                                     "episodes",   "measures",   "endings"};
  while (!bytes.empty()) {
    const std::string table = kTables[bytes.take(1) % 7];
    SQLite::Statement columns(db, "SELECT name FROM pragma_table_info('" + table + "')");
    std::vector<std::string> names;
    while (columns.executeStep()) names.push_back(columns.getColumn(0).getString());
    const std::string column = names[bytes.take(1) % names.size()];
    const auto row = bytes.take(1) % 12, type = bytes.take(1) % 5;
    try {
      SQLite::Statement change(
          db, "UPDATE OR REPLACE " + table + " SET " + column + " = ?1 WHERE " + names[0] + " = ?2 OR ?2 > 7");
      if (type == 0) change.bind(1, static_cast<std::int64_t>(bytes.take(8)));
      if (type == 1) change.bind(1, std::bit_cast<double>(bytes.take(8)));
      if (type == 2) change.bind(1, bytes.text(40));
      if (type == 3) change.bind(1, static_cast<std::int64_t>(bytes.take(1)) - 8);
      change.bind(2, static_cast<std::int64_t>(row));
      change.exec();
    } catch (const SQLite::Exception&) {  // a value that the table does not take
    }
  }
}

/// Everything that reads a store. True: it was taken.
inline bool readAll(const Registry& registry, const std::string& path) {
  const auto store = Store::open(path);
  if (!store) return false;
  static_cast<void>(static_cast<bool>(store->contentHash()));
  const auto findings = findingsOf(registry, *store);
  if (!findings) return false;
  static_cast<void>(findingsAsTable(*findings) + findingsAsCsv(*findings) + findingsAsLatex(*findings) +
                    findingsAsJson(*findings).dump());
  return true;
}

inline bool useStore(const Registry& registry, const std::string& bytes) {
  if (bytes.empty()) return false;
  const std::string path = "/dev/shm/surefoot-fuzz-" + std::to_string(getpid()) + ".sqlite";
  unlink(path.c_str());
  if (bytes[0] == 'S') {
    std::ofstream(path, std::ios::binary) << bytes;  // an SQLite file begins with S
  } else {
    makeSmallStore(path);
    changeValues(path, Bytes(std::string_view(bytes).substr(1)));
  }
  const bool taken = readAll(registry, path);
  for (const char* rest : {"", "-wal", "-shm", "-journal", "-lock"}) unlink((path + rest).c_str());
  return taken;
}

}  // namespace surefoot
