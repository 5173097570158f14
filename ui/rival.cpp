// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/rival.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

#include "core/text.h"
#include "ui/combo.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"
#include "ui/world_view.h"

namespace surefoot {

namespace {
constexpr int kCombos = 36, kHead = kCombos + 32;  // [px]

/// Something else than what the first one does.
std::string otherPolicy(const std::string& policy) {
  return policy == "softmax" ? "epsilon-greedy" : "softmax";
}
}  // namespace

Rival::Rival(Session& first, QWidget* parent)
    : QWidget(parent),
      first_(first),
      policy_(otherPolicy(first.configuration().names.policy)),
      agent_(first.configuration().names.agent),
      session_(std::make_unique<Session>(first.registry(), configurationLikeFirst(), false)),
      agents_(new Combo(tr("Learning rule of the second"), this)),
      policies_(new Combo(tr("Policy of the second"), this)) {
  world_ = new WorldView(*session_, this);
  world_->setAccessibleName(tr("World of the second"));
  for (const auto& entry : first.registry().agents)
    if (entry.name != "scripted" || first.task().handMade) agents_->addItem(toText(entry.title), toText(entry.name));
  for (const auto& entry : first.registry().policies) policies_->addItem(toText(entry.title), toText(entry.name));
  agents_->setCurrentIndex(agents_->findData(toText(agent_)));
  policies_->setCurrentIndex(policies_->findData(toText(policy_)));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(12, 4, 12, 4);
  agents_->setFixedSize(118, 28);
  policies_->setFixedSize(112, 28);
  head->addWidget(agents_);
  head->addWidget(policies_);
  head->addStretch(1);
  column->addLayout(head);
  column->addSpacing(kHead - kCombos);
  column->addWidget(world_, 1);
  for (QComboBox* combo : {agents_, policies_}) connect(combo, &QComboBox::activated, this, &Rival::choose);
  connect(&first_, &Session::stateChanged, this, &Rival::follow);
  connect(&first_, &Session::configurationChanged, this, &Rival::followParameters);
  connect(&first_, &Session::lifeReplaced, this, &Rival::startAgain);
  connect(session_.get(), &Session::frame, this, [this] { update(0, 0, width(), kHead); });
  connect(session_.get(), &Session::refused, this, &Rival::refused);
  follow();
}

Configuration Rival::configurationLikeFirst() const {
  Names names = first_.configuration().names;
  names.agent = agent_;
  names.policy = policy_;
  auto own = first_.configurationUnder(names);
  return own ? std::move(*own) : first_.configuration();
}

void Rival::startAgain() {
  if (const Status s = session_->begin(configurationLikeFirst()); !s) Q_EMIT refused(toText(s.error().message));
  follow();
}

void Rival::follow() {
  if (session_->turbo() != first_.turbo()) session_->setTurbo(first_.turbo());
  if (session_->pace() != first_.pace()) session_->setPace(first_.pace());
  if (session_->running() != first_.running()) session_->setRunning(first_.running());
}

void Rival::followParameters() {
  for (const auto& entry : first_.configuration().parameters.all()) {
    const Parameters::Entry* own = session_->configuration().parameters.find(entry.parameter.key);
    if (own && own->value != entry.value && entry.parameter.when != When::NewTable)
      static_cast<void>(static_cast<bool>(session_->setParameter(entry.parameter.key, entry.value)));
  }
}

void Rival::choose() {
  const std::string agent = agents_->currentData().toString().toStdString();
  policy_ = policies_->currentData().toString().toStdString();
  if (agent == agent_) return session_->setPolicy(policy_);
  agent_ = agent;
  startAgain();
}

void Rival::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  p.fillRect(rect(), t.paper);
  const CurvePoint now = session_->latest();
  const QString falls = toText(countText(static_cast<double>(now.falls)));
  p.setFont(textFont(24, 500));
  p.setPen(t.fallText);
  const double baseline = kHead - 6;
  drawSymbol(p, 14, baseline, falls);
  const double right = 14 + symbolWidth(p.font(), falls) + 8;
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  drawSymbol(p, right, baseline, tr("falls in %1 episodes").arg(toText(countText(static_cast<double>(now.episode)))));
}

}  // namespace surefoot
