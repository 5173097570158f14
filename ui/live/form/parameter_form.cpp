// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/form/parameter_form.h"

#include <QPainter>
#include <QScrollBar>

#include <algorithm>
#include <set>

#include "ui/live/form/parameter_row.h"
#include "ui/running/running_life.h"
#include "ui/style/icons.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr int kRoomForMore = 860;  // [px] from this height on the second rank of parameters is shown as well

/// "POLICY", and, if changes of the parameters below do not take effect at once, when they do.
class SectionHead final : public Painted<> {
 public:
  SectionHead(const QString& title, const QString& tag, bool caution, bool first, QWidget* parent)
      : Painted(parent),
        title_(title),
        tag_(tag),
        caution_(caution),
        first_(first) {
    whenScaled(this, [this] { setFixedHeight(scaled(first_ ? 26 : 42)); });
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Theme& t = themeOf(*this);
    ScaledPainter p(this);
    if (!first_) p.fillRect(QRect(0, 7, width(), 1), t.hairline);
    QFont font = textFont(11, 500);
    font.setLetterSpacing(QFont::AbsoluteSpacing, 0.6);
    p.setFont(font);
    p.setPen(t.quiet);
    p.drawText(QPointF(0, height() - 9), title_.toUpper());
    p.setFont(textFont(11));
    p.setPen(caution_ ? t.caution : t.quiet);
    p.drawText(QRectF(0, height() - 22, width(), 18), Qt::AlignRight | Qt::AlignVCenter, tag_);
    if (tag_.isEmpty()) return;
    const double k = textScale(), size = 14 * k, left = width() - symbolWidth(p.font(), tag_) - size - 4 * k;
    p.save();
    p.translate(left + size / 2, height() - 13);
    p.scale(0.75 * k, 0.75 * k);
    drawIcon(p, caution_ ? Icon::Restart : Icon::Step, QRectF(-8, -8, 16, 16), p.pen().color());
    p.restore();
  }

 private:
  QString title_, tag_;
  bool caution_, first_;
};

QString titleOf(Group group) {
  switch (group) {
    case Group::Policy:
      return QObject::tr("Policy");
    case Group::Risk:
      return QObject::tr("Risk");
    case Group::Learning:
      return QObject::tr("Learning");
    case Group::Rewards:
      return QObject::tr("Rewards");
    case Group::Representation:
      return QObject::tr("Representation");
    case Group::Model:
      break;
  }
  return QObject::tr("Model");
}

/// The policy that alone uses a key, or "": ε belongs to ε-greedy first, whoever else uses it.
std::string ownerOf(const Registry& registry, const std::string& key) {
  std::vector<std::string> owners;
  for (const PolicyEntry& entry : registry.policies)
    for (const std::string& used : policyKeys(entry))
      if (used == key) owners.push_back(entry.name);
  if (owners.empty()) return "";
  return key == "policy.below" ? "" : owners.front();
}

}  // namespace

ParameterForm::ParameterForm(RunningLife& life, Editing& editing, History& history, QWidget* parent)
    : QScrollArea(parent),
      life_(life),
      editing_(editing),
      history_(history) {
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  whenScaled(this, [this] { setMinimumWidth(scaled(264)); });
  connect(verticalScrollBar(), &QScrollBar::rangeChanged, this, &ParameterForm::leaveRoomForBar);
  build();
  connect(&life_, &RunningLife::parametersReplaced, this, &ParameterForm::build);
  connect(&life_, &RunningLife::configurationChanged, this, &ParameterForm::refresh);
  connect(&life_, &RunningLife::valuesArrived, this, &ParameterForm::refresh);
}

