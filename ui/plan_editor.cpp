// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan_editor.h"

#include <fmt/format.h>

#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>

#include "ui/condition_form.h"
#include "ui/experiment.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

namespace {
constexpr int kCheckAfter = 300;  // [ms] of no typing
}

PlanEditor::PlanEditor(Experiment& experiment, QWidget* parent)
    : QWidget(parent),
      experiment_(experiment),
      edit_(new QPlainTextEdit),
      verdict_(new QLabel),
      use_(new QPushButton(tr("Use this plan"))) {
  edit_->setAccessibleName(tr("Plan"));
  QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  fixed.setPixelSize(13);
  edit_->setFont(fixed);
  edit_->setFrameShape(QFrame::NoFrame);
  edit_->setLineWrapMode(QPlainTextEdit::NoWrap);
  verdict_->setFont(textFont(11));
  verdict_->setWordWrap(true);
  auto* live = new QPushButton(tr("Add what the Live page runs"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 4, 12, 12);
  auto* form = new ConditionForm(experiment.registry());
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(360);
  scroll->setWidget(form);
  auto* upper = new QHBoxLayout;
  upper->addWidget(edit_, 1);
  upper->addWidget(scroll);
  column->addLayout(upper, 1);
  connect(form, &ConditionForm::addAsked, this, [this, form] {
    const auto toml = form->toml();
    if (toml)
      addCondition(*toml);
    else
      verdict_->setText(toText(toml.error().message));
  });
  auto* row = new QHBoxLayout;
  row->addWidget(verdict_, 1);
  row->addWidget(live);
  row->addWidget(use_);
  column->addLayout(row);
  auto* pause = new QTimer(this);
  pause->setSingleShot(true);
  pause->setInterval(kCheckAfter);
  connect(edit_, &QPlainTextEdit::textChanged, pause, qOverload<>(&QTimer::start));
  connect(pause, &QTimer::timeout, this, &PlanEditor::check);
  connect(use_, &QPushButton::clicked, this, &PlanEditor::use);
  connect(live, &QPushButton::clicked, this, &PlanEditor::liveConditionAsked);
  connect(&experiment_, &Experiment::planChanged, this, [this] {
    if (text() != toText(experiment_.text())) setText(toText(experiment_.text()));
  });
}

QString PlanEditor::text() const {
  return edit_->toPlainText();
}

void PlanEditor::setText(const QString& text) {
  edit_->setPlainText(text);
  check();
}

void PlanEditor::addCondition(const std::string& toml) {
  QString text = edit_->toPlainText();
  if (!text.isEmpty() && !text.endsWith('\n')) text += '\n';
  setText(text + '\n' + toText(toml));
  edit_->moveCursor(QTextCursor::End);
}

void PlanEditor::check() {
  const Result<Plan> plan = experiment_.parse(text().toStdString());
  use_->setEnabled(static_cast<bool>(plan));
  if (plan)
    verdict_->setText(tr("%n conditions", nullptr, static_cast<int>(plan->conditions.size())) +
                      tr(", %1 lives each").arg(plan->lives));
  else
    verdict_->setText(toText(plan.error().message));
}

void PlanEditor::use() {
  if (const Status s = experiment_.setText(text().toStdString()); !s)
    verdict_->setText(toText(s.error().message));
  else
    Q_EMIT used();
}

std::string conditionToml(const Configuration& c, const Configuration& defaults) {
  std::string toml = fmt::format("[[condition]]\nname = \"live: {}\"\n", c.names.policy);
  const auto line = [&](const char* key, const std::string& value) {
    if (!value.empty()) toml += fmt::format("{} = \"{}\"\n", key, value);
  };
  line("environment", c.names.environment);
  line("preset", c.names.preset);
  line("scenario", c.names.scenario);
  line("agent", c.names.agent);
  line("features", c.names.features);
  line("policy", c.names.policy);
  toml += "minutes = 9\n";
  for (const auto& entry : c.parameters.all()) {
    const Parameters::Entry* usual = defaults.parameters.find(entry.parameter.key);
    if (usual && usual->value == entry.value) continue;
    const bool choice = !entry.parameter.choices.empty();
    toml += choice ? fmt::format("set.{} = \"{}\"\n", entry.parameter.key, formatValue(entry.parameter, entry.value))
                   : fmt::format("set.{} = {}\n", entry.parameter.key, formatValue(entry.parameter, entry.value));
  }
  return toml;
}

}  // namespace surefoot
