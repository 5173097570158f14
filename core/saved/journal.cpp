// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/saved/journal.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "core/basics/typed_json.h"
#include "core/basics/version.h"
#include "core/experiment/configuration_json.h"
#include "core/files/limited_json.h"
#include "core/files/read_file.h"
#include "core/life/lives_version.h"
#include "core/saved/q_file.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

constexpr const char* kJournalFormat = "1.0";

std::string hashText(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

/// A line as a JSON object; null if it is none.
Json parseLine(const std::string& line) {
  constexpr std::size_t kLongest = 1 << 20;
  Json json = parseJson(line, kLongest);
  return json.is_object() ? json : Json();
}

bool isInteger(const Json& json, const char* key) {
  return json.contains(key) && json[key].is_number_integer() && json[key].get<std::int64_t>() >= 0;
}
bool isText(const Json& json, const char* key) {
  return json.contains(key) && json[key].is_string();
}

/// The path of a file named in a journal: old journals have its whole path, newer ones only its name.
std::string placeOf(const std::string& file, const std::string& journal) {
  std::error_code ignored;
  const auto beside = std::filesystem::path(journal).parent_path() / std::filesystem::path(file).filename();
  return std::filesystem::exists(file, ignored) ? file : beside.string();
}

/// Reads the Q-function that the life "began with", or another one that it needs, if the file still has the same
/// content.
Result<std::shared_ptr<const TensorFile>> read(const Json& json, const std::string& name, const char* beganWith) {
  const char* kind = isText(json, "content") ? "content" : "hash";  // hash of the values; formerly of the file
  if (!json.is_object() || !isText(json, "file") || !isText(json, kind))
    return fileError(name, "its first line names what was loaded, but not how.");
  const std::string place = placeOf(json["file"].get<std::string>(), name);
  auto file = readQFile(place);
  if (!file)
    return fileError(
        name,
        fmt::format("the life {} {}, which is looked for beside the journal and in the current folder: {}", beganWith,
                    shortened(std::filesystem::path(place).filename().string()), file.error().message));
  const std::string now = std::string_view(kind) == "content" ? contentOf(**file) : wholeHashOf(**file);
  if (now == json[kind]) return file;
  return fileError(name, fmt::format("the life {} {}, whose hash was {} and now is {}.", beganWith, (*file)->name,
                                     shortened(json[kind].get<std::string>()), now));
}

Result<Journal> parseHeader(const Registry& registry, const Json& header, const std::string& name) {
  if (!isText(header, "surefoot_journal")) return fileError(name, "this is no journal of Surefoot.");
  const std::string format = header["surefoot_journal"].get<std::string>();
  if (!format.starts_with("1."))
    return fileError(name, fmt::format("its format is \"{}\"; this version of Surefoot reads 1.x.", shortened(format)));
  if (!header.contains("configuration") || !header.contains("seed") || !header["seed"].is_number_unsigned() ||
      !isInteger(header, "life") || header["life"].get<std::int64_t>() > 1'000'000)
    return fileError(name, "its first line lacks the configuration, the seed or the number of the life.");
  auto configuration = configurationFromJson(registry, header["configuration"], name);
  if (!configuration) return configuration.error();
  Journal journal{.configuration = std::move(*configuration), .life = header["life"].get<int>(), .steps = 0, .hash = 0};
  journal.configuration.seed = header["seed"].get<std::uint64_t>();
  if (isInteger(header, "lives_version")) journal.livesVersion = header["lives_version"].get<int>();
  if (isText(header, "program")) journal.program = shortened(header["program"].get<std::string>());
  if (header.contains("load") && !header["load"].is_null()) {
    auto file = read(header["load"], name, "began with");
    if (!file) return file.error();
    beginWith(journal.configuration, std::move(*file));
  }
  if (header.contains("guardian")) {
    auto file = read(header["guardian"], name, "was guarded by");
    if (!file) return file.error();
    journal.configuration.teacher = std::move(*file);
  }
  return journal;
}

/// The last line: {"end": {"step": …, "hash": "…", "complete": true}}.
Status parseEnd(const Json& end, const std::string& name, Journal& journal) {
  if (!end.is_object() || !isInteger(end, "step") || !isInteger(end, "episodes") || !isInteger(end, "falls") ||
      !isText(end, "hash"))
    return fileError(name, "its last line lacks the step, the episodes, the falls or the hash of the end.");
  if (end.contains("changes_left_out"))
    return fileError(name, "more was done to the life than a journal holds; it cannot be lived again.");
  const std::string hash = end["hash"].get<std::string>();
  const auto [last, code] = std::from_chars(hash.data(), hash.data() + hash.size(), journal.hash, 16);
  if (code != std::errc{} || last != hash.data() + hash.size())
    return fileError(name, fmt::format("\"{}\" is no hash.", shortened(hash)));
  journal.steps = end["step"].get<std::int64_t>();
  if (journal.steps > kMostLifeSteps || end["episodes"].get<std::int64_t>() > journal.steps)
    return fileError(name, "its last line counts more steps or episodes than a life can have.");
  journal.episodes = end["episodes"].get<std::int64_t>();
  journal.falls = end["falls"].get<std::int64_t>();
  return Done{};
}

}  // namespace

