// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/form/pre_learning_dialog.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>

#include "core/environment_library.h"
#include "core/saved/q_file.h"
#include "ui/controls/combo.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/live/form/model_rows.h"
#include "ui/running/running_life.h"
#include "ui/session/new_lives.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {
constexpr int kNumberField = 104, kTable = 132;  // [px]
constexpr QSize kRoomy(620, 580);                // [px] size that the dialog asks for
constexpr int kScreenEdge = 48;                  // [px] of the screen kept clear: the title bar
// Without an average reward: as long as the walkers of the laboratory pre-learn; in a task without a clock.
constexpr double kMinutes = 120;
constexpr std::int64_t kEpisodes = 1000;
}  // namespace

PreLearningDialog::PreLearningDialog(RunningLife& life, NewLives& newLives, QWidget* parent)
    : QDialog(parent),
      life_(life),
      newLives_(newLives),
      pool_(life.registry()),
      model_(new ModelRows(life)) {
  setWindowTitle(tr("Pre-learn, then transfer"));
  auto* body = new QWidget;
  auto* grid = new QGridLayout(body);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(body);
  auto* column = new QVBoxLayout(this);
  column->addWidget(scroll, 1);
  makeModel(grid);
  makeLearning(grid);
  makePool(grid);
  makeFoot(column);
  whenScaled(this, [this, grid, column] {
    grid->setContentsMargins(scaled({24, 20, 24, 8}));
    grid->setHorizontalSpacing(scaled(16));
    grid->setVerticalSpacing(scaled(8));
    column->setContentsMargins(1, 1, 1, scaled(16));  // its outline
    fitToScreen();
  });
  connect(&pool_, &QPool::changed, this, &PreLearningDialog::refresh);
  connect(&pool_, &QPool::refused, words_, &QLabel::setText);
  refresh();
}

void PreLearningDialog::fitToScreen() {
  const QSize room = screen()->availableGeometry().size() - QSize(kScreenEdge, kScreenEdge);
  setMinimumSize(scaled({420, 300}).boundedTo(room));
  resize(scaled(kRoomy).boundedTo(room));
}

void PreLearningDialog::makeModel(QGridLayout* grid) {
  scenario_ = new Combo(tr("Scenario of the simulation"));
  scenario_->addItem(tr("a model of your own"));
  for (const AssignmentEntry* entry : scenariosOf(life_.registry(), life_.configuration().names.environment))
    scenario_->addItem(fromCore(entry->title), toText(entry->name));
  grid->setColumnStretch(0, 1);
  if (scenario_->count() > 1) {
    grid->addWidget(new QLabel(tr("The simulation is scenario")), 0, 0);
    grid->addWidget(scenario_, 0, 1, 1, 2);
  } else {
    scenario_->setParent(this);
    scenario_->hide();
  }
  grid->addWidget(model_, 1, 0, 1, 3);
  model_->setVisible(!model_->empty());
  connect(scenario_, &QComboBox::activated, this, [this] { useScenario(scenario_->chosen()); });
  connect(model_, &ModelRows::simulationTyped, scenario_, [this] { scenario_->setCurrentIndex(0); });
  if (scenario_->count() > 2) {
    scenario_->choose("2");
    useScenario(scenario_->chosen());
  }
}

void PreLearningDialog::useScenario(const std::string& name) {
  const auto entry = findScenario(life_.registry(), life_.configuration().names.environment, name);
  if (entry) model_->simulate((*entry)->values);
}

void PreLearningDialog::makeLearning(QGridLayout* grid) {
  until_ = new QLineEdit;
  until_->setAlignment(Qt::AlignRight);
  until_->setAccessibleName(tr("Average reward that ends the pre-learning"));
  const auto goal = life_.task().goalReward;
  if (goal) until_->setText(fixedNumber(0.99 * *goal, 0));
  const bool clock = life_.task().stepTime.has_value();
  size_ = new QSpinBox;
  size_->setRange(1, 20);
  size_->setValue(5);
  size_->setAccessibleName(tr("Q-functions to learn"));
  whenScaled(this, [this] {
    until_->setFixedWidth(scaled(kNumberField));
    size_->setFixedWidth(scaled(kNumberField));
  });
  int row = grid->rowCount();
  auto* words = new QLabel(tr("ε-greedy, until the average reward is"));
  words->setWordWrap(true);
  grid->addWidget(words, row, 0);
  grid->addWidget(until_, row, 1);
  if (goal)
    grid->addWidget(
        new QLabel(tr("%1 has converged, %2 has not").arg(fixedNumber(0.99 * *goal, 0), fixedNumber(0.8 * *goal, 0))),
        row, 2);
  else
    grid->addWidget(new QLabel(clock ? tr("or, left empty, for %1 simulated min").arg(kMinutes)
                                     : tr("or, left empty, for %1").arg(episodesText(kEpisodes))),
                    row, 2);
  grid->addWidget(new QLabel(tr("Q-functions in the pool")), ++row, 0);
  grid->addWidget(size_, row, 1);
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
  whenScaled(table_, [this] {
    table_->setMinimumHeight(scaled(kTable));
    table_->verticalHeader()->setDefaultSectionSize(scaled(26));
  });
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  const int row = grid->rowCount();
  grid->addWidget(table_, row, 0, 1, 3);
  grid->setRowStretch(row, 1);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &PreLearningDialog::refresh);
  connect(table_, &QTableWidget::itemActivated, this, &PreLearningDialog::transfer);
}

