// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/csv_export.h"

#include <fmt/format.h>

#include <filesystem>
#include <iterator>
#include <list>

#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

/// All files of an export; they get their names together at the end.
class Export {
 public:
  Export(const Store& store, std::string folder, std::string option, bool forSpreadsheets)
      : store_(store),
        folder_(std::move(folder)),
        option_(std::move(option)),
        mark_(forSpreadsheets ? "\xEF\xBB\xBF" : "") {}

  Status run() {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    for (const Status& s : {writeConditions(), writeLives(), writeEpisodes(), writeMeasures()})
      if (!s) return s;
    for (WholeFile& file : files_)
      if (const Status s = file.commit(); !s) return s;
    return Done{};
  }

 private:
  Result<WholeFile*> begin(const std::string& name, const std::string& header) {
    auto file = WholeFile::createNew(option_, (std::filesystem::path(folder_) / name).string());
    if (!file) return file.error();
    if (const Status s = file->append(mark_ + header); !s) return s.error();
    files_.push_back(std::move(*file));
    return &files_.back();
  }

  Status writeConditions() {
    const auto plan = store_.plan();
    if (!plan) return plan.error();
    conditions_ = plan->conditions;
    auto file = begin("conditions.csv", "condition,name,lives,goal_reward,step_time,text\n");
    if (!file) return file.error();
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
      const StoredCondition& c = conditions_[i];
      if (const Status s = (*file)->append(fmt::format("{},{},{},{},{},{}\n", i, csvCell(c.name), c.lives, c.goalReward,
                                                       c.stepTime, csvCell(c.text)));
          !s)
        return s;
    }
    return Done{};
  }

  Status writeLives() {
    auto lives = store_.lives();
    if (!lives) return lives.error();
    lives_ = std::move(*lives);
    auto file =
        begin("lives.csv", "condition,life,q_function,episodes,transitions,falls,states_outside,diverged,hash\n");
    if (!file) return file.error();
    for (const StoredLife& l : lives_) {
      const std::string q = l.qFunction < 0 ? "" : std::to_string(l.qFunction);
      if (const Status s =
              (*file)->append(fmt::format("{},{},{},{},{},{},{},{},{:016x}\n", l.condition, l.life, q, l.episodes,
                                          l.steps, l.falls, l.statesOutside, csvCell(l.diverged), l.hash));
          !s)
        return s;
    }
    return Done{};
  }

  Status writeEpisodes() {
    auto file = begin("episodes.csv", "condition,life,episode,transitions,reward,falls,ending,minutes\n");
    if (!file) return file.error();
    for (const StoredLife& l : lives_) {
      if (l.condition < 0 || l.condition >= static_cast<int>(conditions_.size()))
        return fileError(store_.path(), "it holds lives of a condition that it does not hold; the file is damaged.");
      const auto episodes = store_.episodes(l.condition, l.life);
      if (!episodes) return episodes.error();
      const double stepTime = conditions_[static_cast<std::size_t>(l.condition)].stepTime;
      fmt::memory_buffer out;
      std::int64_t number = 0, steps = 0;
      for (const StoredEpisode& e : *episodes) {
        steps += e.transitions;
        fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{},", l.condition, l.life, ++number, e.transitions,
                       e.reward, e.falls, endingName(e.ending));
        if (stepTime > 0) fmt::format_to(std::back_inserter(out), "{:.9g}", static_cast<double>(steps) * stepTime / 60);
        out.push_back('\n');
      }
      if (const Status s = (*file)->append({out.data(), out.size()}); !s) return s;
    }
    return Done{};
  }

  /// Only where a task measures anything.
  Status writeMeasures() {
    WholeFile* file = nullptr;
    for (const StoredLife& l : lives_) {
      const auto measures = store_.measures(l.condition, l.life);
      if (!measures) return measures.error();
      if (!file && !measures->empty()) {
        const auto begun = begin("measures.csv", "condition,life,episode,measure,value\n");
        if (!begun) return begun.error();
        file = *begun;
      }
      for (const StoredMeasure& m : *measures)
        if (const Status s = file->append(
                fmt::format("{},{},{},{},{:.9g}\n", l.condition, l.life, m.episode, csvCell(m.name), m.value));
            !s)
          return s;
    }
    return Done{};
  }

  const Store& store_;
  std::string folder_, option_, mark_;
  std::vector<StoredCondition> conditions_;
  std::vector<StoredLife> lives_;
  std::list<WholeFile> files_;
};

}  // namespace

Status exportCsv(const Store& store, const std::string& folder, const std::string& option, bool forSpreadsheets) {
  return Export(store, folder, option, forSpreadsheets).run();
}

}  // namespace surefoot