std::string journalOf(const Configuration& c, const LifeResult& life) {
  Json header = {{"surefoot_journal", kJournalFormat},
                 {"program", kVersion},
                 {"lives_version", kLivesVersion},
                 {"configuration", Json(configurationAsJson(c))},
                 {"seed", c.seed},
                 {"life", life.life},
                 {"load", nullptr}};
  if (c.beganWith.is_object()) {
    const char* kind = c.beganWith.contains("content") ? "content" : "hash";
    header["load"] = {{"file", c.beganWith["file"]}, {kind, c.beganWith[kind]}};
  }
  if (c.teacher)
    header["guardian"] = {{"file", std::filesystem::path(c.teacher->name).filename().string()},
                          {"content", contentOf(*c.teacher)}};
  std::string text = jsonText(header) + "\n";
  for (const Change& change : life.changes)
    text += jsonText(Json({{"step", change.step}, {"key", change.key}, {"value", change.after}})) + "\n";
  Json end = {{"step", life.steps},
              {"hash", hashText(life.hash)},
              {"episodes", life.totals.episodes},
              {"falls", life.totals.falls}};
  if (life.changesLeftOut) end["changes_left_out"] = true;
  return text + jsonText(Json({{"end", end}})) + "\n";
}

Result<Journal> parseJournal(const Registry& registry, const std::string& text, const std::string& name) {
  std::istringstream in(text);
  std::string line;
  std::getline(in, line);
  auto journal = parseHeader(registry, parseLine(line), name);
  if (!journal) return journal.error();
  for (int number = 2; std::getline(in, line); ++number) {
    const Json json = parseLine(line);
    if (json.is_object() && json.contains("end")) {
      if (const Status s = parseEnd(json["end"], name, *journal); !s) return s.error();
      return journal;
    }
    if (!json.is_object() || !isInteger(json, "step") || !isText(json, "key") || !isText(json, "value"))
      return fileError(name, fmt::format("line {} is no command.", number));
    const CommandText command{json["step"].get<std::int64_t>(), json["key"].get<std::string>(),
                              json["value"].get<std::string>()};
    if (command.key == kOtherLives)
      return fileError(name, fmt::format("from step {} on the life was lived by another version of Surefoot; it cannot "
                                         "be lived again.",
                                         command.step));
    auto& commands = journal->configuration.commands;
    if (!commands.empty() && commands.back().step > command.step)
      return fileError(name, fmt::format("line {} goes back in time.", number));
    if (commands.size() == kMostChanges)
      return fileError(name, fmt::format("it has more than {} commands, which no journal of ours has.", kMostChanges));
    commands.push_back(command);
  }
  return fileError(name, "it is cut off: the line of the end is missing.");
}

Result<Journal> readJournal(const Registry& registry, const std::string& path) {
  const auto text = readText(path);
  if (!text) return text.error();
  return parseJournal(registry, *text, path);
}

namespace {

/// What was done to a saved life, but for the step to another version: it is lived anew.
std::vector<Change> changesOf(const Resumed& saved) {
  std::vector<Change> changes = saved.life->changes();
  std::erase_if(changes, [](const Change& c) { return c.key == kOtherLives; });
  return changes;
}

void addCommandsToCome(const Resumed& saved, std::vector<CommandText>& commands) {
  for (const CommandText& command : saved.configuration.commands)
    if (command.step >= saved.life->steps()) commands.push_back(command);
}

}  // namespace

Result<Journal> journalOf(const Registry& registry, const Resumed& saved, const std::string& name) {
  LifeResult result = summarise(*saved.life, 0, 0.0);
  result.changes = changesOf(saved);
  auto journal = parseJournal(registry, journalOf(saved.configuration, result), name);
  if (journal) addCommandsToCome(saved, journal->configuration.commands);
  return journal;
}

Journal toldTo(const Resumed& saved) {
  const Life& life = *saved.life;
  Journal journal{.configuration = saved.configuration, .steps = life.steps(), .hash = life.hash()};
  auto& commands = journal.configuration.commands = {};
  for (const Change& change : changesOf(saved)) commands.push_back({change.step, change.key, change.after});
  addCommandsToCome(saved, commands);
  journal.episodes = life.log().totals().episodes, journal.falls = life.log().totals().falls;
  journal.livesVersion = kLivesVersion;
  return journal;
}

Result<LifeResult> replay(const Registry& registry, const Journal& journal, const RunOptions& options) {
  Configuration c = journal.configuration;
  c.lives = 1;
  RunOptions once = options;
  once.make = [&](int) { return makeLife(registry, c, journal.life, options.keepRows, journal.steps); };
  auto lives = runLives(registry, c, once);
  if (!lives) return lives.error();
  if (lives->empty()) return Error{"interrupted before it began.", ErrorKind::Interrupted};
  return std::move(lives->front());
}

}  // namespace surefoot
