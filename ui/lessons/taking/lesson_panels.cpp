// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/lesson_panels.h"

#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "core/lessons/reading/step_reading.h"
#include "ui/controls/panel.h"
#include "ui/controls/view_menu.h"
#include "ui/lessons/driver/lesson_driver.h"
#include "ui/lessons/taking/lives_view.h"
#include "ui/lessons/taking/panel_row.h"
#include "ui/live/actions/action_key.h"
#include "ui/live/actions/action_rows.h"
#include "ui/live/falls_list.h"
#include "ui/live/form/parameter_form.h"
#include "ui/live/maps/map_bar.h"
#include "ui/live/maps/value_maps.h"
#include "ui/live/rule_view.h"
#include "ui/live/step_view.h"
#include "ui/live/world/scrubber.h"
#include "ui/live/world/world_view.h"
#include "ui/style/symbol_text.h"
#include "ui/support/help.h"

namespace surefoot {

namespace {

/// What it predicts or runs is counted in minutes: then so are its charts.
bool countsMinutes(const Lesson& lesson) {
  return std::any_of(lesson.steps.begin(), lesson.steps.end(), [](const LessonStep& step) {
    const auto* amount = step.predict                   ? &step.predict->after
                         : step.run && step.run->amount ? &*step.run->amount
                                                        : nullptr;
    return amount && amount->unit == LessonAmount::Unit::Minutes;
  });
}

/// The policies that it is about; others would only raise questions.
std::set<std::string> policiesOf(const Lesson& lesson) {
  std::set<std::string> policies = {lesson.start.names.policy};
  const auto look = [&](const LessonActions& actions) {
    for (const LessonAction& a : actions)
      if (a.kind == LessonAction::Kind::Policy) policies.insert(a.value);
  };
  for (const LessonStep& step : lesson.steps) {
    look(step.begin);
    if (step.predict) look(step.predict->then);
    if (std::find(step.show.begin(), step.show.end(), "policy") != step.show.end()) return {};  // it can be any
  }
  return policies;
}

}  // namespace

LessonPanels::LessonPanels(LessonDriver& driver, QWidget* parent)
    : QWidget(parent),
      driver_(driver),
      span_(new ChartSpan(driver.session().life(), this)),
      rows_(new QSplitter(Qt::Vertical, this)),
      below_(new PanelRow) {
  span_->countEpisodes(!countsMinutes(driver.lesson()));
  span_->showWholeLife();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(rows_);
  rows_->setHandleWidth(1);
  rows_->setChildrenCollapsible(false);
  rows_->addWidget(below_);
  connect(below_, &PanelRow::fullSizeAsked, this, &LessonPanels::toggleFull);
  connect(&driver_, &LessonDriver::stepChanged, this, &LessonPanels::showStep);
  connect(&driver_, &LessonDriver::phaseChanged, this, &LessonPanels::noteWorld);
  connect(&driver_.session().life(), &RunningLife::stateChanged, this, &LessonPanels::noteWorld);
  connect(&driver_.session().looking(), &Looking::playbackChanged, this, &LessonPanels::noteWorld);
  connect(&driver_, &LessonDriver::livesChanged, this, [this] {
    if (auto* view = qobject_cast<LivesView*>(lives_ ? lives_->property("view").value<QWidget*>() : nullptr))
      view->show(driver_.lives());
  });
}

QWidget* LessonPanels::makeContent(const std::string& name, QString& title, QString& note) {
  Session& session = driver_.session();
  RunningLife& life = session.life();
  Looking& looking = session.looking();
  if (name == "world") {
    title = tr("World");
    auto* world = new WorldView(life, looking);
    world->setPlain(true);
    return world;
  }
  if (name == "falls" || name == "reward") {
    const bool falls = name == "falls";
    title = falls ? tr("Falls") : tr("Average reward");
    note = falls ? tr("cumulative; each mark is one, click it to replay") : tr("last 80 episodes");
    auto* chart = new LearningChart(life, looking, session.history(), *span_,
                                    falls ? LearningChart::Shows::Falls : LearningChart::Shows::AverageReward);
    connect(chart, &LearningChart::predictionMoved, this, &LessonPanels::predictionMoved);
    if (words_) chart->setRunWords(words_);
    return chart;
  }
  if (name == "actions") {
    title = tr("What the robot would do now"), note = tr("% on a square-root scale");
    auto* rows = new ActionRows(life, looking, session.editing());
    rows->setPolicies(policiesOf(driver_.lesson()));
    return rows;
  }
  if (name == "maps") {
    title = tr("Value maps");
    return new ValueMaps(life, looking);
  }
  if (name == "step") {
    title = tr("This step"), note = tr("what the last one taught");
    return new StepView(life, looking);
  }
  if (name == "rule") {
    title = tr("Rule of thumb"), note = tr("TRL's threshold");
    return new RuleView(life, session.editing());
  }
  if (name == "list") {
    title = tr("List of falls"), note = tr("a click shows one again");
    return new FallsList(life, looking);
  }
  title = tr("Parameters");
  auto* form = new ParameterForm(life, session.editing(), session.history());
  connect(form, &ParameterForm::refused, this, &LessonPanels::refused);
  return form;
}

LessonPanels::Part LessonPanels::wrap(const QString& title, const QString& note, QWidget* content,
                                      const std::string& name) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* header = new PanelHeader(title, true, box);
  header->setNote(note);
  setHelpPage(*box, name.empty() ? QStringLiteral("taking-lessons") : QStringLiteral("panel-") + toText(name));
  header->setHelp(helpPageOf(box));
  column->addWidget(header);
  column->addWidget(content, 1);
  if (content->accessibleName().isEmpty()) content->setAccessibleName(title);
  new ViewMenu(*content);
  connect(header, &PanelHeader::fullSizeAsked, this, [this, box] { toggleFull(box); });
  return {box, content, header};
}

