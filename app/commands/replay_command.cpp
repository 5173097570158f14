// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot replay`: lives a journal again.
#include <fmt/format.h>

#include "app/commands/commands.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "app/reports/report.h"
#include "core/basics/version.h"
#include "core/life/lives_version.h"
#include "core/saved/journal.h"

namespace surefoot {

int replayCommand(const Registry& registry, const ReplayRequest& request) {
  if (request.file.empty()) return fail({"FILE: the name of a journal is needed."});
  const auto journal = readJournal(registry, request.file);
  if (!journal) return fail(journal.error());
  RunOptions options{};
  options.interrupted = &watchForInterrupt();
  const auto life = replay(registry, *journal, options);
  if (!life) {  // a command or a parameter that cannot be: the journal's fault
    const bool usage = life.error().kind == ErrorKind::Usage;
    return fail(usage ? fileError(request.file, life.error().message) : life.error());
  }
  const std::vector<LifeResult> lives = {*life};
  const int printed =
      print(request.json ? resultAsJson(journal->configuration, lives) : resultAsTable(journal->configuration, lives));
  if (printed != kDone) return printed;
  if (!life->unanswered.empty() && !watchForInterrupt()) return fail({life->unanswered, ErrorKind::Unanswered});
  const bool other = journal->livesVersion != kLivesVersion;
  const std::string lived = "Surefoot " + (journal->program.empty() ? "of another version" : journal->program);
  if (*options.interrupted && life->steps < journal->steps)
    return fail({fmt::format("interrupted at step {} of {}.", life->steps, journal->steps), ErrorKind::Interrupted});
  if (request.verify && !journal->sameAs(*life))
    return fail(
        {fmt::format("{}: {} episodes, {} falls, hash {:016x}; the journal says {}, {}, {:016x}, so it is not the "
                     "same life{}.",
                     request.file, life->totals.episodes, life->totals.falls, life->hash, journal->episodes,
                     journal->falls, journal->hash, other ? ", which " + lived + " lived" : ""),
         ErrorKind::Mismatch});
  if (other && !journal->sameAs(*life))
    tell(fmt::format("{} was lived by {}, and {} lives it otherwise: this is not the same life.", request.file, lived,
                     kVersion));
  return kDone;
}

}  // namespace surefoot
