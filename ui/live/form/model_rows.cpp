// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/form/model_rows.h"

#include <QComboBox>
#include <QCompleter>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <cmath>

#include "ui/controls/combo.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {

constexpr int kField = 104;  // [px]

/// The parameters that a model may have wrong: all its numbers that take effect with the next episode.
std::vector<Parameter> modelParameters(const RunningLife& life) {
  std::vector<Parameter> list;
  for (const auto& entry : life.configuration().parameters.all()) {
    const Parameter& p = entry.parameter;
    if (p.key.starts_with("environment.") && p.choices.empty() && p.when == When::NextEpisode) list.push_back(p);
  }
  return list;
}

/// The value, exact to a thousandth, with a true minus.
QString shownText(double value) {
  QString text = QString::number(value, 'g', 4);
  if (!text.contains('e') && std::abs(value) >= 1000) text = fixedNumber(value, 0);
  return localNumbers(text.replace('-', QChar(0x2212)));
}

}  // namespace

ModelRows::ModelRows(const RunningLife& life, QWidget* parent)
    : QWidget(parent),
      life_(life),
      grid_(new QGridLayout(this)),
      alike_(new QLabel(tr("Simulation and reality are alike. Add what is to differ."))),
      add_(new Combo(tr("Add a parameter that differs"))) {
  grid_->setColumnStretch(0, 1);
  whenScaled(this, [this] {
    grid_->setContentsMargins({});
    grid_->setHorizontalSpacing(scaled(16));
    grid_->setVerticalSpacing(scaled(6));
  });
  for (const Parameter& p : modelParameters(life)) {
    const double value = life.configuration().parameters.get(p.key);
    rows_.push_back({p, value, value});
  }
  const QString heads[] = {tr("Model"), tr("Simulation"), tr("Reality")};
  for (int column = 0; column < 3; ++column) {
    auto* head = new QLabel(heads[column]);
    whenScaled(head, [head] { head->setFont(scaledFont(13, 500)); });
    grid_->addWidget(head, 0, column, column > 0 ? Qt::AlignRight : Qt::AlignLeft);
    if (column > 0) head->hide(), heads_[static_cast<std::size_t>(column - 1)] = head;  // until there is a row
  }
  alike_->setWordWrap(true);
  alike_->setForegroundRole(QPalette::PlaceholderText);
  add_->setEditable(true);
  add_->setFocusPolicy(Qt::StrongFocus);
  add_->setInsertPolicy(QComboBox::NoInsert);
  add_->completer()->setFilterMode(Qt::MatchContains);
  add_->completer()->setCompletionMode(QCompleter::PopupCompletion);
  add_->lineEdit()->setPlaceholderText(tr("Add a parameter that differs …"));
  add_->setMaxVisibleItems(12);
  connect(add_, &QComboBox::activated, this, &ModelRows::addChosen);
  const int foot = static_cast<int>(rows_.size()) + 1;
  grid_->addWidget(alike_, foot, 0, 1, 3);
  grid_->addWidget(add_, foot + 1, 0, 1, 3);
  fillChoices();
}

QLineEdit* ModelRows::makeField(const Row& row, double value, const QString& where) {
  auto* field = new QLineEdit(shownText(value));
  field->setAlignment(Qt::AlignRight);
  field->setAccessibleName(fromCore(row.parameter.title) + ' ' + where);
  field->setToolTip(tipText(tr("Allowed: %1").arg(allowedText(row.parameter))));
  whenScaled(field, [field] { field->setFixedWidth(scaled(kField)); });
  return field;
}

void ModelRows::show(Row& row) {
  if (!row.name) {
    const int at = static_cast<int>(&row - rows_.data()) + 1;
    const Parameter& p = row.parameter;
    row.name =
        new QLabel(fromCore(p.title) + (p.unit.empty() ? QString() : QStringLiteral(" [%1]").arg(toText(p.unit))));
    row.name->setTextFormat(Qt::PlainText);
    row.name->setWordWrap(true);
    row.name->setToolTip(tipText(linesOf(p).join('\n')));
    row.first = makeField(row, row.simulation, tr("in simulation"));
    row.second = makeField(row, row.reality, tr("in reality"));
    connect(row.first, &QLineEdit::textEdited, this, &ModelRows::simulationTyped);
    grid_->addWidget(row.name, at, 0);
    grid_->addWidget(row.first, at, 1);
    grid_->addWidget(row.second, at, 2);
    setTabOrder(row.first, row.second);
  }
  row.first->setText(shownText(row.simulation));
  for (QWidget* w : std::initializer_list<QWidget*>{row.name, row.first, row.second}) w->show();
  for (QLabel* head : heads_) head->show();
  alike_->hide();
}

void ModelRows::simulate(const std::vector<std::pair<std::string, double>>& values) {
  for (Row& row : rows_) {
    row.simulation = life_.configuration().parameters.get(row.parameter.key);
    for (const auto& [key, value] : values)
      if (key == row.parameter.key) row.simulation = value;
    if (row.name) row.first->setText(shownText(row.simulation));
    if (row.simulation != row.reality) show(row);
  }
  fillChoices();
}

void ModelRows::fillChoices() {
  const QSignalBlocker blocker(add_);
  add_->clear();
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (!rows_[i].name) add_->addItem(fromCore(rows_[i].parameter.title), static_cast<int>(i));
  add_->setCurrentIndex(-1);
  add_->clearEditText();
  add_->setVisible(add_->count() > 0);
}

void ModelRows::addChosen() {
  const int chosen = add_->currentData().isValid() ? add_->currentData().toInt() : -1;
  if (chosen < 0) return;
  Row& row = rows_[static_cast<std::size_t>(chosen)];
  show(row);
  fillChoices();
  row.first->setFocus();
  row.first->selectAll();
}

Result<Configuration> ModelRows::model(Side side) const {
  Configuration c = life_.configuration();
  for (const Row& row : rows_) {
    const bool simulation = side == Side::Simulation;
    const QLineEdit* field = simulation ? row.first : row.second;
    const double exact = simulation ? row.simulation : row.reality;
    const bool typed = field && field->text() != shownText(exact);
    Result<double> value = exact;
    if (typed) value = parseValue(row.parameter, typedNumber(field->text().trimmed()));
    if (!value) return value.error();
    if (const Status s = c.parameters.set(row.parameter.key, *value); !s) return s.error();
  }
  if (const auto environment = makeEnvironment(life_.registry(), c); !environment) return environment.error();
  return c;
}

}  // namespace surefoot

#include "moc_model_rows.cpp"
