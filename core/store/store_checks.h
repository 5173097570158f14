// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of everything that is read from a store: every number must have its type and range, and every life the
// checksums of its row, its episodes and its measures.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "core/store/store.h"

namespace surefoot {

/// Thrown only inside the store (guarded() makes an error of it): half a sentence that says what is damaged.
struct Damaged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One row of a table; every value is checked. Messages call the table `table`.
class CheckedRow {
 public:
  CheckedRow(SQLite::Statement& row, const char* table) : row_(row), table_(table) {}
  std::int64_t whole(int column, std::int64_t low, std::int64_t high) const;
  int number(int column, int low, int high) const { return static_cast<int>(whole(column, low, high)); }
  /// A finite number.
  double real(int column) const;
  /// A text in UTF-8.
  std::string text(int column, std::size_t most = 1u << 20) const;
  /// A hash of sixteen digits.
  std::uint64_t hash(int column) const;
  bool isNull(int column) const { return row_.isColumnNull(column); }

 private:
  [[noreturn]] void refuse(int column, const std::string& value) const;
  SQLite::Statement& row_;
  const char* table_;
};

/// Checks that the episodes agree with the life's totals.
void checkEpisodes(const StoredLife& life, const std::vector<StoredEpisode>& episodes);

std::uint64_t checksumOf(const StoredLife& life);
std::uint64_t checksumOf(const std::vector<StoredEpisode>& episodes);
std::uint64_t checksumOf(std::vector<StoredMeasure> measures);
std::uint64_t checksumOf(const StoredPreLearning& facts);
std::uint64_t checksumOf(const StoredPlan& plan);

/// The three checksums of a life as a store notes them: 48 digits.
std::string checksumText(std::uint64_t life, std::uint64_t episodes, std::uint64_t measures);
enum class ChecksumPart { Life, Episodes, Measures };
/// Throws Damaged if this part of the text differs from `sum`.
void compareChecksum(const std::string& text, ChecksumPart part, std::uint64_t sum, const std::string& what);

std::string hexText(std::uint64_t value);

}  // namespace surefoot