/// The message and the buttons, below the part that scrolls.
void PreLearningDialog::makeFoot(QVBoxLayout* column) {
  words_ = new QLabel;
  words_->setWordWrap(true);
  words_->setTextFormat(Qt::PlainText);
  start_ = new QPushButton;
  start_->setAutoDefault(false);
  transfer_ = new QPushButton(tr("Begin a life in reality with it"));
  transfer_->setAutoDefault(false);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(start_);
  buttons->addWidget(transfer_);
  column->addWidget(words_);
  column->addLayout(buttons);
  whenScaled(this, [this, column, buttons] {
    words_->setMinimumHeight(scaled(34));
    words_->setContentsMargins(scaled({24, 0, 24, 0}));
    buttons->setContentsMargins(scaled({24, 0, 24, 0}));
    column->setSpacing(scaled(8));
  });
  connect(start_, &QPushButton::clicked, this, &PreLearningDialog::startOrStop);
  connect(transfer_, &QPushButton::clicked, this, &PreLearningDialog::transfer);
}

void PreLearningDialog::startOrStop() {
  if (pool_.busy()) return pool_.cancel();
  auto simulation = model_->model(ModelRows::Side::Simulation);
  if (!simulation) return words_->setText(toText(simulation.error().message));
  simulation->until.reset(), simulation->minutes.reset(), simulation->episodes.reset();
  if (const std::string typed = typedNumber(until_->text().trimmed()); !typed.empty()) {
    const auto value = parseValue({.key = tr("Average reward").toStdString(), .low = -1e9, .high = 1e9}, typed);
    if (!value) return words_->setText(toText(value.error().message));
    simulation->until = *value;
  } else if (life_.task().stepTime) {
    simulation->minutes = kMinutes;
  } else {
    simulation->episodes = kEpisodes;
  }
  if (const QString name = scenario_->currentData().toString(); !name.isEmpty())
    simulation->names.scenario = name.toStdString();
  table_->setRowCount(0);
  pool_.start(std::move(*simulation), size_->value());
}

void PreLearningDialog::transfer() {
  const int row = table_->currentRow();
  if (row < 0 || row >= static_cast<int>(pool_.pool().size())) return;
  auto reality = model_->model(ModelRows::Side::Reality);
  if (!reality) return words_->setText(toText(reality.error().message));
  const PreLearned& one = pool_.pool()[static_cast<std::size_t>(row)];
  beginWith(*reality, one.file);
  static_cast<void>(static_cast<bool>(reality->parameters.set("life.rewind", 0.0)));  // no robot goes back in time
  if (const Status s = newLives_.begin(std::move(*reality)); !s) return words_->setText(toText(s.error().message));
  Q_EMIT transferred(
      tr("A life has begun with Q-function %1: %2 episodes and %3 falls of simulation are behind it.")
          .arg(row + 1)
          .arg(countNumber(static_cast<double>(one.episodes)), countNumber(static_cast<double>(one.falls))));
}

void PreLearningDialog::refreshRow(int row) {
  const PreLearned& one = pool_.pool()[static_cast<std::size_t>(row)];
  const QStringList cells = {QString::number(row + 1), countNumber(static_cast<double>(one.episodes)),
                             countNumber(static_cast<double>(one.falls)),
                             fixedNumber(one.averageReward, 1) + (one.reached ? "" : tr(" (not reached)"))};
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
      model_->empty()      ? tr("This environment's model has nothing to be wrong about; what is learned is "
                                     "carried over as it is.")
      : pool_.busy()       ? tr("%1 of %2 are learned. The world goes on meanwhile.").arg(there).arg(pool_.asked())
      : pool_.asked() == 0 ? tr("The pool appears here: learn on the simulation, then choose one and begin a "
                                "life in reality with it.")
                           : tr("Choose one, and begin a life in reality with it."));
}

}  // namespace surefoot

#include "moc_pre_learning_dialog.cpp"
