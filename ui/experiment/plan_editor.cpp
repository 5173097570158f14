// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/plan_editor.h"

#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>

#include "core/plans/plan_writing.h"
#include "ui/experiment/experiment.h"
#include "ui/experiment/plans/condition_form.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {
constexpr int kCheckAfter = 300;                    // [ms] of no typing
constexpr std::chrono::milliseconds kPatience(95);  // the window waits this long, so that quick work is done at once
}  // namespace

PlanEditor::PlanEditor(Experiment& experiment, QWidget* parent)
    : QWidget(parent),
      experiment_(experiment),
      edit_(new QPlainTextEdit),
      form_(new ConditionForm(experiment.registry())),
      verdict_(new QLabel),
      use_(new QPushButton(tr("Use this plan"))) {
  edit_->setAccessibleName(tr("Plan"));
  edit_->setFrameShape(QFrame::NoFrame);
  edit_->setLineWrapMode(QPlainTextEdit::NoWrap);
  verdict_->setWordWrap(true);
  verdict_->setTextFormat(Qt::PlainText);
  auto* live = new QPushButton(tr("Add what the Live page runs"));
  auto* column = new QVBoxLayout(this);
  auto* heading = new QLabel(tr("A new condition; it begins as the first one"));
  auto* addButton = new QPushButton(tr("Add the condition"));
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  whenScaled(this, [this, column, scroll, heading] {
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPixelSize(scaled(13));
    edit_->setFont(fixed);
    verdict_->setFont(scaledFont(11));
    heading->setFont(scaledFont(13, 500));
    heading->setIndent(scaled(12));
    column->setContentsMargins(scaled({12, 4, 12, 12}));
    scroll->setFixedWidth(scaled(360));
  });
  scroll->setWidget(form_);
  auto* upper = new QHBoxLayout;
  upper->addWidget(edit_, 1);
  auto* beside = new QVBoxLayout;
  beside->addWidget(heading);
  beside->addWidget(scroll, 1);
  beside->addWidget(addButton, 0, Qt::AlignRight);
  upper->addLayout(beside);
  column->addLayout(upper, 1);
  connect(addButton, &QPushButton::clicked, this, [this] {
    const auto toml = form_->toml();
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
  connect(&checking_, &Background::failed, this, &PlanEditor::say);
  auto* pause = new QTimer(this);
  pause->setSingleShot(true);
  pause->setInterval(kCheckAfter);
  connect(edit_, &QPlainTextEdit::textChanged, pause, qOverload<>(&QTimer::start));
  connect(pause, &QTimer::timeout, this, &PlanEditor::check);
  connect(use_, &QPushButton::clicked, this, &PlanEditor::use);
  connect(live, &QPushButton::clicked, this, &PlanEditor::liveConditionAsked);
  connect(&experiment_, &Experiment::planChanged, this, [this] {
    // Edits that are not used yet stay as long as the plan does not change; after a change, undo brings them back.
    const QString now = toText(experiment_.text());
    if (std::exchange(used_, now) == now && !text().isEmpty()) return;
    form_->forget();
    setText(now);
  });
}

QString PlanEditor::text() const {
  return edit_->toPlainText();
}

void PlanEditor::setText(const QString& text) {
  if (this->text() != text) {
    QTextCursor cursor(edit_->document());
    cursor.select(QTextCursor::Document);
    cursor.insertText(text);
  }
  check();
}

bool PlanEditor::hasEdits() const {
  return !text().isEmpty() && text() != used_;
}

std::string PlanEditor::path() const {
  return experiment_.path().empty() ? "plan" : experiment_.path();
}

void PlanEditor::addCondition(const std::string& toml) {
  add([toml](const Result<Plan>&) { return toml; });
}

void PlanEditor::addConfiguration(const Configuration& configuration) {
  add([configuration, &registry = experiment_.registry()](const Result<Plan>& now) {
    const std::string name = "live: " + configuration.names.policy;
    return conditionToml(registry, configuration, now ? freeName(*now, name) : name);
  });
}

// If the plan runs without the block, it must run with it; a plan that does not run takes any block.
void PlanEditor::add(MakeBlock block) {
  struct Made {
    std::string block, refusal;
  };
  auto made = std::make_shared<Made>();
  const QString now = text();
  checking_.start(
      [made, block = std::move(block), &registry = experiment_.registry(), plan = now.toStdString(),
       path = path()](const std::atomic<bool>& interrupted) {
        PlanChanges nothing;
        nothing.interrupted = &interrupted;
        const auto before = parsePlan(registry, plan, path, nothing);
        const auto toml = block(before);
        if (!toml) {
          made->refusal = toml.error().message;
          return;
        }
        made->block = (plan.empty() ? "" : plan.ends_with('\n') ? "\n" : "\n\n") + *toml;
        const auto after = parsePlan(registry, plan + made->block, path, nothing);
        if (before && !after) made->refusal = after.error().message;
      },
      [this, made, now] {
        if (!made->refusal.empty()) return say(tr("It is not added: %1").arg(toText(made->refusal)));
        if (text() != now) return say(tr("The plan was changed meanwhile; add it again."));
        QTextCursor cursor(edit_->document());
        cursor.movePosition(QTextCursor::End);
        cursor.insertText(toText(made->block));
        edit_->moveCursor(QTextCursor::End);
        check();
      },
      kPatience);
}

void PlanEditor::say(const QString& sentence) {
  verdict_->setText(sentence);
}

void PlanEditor::check() {
  auto made = std::make_shared<std::optional<Result<Plan>>>();
  checking_.start(
      [made, &registry = experiment_.registry(), plan = text().toStdString(),
       path = path()](const std::atomic<bool>& interrupted) {
        PlanChanges nothing;
        nothing.interrupted = &interrupted;
        made->emplace(parsePlan(registry, plan, path, nothing));
      },
      [this, made] {
        const Result<Plan>& plan = **made;
        use_->setEnabled(static_cast<bool>(plan));
        if (plan && !plan->conditions.empty()) form_->beginAs(plan->conditions.front());
        say(plan ? tr("%n conditions", nullptr, static_cast<int>(plan->conditions.size())) +
                       tr(", %1 each").arg(livesText(plan->lives))
                 : toText(plan.error().message));
      },
      kPatience);
  if (!checking_.busy()) return;
  use_->setEnabled(false);
  say(tr("It is being checked …"));
}

void PlanEditor::use() {
  if (const Status s = experiment_.setText(text().toStdString()); !s)
    verdict_->setText(toText(s.error().message));
  else
    Q_EMIT used();
}

}  // namespace surefoot

#include "moc_plan_editor.cpp"
