// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the Live page that goes on from a moment that was lived before.
#include "ui/live/live_page.h"
#include "ui/live/rival.h"
#include "ui/session/session.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

void LivePage::goOn() {
  auto until = session_.looking().momentShown();
  if (!until) return Q_EMIT refused(toText(until.error().message));
  const auto steps = until->actions.size();
  if (const Status s = session_.life().goOn(std::move(*until)); !s) return Q_EMIT refused(toText(s.error().message));
  session_.looking().wentOn();
  Q_EMIT told(
      tr("The learner goes on %1 steps into that episode, with what it knows now; the journal says so.").arg(steps));
}

void LivePage::whatIf(const std::string& agent, const std::string& policy) {
  auto until = session_.looking().momentShown();
  if (!until) return Q_EMIT refused(toText(until.error().message));
  session_.files().copyFunction([this, agent, policy, until = std::move(*until)](const auto& file) {
    if (!file) return Q_EMIT refused(toText(file.error().message));
    Q_EMIT comparingAsked();
    if (!rival_) return;
    rival_->startIn(*file, until, agent, policy, [this, until] {
      if (const Status s = session_.life().goOn(until); !s) return Q_EMIT refused(toText(s.error().message));
      session_.looking().wentOn();
    });
  });
}

}  // namespace surefoot
