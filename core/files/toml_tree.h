// SPDX-License-Identifier: GPL-3.0-or-later
// TOML from outside as a tree in the order of the file, every node with its place, and a reader that complains about
// everything in it that nobody asked for. Any thread.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

struct TextPlace {
  int line = 0, column = 0;  ///< from 1
};

/// What is wrong at a place of a text.
struct Complaint {
  TextPlace at;
  std::string sentence;
};

/// "hopper.toml:121:10: value: …", as editors understand it; without a column, or a line, where there is none.
std::string complaintLine(const std::string& file, const Complaint& complaint);

struct TomlNode {
  enum class Kind { Text, Whole, Number, Flag, List, Table };
  Kind kind = Kind::Table;
  TextPlace at{};
  TextPlace keyAt{};  ///< of the key that it belongs to
  std::string text{};
  std::int64_t whole = 0;
  double number = 0.0;  ///< of a whole number, too
  bool flag = false;
  std::vector<TomlNode> list{};
  std::vector<std::pair<std::string, TomlNode>> table{};  ///< in the order of the file

  const TomlNode* find(std::string_view key) const;
};

/// The table of a file; nothing, with complaints: it is too large, too deep, no TOML, or holds dates.
std::optional<TomlNode> parseToml(std::string_view text, std::vector<Complaint>& complaints);

/// Takes values out of a table. What is missing, of another kind or out of range gets a complaint and a usual value;
/// end() complains about keys that were never asked for.
class TomlReader {
 public:
  TomlReader(const TomlNode& table, std::vector<Complaint>& complaints) : table_(table), complaints_(complaints) {}

  const TomlNode* find(std::string_view key);
  /// Like find(), with a complaint if it is missing.
  const TomlNode* need(std::string_view key);

  std::string text(std::string_view key, std::string otherwise = "");
  std::string neededText(std::string_view key);
  double number(std::string_view key, double low, double high, double otherwise);
  std::int64_t whole(std::string_view key, std::int64_t low, std::int64_t high, std::int64_t otherwise);
  bool flag(std::string_view key, bool otherwise = false);
  std::vector<std::string> texts(std::string_view key);
  /// The tables of a list of tables, or the one table.
  std::vector<const TomlNode*> tables(std::string_view key);
  const TomlNode* table(std::string_view key);

  /// Complains at a key, or at the table if the key is not there.
  void complain(std::string_view key, std::string sentence);
  /// False: there was such a key.
  bool end();

 private:
  const TomlNode* findKind(std::string_view key, TomlNode::Kind kind, const char* what);

  const TomlNode& table_;
  std::vector<Complaint>& complaints_;
  std::vector<std::string> known_;
};

}  // namespace surefoot