void ParameterForm::build() {
  sections_.clear();  // setWidget() below deletes the old page
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  whenScaled(page, [this] { leaveRoomForBar(); });
  column->setSpacing(0);
  for (const Group group :
       {Group::Policy, Group::Risk, Group::Learning, Group::Rewards, Group::Representation, Group::Model}) {
    const bool newTable = group == Group::Representation, nextEpisode = group == Group::Model;
    const QString tag = newTable ? tr("new table") : nextEpisode ? tr("next episode") : QString();
    Section section{new SectionHead(titleOf(group), tag, newTable, sections_.empty(), page), {}};
    column->addWidget(section.head);
    for (const auto& entry : life_.configuration().parameters.all())
      if (entry.parameter.group == group) section.rows.push_back({entry.parameter, nullptr});
    // Whether it is learned stands before what is done with it.
    std::stable_partition(section.rows.begin(), section.rows.end(),
                          [](const Row& row) { return row.parameter.key == "risk.learn"; });
    for (Row& row : section.rows) column->addLayout(row.place = new QVBoxLayout);
    sections_.push_back(std::move(section));
  }
  column->addStretch(1);
  setWidget(page);
  leaveRoomForBar();
  refresh();
}

/// The rows are as wide with a scroll bar as without one.
void ParameterForm::leaveRoomForBar() {
  if (!widget()) return;
  const bool scrolls = verticalScrollBar()->maximum() > verticalScrollBar()->minimum();
  const int bar = scrolls ? verticalScrollBar()->sizeHint().width() : 0;
  QMargins margins = scaled(QMargins{12, 0, 8, 12});
  margins.setRight(std::max(0, margins.right() - bar));
  widget()->layout()->setContentsMargins(margins);
}

void ParameterForm::setShowAll(bool all) {
  all_ = all;
  refresh();
}

void ParameterForm::make(Row& row) {
  row.row = new ParameterRow(row.parameter, ownerOf(life_.registry(), row.parameter.key), widget());
  connect(row.row, &ParameterRow::edited, this, &ParameterForm::edit);
  connect(row.row, &ParameterRow::refused, this, &ParameterForm::refused);
  row.place->addWidget(row.row);
}

/// Tab goes down the form, whenever its rows were made.
void ParameterForm::orderTabs() {
  QWidget* last = nullptr;
  for (const Section& section : sections_)
    for (const Row& row : section.rows)
      for (QWidget* control : row.row ? row.row->findChildren<QWidget*>() : QList<QWidget*>()) {
        if (!(control->focusPolicy() & Qt::TabFocus)) continue;
        if (last) setTabOrder(last, control);
        last = control;
      }
}

void ParameterForm::chooseRows() {
  const int most = all_ ? 3 : height() >= scaled(kRoomForMore) ? 2 : 1;
  const Parameters& parameters = life_.configuration().parameters;
  const auto policy = findEntry(life_.registry().policies, "policy", life_.configuration().names.policy);
  const std::vector<std::string> keys = policyKeys(**policy);
  const auto ofPolicy = [&](const Parameter& p) {
    return p.order == 2 && std::find(keys.begin(), keys.end(), p.key) != keys.end();
  };
  // What is done with risk is there once it is learned; else only for those who ask for everything.
  const Parameters::Entry* learn = parameters.find("risk.learn");
  const auto isIdleRisk = [&](const Parameter& p) {
    return p.group == Group::Risk && p.key != "risk.learn" && (!learn || learn->value == 0.0);
  };
  bool made = false;
  for (Section& section : sections_) {
    bool any = false;
    for (Row& row : section.rows) {
      const int rank = isIdleRisk(row.parameter) ? 3 : row.parameter.order;
      const bool asked = rank <= most || ofPolicy(row.parameter);
      const bool shown = asked && !parameters.idleBecauseOf(row.parameter);
      if (shown && !row.row) made = true, make(row);
      if (row.row) row.row->setVisible(shown);
      any |= shown;
    }
    section.head->setVisible(any);
  }
  if (made) orderTabs();
}

void ParameterForm::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  refresh();
}

void ParameterForm::refresh() {
  chooseRows();
  const Configuration& c = life_.configuration();
  const auto policy = findEntry(life_.registry().policies, "policy", c.names.policy);
  const std::vector<std::string> keys = policyKeys(**policy);
  const std::set<std::string> inForce(keys.begin(), keys.end());
  for (const Section& section : sections_)
    for (const auto& [parameter, place, row] : section.rows) {
      if (!row || !c.parameters.find(row->key())) continue;  // the rows still belong to the task before
      row->show(c.parameters.get(row->key()), life_.base(row->key()), life_.changedAt(row->key()));
      row->setInForce(inForce.contains(row->key()) ? c.names.policy : "");
    }
}

}  // namespace surefoot

#include "moc_parameter_form.cpp"
