// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/difference/log_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "core/files/read_file.h"
#include "core/text/number_text.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

using Cells = std::vector<std::string>;

Cells cellsOf(const std::string& line) {
  Cells cells(1);
  for (const char c : line)
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  return cells;
}

/// A log, line by line: as large as a disk holds.
class Log {
 public:
  explicit Log(const std::string& path) : path_(path), in_(path, std::ios::binary) {}

  /// The next row; none: the end.
  Result<std::optional<Cells>> next() {
    std::string line;
    ++line_;
    for (char c = 0; in_.get(c) && c != '\n';) {
      if (line.size() == kLongest) return refuse();
      line += c;
    }
    if (in_.bad()) return fileError(path_, "it cannot be read to its end.");
    if (in_.eof() && line.empty()) return std::optional<Cells>();
    if (in_.eof()) return fileError(path_, fmt::format("line {} is cut off.", line_));
    Cells cells = cellsOf(line);
    if (head.empty()) head = cells;
    if (cells.size() != head.size()) return refuse();
    return std::optional(std::move(cells));
  }
  /// A whole number of the row.
  Result<std::int64_t> number(const Cells& row, std::size_t column) const {
    const auto value = parseWhole(head[column], row[column], 0, 1'000'000'000'000'000);
    if (!value) return refuse();
    return static_cast<std::int64_t>(*value);
  }

  Cells head;

 private:
  static constexpr std::size_t kLongest = 1 << 16;
  Error refuse() const { return fileError(path_, fmt::format("line {} is no row of a log.", line_)); }

  std::string path_;
  std::ifstream in_;
  std::int64_t line_ = 0;
};

/// "life 1, episode 7" of a row, as numbers; a log begins with both columns.
Status place(const Log& log, const Cells& row, Parting& parting) {
  const auto life = log.number(row, 0), episode = log.number(row, 1);
  if (!life) return life.error();
  if (!episode) return episode.error();
  parting.life = *life, parting.episode = *episode;
  return Done{};
}

}  // namespace

Result<RecordDifference> logDifference(const std::string& first, const std::string& second,
                                       const std::atomic<bool>* interrupted) {
  Log a(first), b(second);
  RecordDifference found{.kind = RecordKind::Log};
  for (std::int64_t row = 0;; ++row) {  // the heads are row 0
    const auto x = a.next(), y = b.next();
    if (!x) return x.error();
    if (!y) return y.error();
    found.same = std::max<std::int64_t>(0, row - 1);
    if (!*x && !*y) return found;
    if (interrupted && *interrupted)
      return Error{fmt::format("interrupted after {} rows, which are the same.", found.same), ErrorKind::Interrupted};
    Parting parting;
    if (*x && *y) {
      const std::size_t columns = std::min((*x)->size(), (*y)->size());
      std::size_t at = 0;
      while (at < columns && (**x)[at] == (**y)[at]) ++at;
      if (at == columns && (*x)->size() == (*y)->size()) continue;
      const auto cell = [at](const Cells& cells) { return at < cells.size() ? cells[at] : std::string("nothing"); };
      parting.what = row == 0 ? "column" : a.head[at];
      parting.first = shortened(cell(**x)), parting.second = shortened(cell(**y));
    } else {
      parting.what = "the log", parting.first = *x ? "goes on" : "ends", parting.second = *y ? "goes on" : "ends";
    }
    if (row > 0)
      if (const Status s = *x ? place(a, **x, parting) : place(b, **y, parting); !s) return s.error();
    found.parting = std::move(parting);
    return found;
  }
}

}  // namespace surefoot
