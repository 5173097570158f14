// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robustness/robustness_form.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "core/environment_library.h"
#include "ui/controls/combo.h"
#include "ui/controls/labels.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/running/running_life.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/ask_for_file.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {

constexpr int kField = 88;      // [px]
constexpr int kStretching = 8;  // the column behind all fields
/// From what hardly moves a pendulum to what throws LEO over.
constexpr const char* kUsualPushes = "0;0.02;0.05;0.1;0.2;0.5;1;2;5";

/// The text of a field; nothing if it is empty, or there is no such field.
std::optional<std::string> textIn(const QLineEdit* field) {
  const QString text = field ? field->text().trimmed() : QString();
  return text.isEmpty() ? std::nullopt : std::optional(typedNumbers(text));
}

}  // namespace

RobustnessForm::RobustnessForm(const RunningLife& life, QWidget* parent)
    : QWidget(parent),
      grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setColumnStretch(kStretching, 1);
  whenScaled(this, [this] {
    grid_->setHorizontalSpacing(scaled(12));
    grid_->setVerticalSpacing(scaled(8));
  });
  if (life.task().stepTime) {
    const auto pushed = makeEnvironment(life.registry(), life.configuration());
    const bool body = pushed && (*pushed)->push(0.0);
    push_ = addField(
        tr("Pushes, N s"), tr("Pushes in newton seconds"), localNumbers(std::string(body ? kUsualPushes : "0")),
        tr("Impulses: a list, 0;0.05;0.1, or a range, 0..0.2:9, nine from 0 to 0.2. Negative ones push to the "
           "left."),
        {0, 0, 3});
    pushAt_ = addField(tr("pushed at, s"), tr("Time of the push in seconds"), QStringLiteral("0..5"),
                       tr("A time, or two with .. between them: every start draws its own between these."), {0, 4});
    seconds_ = addField(tr("followed for, s"), tr("Seconds after the push"), QStringLiteral("10"),
                        tr("From the push on: falls in this time are counted."), {0, 6});
  }
  addModels(life);
  addPolicy(life);
  addSecond();
}

QLineEdit* RobustnessForm::addField(const QString& label, const QString& name, const QString& text, const QString& tip,
                                    Place place) {
  auto* field = new QLineEdit(text);
  field->setAccessibleName(name);
  field->setToolTip(tipText(tip));
  whenScaled(field, [field] { field->setMinimumWidth(scaled(kField)); });
  grid_->addWidget(new QLabel(label), place.row, place.column);
  grid_->addWidget(field, place.row, place.column + 1, 1, place.span);
  connect(field, &QLineEdit::textEdited, this, &RobustnessForm::edited);
  return field;
}

void RobustnessForm::addModels(const RunningLife& life) {
  const auto scenarios = scenariosOf(life.registry(), life.configuration().names.environment);
  if (!scenarios.empty()) {
    scenario_ = new Combo(tr("Models"));
    scenario_->addItem(tr("as it is now"));
    scenario_->addItem(tr("all scenarios"), QStringLiteral("all"));
    for (const AssignmentEntry* entry : scenarios) scenario_->addItem(fromCore(entry->title), toText(entry->name));
    scenario_->setCurrentIndex(1);
    connect(scenario_, &QComboBox::activated, this, &RobustnessForm::edited);
    grid_->addWidget(new QLabel(tr("Models")), 1, 0);
    grid_->addWidget(scenario_, 1, 1, 1, 3);
  }
  settings_ = addField(tr("with"), tr("Parameters of the models"), {},
                       tr("Parameters of the environment and their values, with blanks between them: "
                          "environment.friction=0..0.1:5 environment.damping=0.04;0.08. Every value is combined with "
                          "every other and with every scenario."),
                       {1, 4, 3});
  settings_->setPlaceholderText(tr("environment.KEY=VALUES …"));
}

void RobustnessForm::addPolicy(const RunningLife& life) {
  policy_ = new Combo(tr("Policy"));
  for (const PolicyEntry& entry : life.registry().policies) policy_->addItem(fromCore(entry.title), toText(entry.name));
  policy_->setPolicyMarkers();
  policy_->choose("greedy");
  connect(policy_, &QComboBox::activated, this, &RobustnessForm::edited);
  grid_->addWidget(new QLabel(tr("Policy")), 2, 0);
  grid_->addWidget(policy_, 2, 1);
  starts_ = addField(tr("starts a cell"), tr("Starts of every cell"), QStringLiteral("100"),
                     tr("Trials of every push on every model. Trial 1 starts alike in every cell, and so on."), {2, 2});
  seed_ = addField(tr("seed"), tr("Seed of the starts"), QStringLiteral("1"),
                   tr("Starts, times of pushes and the policy's draws come from it."), {2, 4});
}

void RobustnessForm::addSecond() {
  beside_ = new OneLine(13, this);
  auto* choose = new QPushButton(tr("A second Q-function …"));
  choose->setAutoDefault(false);
  choose->setToolTip(tipText(tr("Of the same environment; it is tried from the same starts on the same models.")));
  remove_ = new QPushButton(tr("Without it"));
  remove_->setAutoDefault(false);
  auto* row = new QHBoxLayout;
  row->addWidget(choose);
  row->addWidget(remove_);
  row->addWidget(beside_, 1);
  whenScaled(this, [row] { row->setSpacing(scaled(8)); });
  grid_->addWidget(new QLabel(tr("Beside it")), 3, 0);
  grid_->addLayout(row, 3, 1, 1, kStretching);
  connect(choose, &QPushButton::clicked, this, [this] {
    askForFile(this, tr("A second Q-function"), tr("Q-functions (*.safetensors *.surefoot);;All files (*)"),
               [this](const QString& path) {
                 setSecond(path);
                 Q_EMIT secondChosen(path);
               });
  });
  connect(remove_, &QPushButton::clicked, this, [this] { setSecond({}); });
  setSecond({});
}

void RobustnessForm::setSecond(const QString& path) {
  second_ = path.toStdString();
  beside_->setText(path.isEmpty() ? tr("nothing: what this life has learned so far is tried alone")
                                  : QFileInfo(path).fileName());
  beside_->setToolTip(tipText(path));
  remove_->setVisible(!path.isEmpty());
  Q_EMIT edited();
}

RobustnessQuestion RobustnessForm::question() const {
  RobustnessQuestion q{.push = textIn(push_),
                       .pushAt = textIn(pushAt_),
                       .seconds = textIn(seconds_),
                       .settings = {},
                       .policy = policy_->chosen(),
                       .starts = textIn(starts_),
                       .seed = textIn(seed_)};
  if (scenario_ && !scenario_->chosen().empty()) q.scenario = scenario_->chosen();
  for (const QString& word : settings_->text().split(' ', Qt::SkipEmptyParts)) q.settings.push_back(word.toStdString());
  return q;
}

}  // namespace surefoot

#include "moc_robustness_form.cpp"
