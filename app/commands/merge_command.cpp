// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot merge`: the parts of an experiment into one store.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/commands/commands.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "core/files/limited_json.h"
#include "core/files/read_file.h"
#include "core/life/lives_version.h"
#include "core/store/store_lock.h"

namespace surefoot {

namespace {

/// All parts belong to one plan and one division into shards, and none is missing.
Status checkParts(const std::vector<StoredPlan>& plans, const std::vector<std::string>& paths) {
  for (std::size_t i = 1; i < plans.size(); ++i) {
    if (const Status s = checkSamePlan(plans[i], plans[0], paths[i]); !s) return s;
    if (plans[i].conditions[0].lives != plans[0].conditions[0].lives)
      return Error{fmt::format("{}: it has {} lives a condition, and {} has {}.", paths[i],
                               plans[i].conditions[0].lives, paths[0], plans[0].conditions[0].lives),
                   ErrorKind::File};
    if (plans[i].shards != plans[0].shards)
      return Error{fmt::format("{}: it is one of {} shards, and {} is one of {}.", paths[i], plans[i].shards, paths[0],
                               plans[0].shards),
                   ErrorKind::File};
  }
  for (int shard = 1; shard <= plans[0].shards; ++shard) {
    const auto count = std::count_if(plans.begin(), plans.end(), [=](const StoredPlan& p) { return p.shard == shard; });
    if (count != 1)
      return Error{fmt::format("PARTS: shard {} of {} is given {}.", shard, plans[0].shards,
                               count == 0 ? "not at all" : "more than once"),
                   ErrorKind::File};
  }
  return Done{};
}

/// All lives come from versions of the program that give the same lives; each life must name its version.
Status checkVersions(const std::vector<Store>& parts) {
  std::optional<int> version;
  for (const Store& part : parts) {
    const auto lives = part.lives();
    if (!lives) return lives.error();
    for (const StoredLife& l : *lives) {
      if (l.livesVersion == kLivesVersionUnknown || version.value_or(l.livesVersion) != l.livesVersion)
        return fileError(part.path(),
                         l.livesVersion == kLivesVersionUnknown
                             ? "it does not say which lives the version of Surefoot lived that wrote it, so they may "
                               "not belong to the others. --other-version joins them all the same."
                             : fmt::format("a version of Surefoot wrote it that lives lives {}, and {} was written by "
                                           "one of lives {}. --other-version joins them all the same.",
                                           l.livesVersion, parts[0].path(), *version));
      version = l.livesVersion;
    }
  }
  return Done{};
}

/// The Q-functions that lives begin with or have as guardian, from the first part that holds them.
Status addQFunctions(const std::vector<Store>& parts, StoredPlan& plan) {
  for (const StoredCondition& c : plan.conditions) {
    const auto json = parseJson(c.configuration);
    for (const auto& which : {"/began_with/content"_json_pointer, "/guardian/content"_json_pointer}) {
      const auto content = json.value(which, nlohmann::json());
      for (const Store& part : parts) {
        if (!content.is_string() || plan.qFunctions.contains(content)) break;
        auto q = part.qFunction(content);
        if (!q) return q.error();
        if (*q) plan.qFunctions[content] = std::move(*q);
      }
    }
  }
  return Done{};
}

Result<Store> join(const MergeRequest& request, const std::string& path) {
  std::vector<Store> parts;
  std::vector<StoredPlan> plans;
  for (const std::string& file : request.parts) {
    auto part = Store::open(file, &watchForInterrupt());
    if (!part) return part.error();
    auto plan = part->plan();
    if (!plan) return plan.error();
    const auto lives = part->lives();
    if (!lives) return lives.error();
    const std::size_t all = plan->conditions.size() * static_cast<std::size_t>(plan->conditions[0].lives);
    const auto shard = static_cast<std::size_t>(plan->shard), shards = static_cast<std::size_t>(plan->shards);
    const std::size_t planned = all / shards + (shard <= all % shards);
    if (lives->size() != planned)
      return Error{
          fmt::format("{}: it holds {} of its {} lives; finish it with --resume first.", file, lives->size(), planned),
          ErrorKind::File};
    parts.push_back(std::move(*part));
    plans.push_back(std::move(*plan));
  }
  if (const Status s = checkParts(plans, request.parts); !s) return s.error();
  if (const Status s = checkVersions(parts); !s && !request.otherVersion) return s.error();
  StoredPlan whole = plans[0];
  whole.shard = whole.shards = 1;
  if (const Status s = addQFunctions(parts, whole); !s) return s.error();
  auto store = Store::create(path, whole);
  if (!store) return store;
  for (const Store& part : parts)
    if (const Status s = store->add(part); !s) return s.error();
  for (const Store& part : parts) tellNote(part);
  return store;
}

/// Removes a part, with all files that SQLite and the lock may have left beside it.
void removePart(const std::string& path) {
  std::error_code ignored;
  for (const char* rest : {"", "-wal", "-shm", "-journal", "-lock"}) std::filesystem::remove(path + rest, ignored);
}

}  // namespace

int mergeCommand(const MergeRequest& request) {
  if (request.parts.empty()) return fail({"PARTS: the stores of all shards are needed."});
  if (!request.out) return fail({"--out: the file to write is needed."});
  if (!Store::missing(*request.out))
    return fail({fmt::format("{}: it exists already; name another file.", *request.out), ErrorKind::File});

  // The result appears complete: it is made under another name and then gets its own. A process that was killed leaves
  // its part, and the next one removes it.
  const std::string meanwhile = *request.out + ".merging";
  if (StoreLock::isHeld(meanwhile)) return fail(inUse(*request.out));
  removePart(meanwhile);
  std::error_code failed;
  const auto hash = [&]() -> Result<std::uint64_t> {
    const auto store = join(request, meanwhile);
    if (!store) return store.error();
    return store->contentHash();
  }();
  if (hash) std::filesystem::create_hard_link(meanwhile, *request.out, failed);  // a hard link never replaces a file
  if (failed && failed != std::errc::file_exists && Store::missing(*request.out))
    std::filesystem::rename(meanwhile, *request.out, failed);  // the file system has no hard links
  removePart(meanwhile);
  if (hash && !failed)
    return print(fmt::format("{}: {} parts, content {:016x}\n", *request.out, request.parts.size(), *hash));
  return fail(hash
                  ? Error{fmt::format("{}: it cannot be written: {}.", *request.out, failed.message()), ErrorKind::File}
                  : hash.error());
}

}  // namespace surefoot