LessonPanels::Part LessonPanels::make(const std::string& name) {
  QString title, note;
  QWidget* content = makeContent(name, title, note);
  Part part = wrap(title, note, content, name);
  if (name == "world") {
    part.header->setOnPaper(true);
    part.header->addWidget(new Scrubber(driver_.session().looking()));
    rows_->insertWidget(0, part.box);
  } else {
    below_->add(part.box, title);
  }
  if (name == "maps") makeMaps(part);
  if (name == "actions") part.header->addWidget(new ActionKey(driver_.session().life(), driver_.session().looking()));
  return part;
}

QWidget* LessonPanels::makeLives(const LessonLives& lives) {
  QStringList labels;
  for (const LessonLives::Way& way : lives.ways) labels << toText(way.title);
  const QString title = toText(lives.title);
  const bool otherSeeds = std::any_of(lives.ways.begin(), lives.ways.end(), [](const LessonLives::Way& way) {
    return std::any_of(way.first.begin(), way.first.end(),
                       [](const LessonAction& a) { return a.kind == LessonAction::Kind::Seed; });
  });
  auto* view = new LivesView(labels, title, !otherSeeds);
  const Part part = wrap(title, tr("%1 lives of each").arg(lives.count), view);
  part.box->setProperty("view", QVariant::fromValue<QWidget*>(view));
  below_->add(part.box, title);
  view->show(driver_.lives());
  const auto compares = [this] {
    return driver_.answered() && driver_.step().ask && std::holds_alternative<CompareQuestion>(*driver_.step().ask);
  };
  view->showDifference(compares());
  connect(&driver_, &LessonDriver::judged, view, [view, compares] { view->showDifference(compares()); });
  return part.box;
}

