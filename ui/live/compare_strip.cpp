// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/compare_strip.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>

#include "ui/controls/combo.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/live/compared_falls.h"
#include "ui/live/rival.h"
#include "ui/running/run_names.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/ask_for_file.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {

constexpr int kAround = 46, kMarker = 20;  // edges and arrow of a box, marker of a policy [px]

QString count(std::int64_t number) {
  return countNumber(static_cast<double>(number));
}

QString beganAs(const RunningLife& life) {
  const QString beginning = life.beginning();
  return beginning.isEmpty() ? CompareStrip::tr("began with an empty table")
                             : CompareStrip::tr("began %1").arg(beginning);
}

}  // namespace

CompareStrip::CompareStrip(Rival& rival)
    : rival_(rival),
      agents_(new Combo(tr("Learning rule of the second"), this)),
      policies_(new Combo(tr("Policy of the second"), this)),
      starts_(new Combo(tr("Start of the second"), this)),
      parameters_(new QPushButton(tr("Parameters …"), this)),
      first_(new QLabel),
      own_(new QLabel),
      falls_(new QLabel) {
  for (QLabel* label : {first_, own_, falls_}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
  }
  own_->setForegroundRole(QPalette::PlaceholderText);
  falls_->setAccessibleName(tr("Falls of both"));
  parameters_->setAccessibleName(tr("Parameters of the second"));
  parameters_->setToolTip(tr("What is changed there holds for the second only"));
  for (QComboBox* combo :
       {static_cast<QComboBox*>(agents_), static_cast<QComboBox*>(policies_), static_cast<QComboBox*>(starts_)}) {
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    combo->setMinimumContentsLength(1);
  }
  auto* grid = new QGridLayout(this);
  whenScaled(this, [this, grid] {
    grid->setContentsMargins(scaled({12, 6, 12, 6}));
    grid->setHorizontalSpacing(scaled(6));
    grid->setVerticalSpacing(scaled(3));
    policies_->setPolicyMarkers();
    if (starts_->count() > 0) refresh();
  });
  grid->addWidget(new QLabel(tr("First")), 0, 0);
  grid->addWidget(first_, 0, 1, 1, 3);
  grid->addWidget(new QLabel(tr("Second")), 1, 0);
  int column = 1;
  for (Combo* choice : {policies_, agents_, starts_}) {
    grid->setColumnStretch(column, 1);
    grid->addWidget(choice, 1, column++);
  }
  grid->addWidget(own_, 2, 1, 1, 2);
  grid->addWidget(parameters_, 2, 3);
  grid->addWidget(new QLabel(tr("Falls")), 3, 0);
  grid->addWidget(falls_, 3, 1, 1, 3);
  makeChoices();
  for (RunningLife* life : {&rival_.first(), &rival_.session().life()}) {
    connect(life, &RunningLife::valuesArrived, this, &CompareStrip::refreshFalls);
    connect(life, &RunningLife::configurationChanged, this, &CompareStrip::refresh);
    connect(life, &RunningLife::replaced, this, &CompareStrip::refresh);
  }
  connect(&rival_.first(), &RunningLife::parametersReplaced, this, &CompareStrip::fillAgents);
  connect(&rival_, &Rival::changed, this, &CompareStrip::refresh);
  refresh();
}

void CompareStrip::makeChoices() {
  for (const auto& entry : rival_.first().registry().policies)
    policies_->addItem(fromCore(entry.title), toText(entry.name));
  policies_->setPolicyMarkers();
  fillAgents();
  starts_->addItem(tr("same start"), static_cast<int>(Rival::Start::Same));
  starts_->addItem(tr("empty"), static_cast<int>(Rival::Start::Empty));
  starts_->addItem(tr("a file …"), static_cast<int>(Rival::Start::File));
  const auto chosen = [this] { rival_.choose(agents_->chosen(), policies_->chosen()); };
  connect(agents_, &QComboBox::activated, this, chosen);
  connect(policies_, &QComboBox::activated, this, chosen);
  connect(starts_, &QComboBox::activated, this, &CompareStrip::chooseStart);
  connect(parameters_, &QPushButton::clicked, &rival_, &Rival::showParameters);
}

void CompareStrip::fillAgents() {
  const QSignalBlocker blocker(agents_);
  agents_->clear();
  for (const auto& entry : rival_.first().registry().agents)
    if (entry.name != "scripted" || rival_.first().task().handMade)
      agents_->addItem(fromCore(entry.title), toText(entry.name));
  agents_->choose(rival_.agent());
}

void CompareStrip::chooseStart(int index) {
  const auto start = static_cast<Rival::Start>(starts_->itemData(index).toInt());
  refresh();  // shows the old choice until the new life has begun
  if (start != Rival::Start::File) return rival_.setStart(start);
  askForFile(this, tr("What the second begins with"), tr("Q-functions (*.safetensors *.surefoot);;All files (*)"),
             [this](const QString& path) { rival_.startWith(path); });
}

QString CompareStrip::first() const {
  const RunningLife& first = rival_.first();
  RunCurve now;
  now.agent = first.configuration().names.agent;
  now.pieces = {{.policy = first.configuration().names.policy, .points = {}}};
  return toText(nameOf(now, first.registry())) + QStringLiteral(", ") + beganAs(first);
}

QString CompareStrip::falls() const {
  const RunCurve &a = rival_.first().curves().live(), &b = rival_.session().life().curves().live();
  const auto episodes = fallsAtEqualEpisodes(a, b);
  if (b.points.empty()) return tr("The second has not finished an episode yet.");
  if (!episodes) return tr("No episode has ended in both yet.");
  QString text =
      tr("after %1 %2 : %3").arg(episodesText(episodes->at), count(episodes->first), count(episodes->second));
  const auto steps = fallsAtEqualSteps(a, b);
  if (const auto& stepTime = rival_.first().task().stepTime; stepTime && steps)
    text += tr("; after %1 min %2 : %3")
                .arg(fixedNumber(static_cast<double>(steps->at) * *stepTime / 60, 1), count(steps->first),
                     count(steps->second));
  return text;
}

void CompareStrip::refreshFalls() {
  falls_->setText(falls());
}

void CompareStrip::refresh() {
  first_->setText(first());
  const auto select = [](QComboBox& combo, const QVariant& value) {
    const QSignalBlocker blocker(&combo);
    combo.setCurrentIndex(combo.findData(value));
  };
  select(*agents_, toText(rival_.agent()));
  select(*policies_, toText(rival_.policy()));
  select(*starts_, static_cast<int>(rival_.start()));
  for (Combo* combo : {agents_, policies_, starts_})  // the present choice is never cut
    combo->setMinimumWidth(QFontMetrics(scaledFont(13)).horizontalAdvance(combo->currentText()) +
                           scaled(kAround + (combo == policies_ ? kMarker : 0)));
  const QString own = rival_.ownParameters();
  own_->setText(own.isEmpty() ? beganAs(rival_.session().life())
                              : tr("%1; its own: %2").arg(beganAs(rival_.session().life()), own));
  refreshFalls();
}

void CompareStrip::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  p.fillRect(rect(), t.paper);
  p.fillRect(QRect(0, height() - 1, width(), 1), t.hairline);
}

}  // namespace surefoot

#include "moc_compare_strip.cpp"
