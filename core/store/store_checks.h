// SPDX-License-Identifier: GPL-3.0-or-later
// What is read from a store makes sense, and is what was written: every number has a type and a range, and every life a
// checksum of its row, its episodes and its measures.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "core/store/store.h"

namespace surefoot {

/// Thrown inside of the store only (guarded() makes an error of it): half a sentence that says what is wrong.
struct Damaged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One row of a table, read with suspicion. `table` is its name for messages.
class CheckedRow {
 public:
  CheckedRow(SQLite::Statement& row, const char* table) : row_(row), table_(table) {}
  std::int64_t whole(int column, std::int64_t low, std::int64_t high) const;
  int number(int column, int low, int high) const { return static_cast<int>(whole(column, low, high)); }
  /// Finite.
  double real(int column) const;
  /// UTF-8.
  std::string text(int column, std::size_t most = 1u << 20) const;
  /// Sixteen digits.
  std::uint64_t hash(int column) const;
  bool isNull(int column) const { return row_.isColumnNull(column); }

 private:
  [[noreturn]] void refuse(int column, const std::string& value) const;
  SQLite::Statement& row_;
  const char* table_;
};

/// Whether the episodes are those that the life counts.
void checkEpisodes(const StoredLife& life, const std::vector<StoredEpisode>& episodes);

std::uint64_t checksumOf(const StoredLife& life);
std::uint64_t checksumOf(const std::vector<StoredEpisode>& episodes);
std::uint64_t checksumOf(std::vector<StoredMeasure> measures);
std::uint64_t checksumOf(const StoredPreLearning& facts);
std::uint64_t checksumOf(const StoredPlan& plan);

/// The three checksums of a life as a store notes them: 48 digits.
std::string checksumText(std::uint64_t life, std::uint64_t episodes, std::uint64_t measures);
enum class ChecksumPart { Life, Episodes, Measures };
/// Throws Damaged unless this part of the text is this sum.
void compareChecksum(const std::string& text, ChecksumPart part, std::uint64_t sum, const std::string& what);

std::string hexText(std::uint64_t value);

}  // namespace surefoot
