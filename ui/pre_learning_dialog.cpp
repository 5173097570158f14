// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pre_learning_dialog.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

#include "core/experiment/q_file.h"
#include "core/text.h"
#include "ui/combo.h"
#include "ui/plain_text.h"
#include "ui/session.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

namespace {

constexpr int kField = 96;  // [px]

/// What a model may be wrong about: what the scenarios change, or else all that takes effect with the next episode.
std::vector<Parameter> modelParameters(const Session& session) {
  std::vector<Parameter> list;
  const std::string& environment = session.configuration().names.environment;
  for (const auto& entry : session.configuration().parameters.all()) {
    const Parameter& p = entry.parameter;
    if (!p.key.starts_with("environment.") || !p.choices.empty()) continue;
    bool any = false, named = false;
    for (const auto& scenario : session.registry().scenarios) {
      if (scenario.environment != environment) continue;
      any = true;
      for (const auto& [key, value] : scenario.values) named |= key == p.key;
    }
    if (any ? named : p.when == When::NextEpisode) list.push_back(p);
  }
  return list;
}

}  // namespace

PreLearningDialog::PreLearningDialog(Session& session, QWidget* parent)
    : QDialog(parent),
      session_(session),
      pool_(session.registry()) {
  setWindowTitle(tr("Pre-learn, then transfer"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(24, 20, 24, 20);
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(8);
  makeModel(grid);
  makeLearning(grid);
  makePool(grid);
  connect(&pool_, &QPool::changed, this, &PreLearningDialog::refresh);
  connect(&pool_, &QPool::refused, words_, &QLabel::setText);
  refresh();
}

void PreLearningDialog::makeModel(QGridLayout* grid) {
  const auto head = [&](int column, const QString& text) {
    auto* label = new QLabel(text);
    label->setFont(textFont(13, 500));
    grid->addWidget(label, grid->rowCount() - (column > 0), column);
  };
  head(0, tr("Model"));
  head(1, tr("Simulation"));
  head(2, tr("Reality"));
  for (const Parameter& p : modelParameters(session_)) {
    const int row = grid->rowCount();
    auto* name = new QLabel(toText(p.title + (p.unit.empty() ? "" : " [" + p.unit + "]")));
    name->setToolTip(tipText(linesOf(p).join('\n')));
    grid->addWidget(name, row, 0);
    Row fields{p, new QLineEdit, new QLineEdit};
    for (auto [field, column, where] :
         {std::tuple{fields.simulation, 1, tr("in simulation")}, std::tuple{fields.reality, 2, tr("in reality")}}) {
      field->setText(toText(formatValue(p, session_.configuration().parameters.get(p.key))));
      field->setAlignment(Qt::AlignRight);
      field->setFixedWidth(kField);
      field->setAccessibleName(toText(p.title) + ' ' + where);
      grid->addWidget(field, row, column);
    }
    rows_.push_back(fields);
  }
  scenario_ = new Combo(tr("Scenario of the simulation"));
  scenario_->addItem(tr("a model of your own"));
  for (const auto& entry : session_.registry().scenarios)
    if (entry.environment == session_.configuration().names.environment)
      scenario_->addItem(toText(entry.title), toText(entry.name));
  const int row = grid->rowCount();
  grid->addWidget(new QLabel(tr("The simulation is scenario")), row, 0);
  grid->addWidget(scenario_, row, 1, 1, 2);
  connect(scenario_, &QComboBox::activated, this,
          [this] { useScenario(scenario_->currentData().toString().toStdString()); });
  for (const Row& r : rows_)
    connect(r.simulation, &QLineEdit::textEdited, scenario_, [this] { scenario_->setCurrentIndex(0); });
  if (scenario_->count() > 2) {
    scenario_->setCurrentIndex(scenario_->findData(QStringLiteral("2")));
    useScenario(scenario_->currentData().toString().toStdString());
  }
}

void PreLearningDialog::useScenario(const std::string& name) {
  for (const auto& entry : session_.registry().scenarios) {
    if (entry.name != name || entry.environment != session_.configuration().names.environment) continue;
    for (const Row& row : rows_)
      for (const auto& [key, value] : entry.values)
        if (key == row.parameter.key) row.simulation->setText(toText(formatValue(row.parameter, value)));
  }
}

void PreLearningDialog::makeLearning(QGridLayout* grid) {
  until_ = new QLineEdit;
  until_->setAlignment(Qt::AlignRight);
  until_->setFixedWidth(kField);
  until_->setAccessibleName(tr("Average reward that ends the pre-learning"));
  const auto goal = session_.task().goalReward;
  if (goal) until_->setText(toText(fixedText(0.99 * *goal, 0)));
  size_ = new QSpinBox;
  size_->setRange(1, 20);
  size_->setValue(5);
  size_->setAccessibleName(tr("Q-functions to learn"));
  start_ = new QPushButton;
  start_->setAutoDefault(false);
  int row = grid->rowCount();
  grid->addWidget(new QLabel(tr("ε-greedy, until the average reward is")), row, 0);
  grid->addWidget(until_, row, 1);
  if (goal)
    grid->addWidget(new QLabel(tr("%1: converged, %2: not").arg(0.99 * *goal, 0, 'f', 0).arg(0.8 * *goal, 0, 'f', 0)),
                    row, 2);
  grid->addWidget(new QLabel(tr("Q-functions in the pool")), ++row, 0);
  grid->addWidget(size_, row, 1);
  grid->addWidget(start_, row, 2);
  connect(start_, &QPushButton::clicked, this, &PreLearningDialog::startOrStop);
}

void PreLearningDialog::makePool(QGridLayout* grid) {
  table_ = new QTableWidget(0, 4);
  table_->setAccessibleName(tr("The pool"));
  table_->setHorizontalHeaderLabels({tr("Q-function"), tr("episodes"), tr("falls"), tr("average reward")});
  table_->verticalHeader()->hide();
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->setMinimumSize(480, 176);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  words_ = new QLabel;
  words_->setWordWrap(true);
  words_->setMinimumHeight(34);
  transfer_ = new QPushButton(tr("Begin a life in reality with it"));
  transfer_->setAutoDefault(false);
  int row = grid->rowCount();
  grid->addWidget(table_, row, 0, 1, 3);
  grid->addWidget(words_, ++row, 0, 1, 3);
  grid->addWidget(transfer_, ++row, 2);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &PreLearningDialog::refresh);
  connect(table_, &QTableWidget::itemActivated, this, &PreLearningDialog::transfer);
  connect(transfer_, &QPushButton::clicked, this, &PreLearningDialog::transfer);
}

Result<Configuration> PreLearningDialog::model(QLineEdit* Row::*column) const {
  Configuration c = session_.configuration();
  for (const Row& row : rows_) {
    const std::string text = (row.*column)->text().trimmed().toStdString();
    if (const Status s = c.parameters.set(row.parameter.key, std::string_view(text)); !s) return s.error();
  }
  if (const auto environment = makeEnvironment(session_.registry(), c); !environment) return environment.error();
  return c;
}

void PreLearningDialog::startOrStop() {
  if (pool_.busy()) return pool_.cancel();
  auto simulation = model(&Row::simulation);
  if (!simulation) return words_->setText(toText(simulation.error().message));
  const auto until =
      parseValue({.key = "average reward", .low = -1e9, .high = 1e9}, until_->text().trimmed().toStdString());
  if (!until) return words_->setText(toText(until.error().message));
  if (const QString name = scenario_->currentData().toString(); !name.isEmpty())
    simulation->names.scenario = name.toStdString();
  table_->setRowCount(0);
  pool_.start(std::move(*simulation), *until, size_->value());
}

void PreLearningDialog::transfer() {
  const int row = table_->currentRow();
  if (row < 0 || row >= static_cast<int>(pool_.pool().size())) return;
  auto reality = model(&Row::reality);
  if (!reality) return words_->setText(toText(reality.error().message));
  const PreLearned& one = pool_.pool()[static_cast<std::size_t>(row)];
  beginWith(*reality, one.file);
  if (const Status s = session_.begin(std::move(*reality)); !s) return words_->setText(toText(s.error().message));
  Q_EMIT transferred(tr("A life has begun with Q-function %1: %2 episodes and %3 falls of simulation are behind it.")
                         .arg(row + 1)
                         .arg(toText(countText(static_cast<double>(one.episodes))),
                              toText(countText(static_cast<double>(one.falls)))));
}

void PreLearningDialog::refreshRow(int row) {
  const PreLearned& one = pool_.pool()[static_cast<std::size_t>(row)];
  const QStringList cells = {QString::number(row + 1), toText(countText(static_cast<double>(one.episodes))),
                             toText(countText(static_cast<double>(one.falls))),
                             toText(fixedText(one.averageReward, 1)) + (one.reached ? "" : tr(" (not reached)"))};
  for (int column = 0; column < cells.size(); ++column) {
    auto* item = new QTableWidgetItem(cells[column]);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table_->setItem(row, column, item);
  }
}

void PreLearningDialog::refresh() {
  const int there = static_cast<int>(pool_.pool().size());
  while (table_->rowCount() < there) {
    table_->insertRow(table_->rowCount());
    refreshRow(table_->rowCount() - 1);
  }
  if (there > 0 && table_->currentRow() < 0) table_->selectRow(0);
  start_->setText(pool_.busy() ? tr("Stop") : tr("Pre-learn"));
  transfer_->setEnabled(there > 0 && table_->currentRow() >= 0);
  words_->setText(
      rows_.empty()        ? tr("This environment's model has nothing to be wrong about; what is learned is "
                                       "carried over as it is.")
      : pool_.busy()       ? tr("%1 of %2 are learned. The world goes on meanwhile.").arg(there).arg(pool_.asked())
      : pool_.asked() == 0 ? tr("The pool appears here: learn on the simulation, then choose one and begin a "
                                "life in reality with it.")
                           : tr("Choose one, and begin a life in reality with it."));
}

}  // namespace surefoot