void LessonPanels::makeMaps(Part& part) {
  auto* maps = qobject_cast<ValueMaps*>(part.content);
  auto* bar = new MapBar;
  part.header->addWidget(bar);
  connect(maps, &ValueMaps::placeAsked, this, [this](const std::vector<double>& state) {
    if (const Status s = driver_.session().life().place(state); !s) Q_EMIT refused(toText(s.error().message));
  });
  connect(bar, &MapBar::chosen, maps, &ValueMaps::setChoice);
  const auto show = [this, maps, bar] {
    const Shown& now = driver_.session().looking().shown();
    bar->show(maps->choice(), driver_.session().life().task(), now.state, !now.risk.empty());
  };
  connect(maps, &ValueMaps::shown, bar, show);
  connect(&driver_.session().life(), &RunningLife::replaced, bar, show);
}

LessonPanels::Part& LessonPanels::part(const std::string& name) {
  const auto found = parts_.find(name);
  return found != parts_.end() ? found->second : parts_.emplace(name, make(name)).first->second;
}

void LessonPanels::showStep() {
  if (full_) toggleFull(full_);
  const LessonStep& step = driver_.step();
  std::vector<std::string> shown;
  for (const std::string& name : step.show)
    if (std::find(lessonPanels().begin(), lessonPanels().end(), name) != lessonPanels().end()) shown.push_back(name);
  QList<QWidget*> row;
  for (const std::string& name : shown)
    if (QWidget* box = part(name).box; name != "world") row << box;
  for (auto& [name, part] : parts_) part.header->setFull(false);
  delete std::exchange(lives_, nullptr);
  if (step.lives) row << (lives_ = makeLives(*step.lives));
  below_->show(row);
  below_->setVisible(!row.isEmpty());
  const bool world = std::find(shown.begin(), shown.end(), "world") != shown.end();
  if (const auto found = parts_.find("world"); found != parts_.end()) found->second.box->setVisible(world);
  if (world && !row.isEmpty())  // Where there is little room, the picture gives way: what is below has letters.
    rows_->setSizes(height() < scaled(360) ? QList<int>{scaled(280), scaled(304)}
                                           : QList<int>{scaled(400), scaled(304)});
  noteWorld();
}

void LessonPanels::noteWorld() {
  const auto found = parts_.find("world");
  if (found == parts_.end()) return;
  const RunningLife& life = driver_.session().life();
  const Looking& looking = driver_.session().looking();
  const auto note = [&] {
    if (const Playback* playback = looking.playback()) return playback->title;
    if (!life.task().stepTime) return QString();  // what one sees is what was lived
    if (life.running())
      return life.turbo() ? tr("real time; the learner runs faster") : tr("it learns; take hold of it");
    return looking.demonstrating() ? tr("what it can do so far; it learns nothing now") : tr("held still");
  };
  found->second.header->setNote(note());
}

void LessonPanels::toggleFull(QWidget* box) {
  if (std::exchange(full_, nullptr)) return showStep();
  full_ = box;
  for (auto& [name, part] : parts_) part.header->setFull(part.box == box);
  const bool below = below_->holds(box);
  below_->setVisible(below);
  if (below) below_->show({box});
  if (const auto world = parts_.find("world"); world != parts_.end()) world->second.box->setVisible(!below);
}

void LessonPanels::setPrediction(const std::string& chart, const std::optional<ChartPrediction>& prediction) {
  for (auto& [name, part] : parts_)
    if (auto* view = qobject_cast<LearningChart*>(part.content))
      view->setPrediction(name == chart ? prediction : std::nullopt);
}

void LessonPanels::setRunWords(const std::function<QString(const RunCurve&)>& words) {
  words_ = words;
  for (auto& [name, part] : parts_)
    if (auto* chart = qobject_cast<LearningChart*>(part.content)) chart->setRunWords(words);
}

QWidget* LessonPanels::first() const {
  const auto world = parts_.find("world");
  return world != parts_.end() && world->second.box->isVisible() ? world->second.content : nullptr;
}

}  // namespace surefoot

#include "moc_lesson_panels.cpp"
