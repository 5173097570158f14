// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/signals/signals_bar.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenu>
#include <algorithm>

#include "core/experiment/configuration.h"
#include "core/saved/q_file.h"
#include "ui/controls/link_button.h"
#include "ui/language/numbers.h"
#include "ui/live/signals/signal_chooser.h"
#include "ui/live/signals/signals_shown.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/ask_for_file.h"
#include "ui/support/counted.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {
constexpr double kRollout = 25.0;  // [s]
}

SignalsBar::SignalsBar(RunningLife& life, Looking& looking, SignalsShown& shown, QWidget* parent)
    : QWidget(parent),
      life_(life),
      looking_(looking),
      shown_(shown),
      chooser_(new SignalChooser(shown, this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  whenScaled(this, [row] { row->setSpacing(scaled(2)); });
  const auto button = [&](const QString& text, const QString& tip) {
    auto* link = new LinkButton(text, this);
    link->setToolTip(tipText(tip));
    row->addWidget(link);
    return link;
  };
  signals_ = button(tr("Choose …"), tr("Which signals are shown, and in which order"));
  rollOut_ = button(tr("Roll out 25 s"), tr("What the greedy policy does in 25 s from a new start, learning nothing"));
  second_ = button(tr("Second Q"), tr("Another Q-function beside this one, from the same start with the same pushes"));
  film_ = button(tr("Film …"), tr("A film of the replay, or of the last minutes"));
  export_ = button(tr("Export"), tr("The signals that are shown, as a picture or as numbers"));
  all_ = button(tr("Signals"), tr("What can be done with the signals"));
  const auto menuOf = [this](LinkButton* link, void (SignalsBar::*fill)(QMenu&)) {
    auto* menu = new QMenu(link);
    link->setMenu(menu);
    link->setPopupMode(QToolButton::InstantPopup);
    connect(menu, &QMenu::aboutToShow, this, [this, menu, fill] {
      menu->clear();
      (this->*fill)(*menu);
    });
  };
  menuOf(second_, &SignalsBar::fillSecond);
  menuOf(export_, &SignalsBar::fillExport);
  menuOf(all_, &SignalsBar::fillAll);
  connect(signals_, &QToolButton::clicked, this, &SignalsBar::choose);
  connect(rollOut_, &QToolButton::clicked, this, &SignalsBar::rollOut);
  connect(film_, &QToolButton::clicked, this, &SignalsBar::filmAsked);
  connect(&looking_, &Looking::signalsReplaced, this, &SignalsBar::refresh);
  for (Background* work : {&reading_, &making_}) connect(work, &Background::failed, this, &SignalsBar::refused);
  all_->hide();
}

void SignalsBar::choose() {
  const QWidget* below = all_->isVisible() ? all_ : signals_;
  chooser_->openAt(below->mapToGlobal(QPoint(0, below->height() + 2)));
}

void SignalsBar::fold(int room) {
  const std::initializer_list<LinkButton*> parts{signals_, rollOut_, second_, film_, export_};
  int needed = -2;
  for (const LinkButton* part : parts) needed += part->sizeHint().width() + 2;
  const bool folded = needed > room;
  for (LinkButton* part : parts) part->setVisible(!folded);
  all_->setVisible(folded);
  layout()->invalidate();
}

void SignalsBar::refresh() {
  QString text = tr("Second Q");
  if (looking_.hasSecond()) text = tr("Second: %1").arg(looking_.secondName());
  constexpr int kLongest = 28;
  if (text.size() > kLongest) text = text.left(kLongest - 1) + QStringLiteral("…");
  if (second_->text() == text) return;
  second_->setText(text);
  second_->updateGeometry();
  if (auto* header = qobject_cast<PanelHeader*>(parentWidget())) header->layOutExtra();
}

QString SignalsBar::note() const {
  const auto& all = shown_.table().signals();
  if (all.empty()) return {};
  std::size_t shown = 0;
  for (const Strip& strip : shown_.strips()) shown += signalsIn(strip, all).places.size();
  const QString of = tr("%1 of %2").arg(shown).arg(all.size() - 2);  // without time and episode
  if (looking_.playback()) return whatHappened().isEmpty() ? of : of + QStringLiteral("; ") + whatHappened();
  return tr("%1, the last %2 s").arg(of).arg(SignalsShown::kLive);
}

/// "25.0 s, no fall, 9.6 m": of the playback.
QString SignalsBar::whatHappened() const {
  const SignalTable& table = shown_.table();
  if (table.rows() == 0 || !shown_.hasClock()) return {};
  const std::vector<double>& fall = *table.column("fall");
  const auto falls = std::count(fall.begin(), fall.end(), 1.0);
  const double seconds = static_cast<double>(table.rows()) * table.stepTime();
  QString text = tr("%1 s, ").arg(fixedNumber(seconds, 1));
  text += falls == 0 ? tr("no fall") : fallsText(falls);
  if (const std::vector<double>* way = table.column("distance"))
    if (table.column("episode")->front() == table.column("episode")->back())
      text += tr(", %1 m").arg(fixedNumber(way->back() - way->front(), 1));
  return text;
}

void SignalsBar::rollOut() {
  if (const Status s = looking_.rollOut(kRollout); !s) Q_EMIT refused(toText(s.error().message));
}

void SignalsBar::fillSecond(QMenu& menu) {
  connect(menu.addAction(tr("From a &file …")), &QAction::triggered, this, &SignalsBar::askForSecond);
  QAction* now = menu.addAction(tr("What it knows &now"));
  now->setToolTip(tr("A copy of the Q-function of this moment"));
  connect(now, &QAction::triggered, this, &SignalsBar::compareWithNow);
  if (const auto& start = life_.began().start) {
    QAction* began = menu.addAction(tr("What it &began with"));
    began->setToolTip(tr("The Q-function of the file that this life began with"));
    connect(began, &QAction::triggered, this, [this, start] { compareWith(start, {tr("what it began with")}); });
  }
  QAction* none = menu.addAction(tr("&None"));
  none->setEnabled(looking_.hasSecond());
  connect(none, &QAction::triggered, this, [this] { looking_.setSecond(nullptr, {}); });
}

void SignalsBar::compareWithNow() {
  if (!life_.values()) return;
  looking_.setSecond(life_.values()->values->clone(),
                     tr("after %1").arg(episodesText(life_.values()->totals.episodes)));
}

void SignalsBar::askForSecond() {
  askForFile(window(), tr("A Q-function beside this one"), tr("Q-functions (*.safetensors)"),
             [this](const QString& path) { setSecond(path); });
}

void SignalsBar::setSecond(const QString& path, bool rollsOut) {
  const auto file = std::make_shared<Result<std::shared_ptr<const TensorFile>>>(Error{"cancelled"});
  reading_.start([file, name = path.toStdString()](const std::atomic<bool>&) { *file = readQFile(name); },
                 [this, file, path, rollsOut] {
                   if (!*file) return Q_EMIT refused(toText(file->error().message));
                   compareWith(**file, {QFileInfo(path).fileName(), path, rollsOut});
                 },
                 std::chrono::milliseconds(100));
}

void SignalsBar::compareWith(const std::shared_ptr<const TensorFile>& file, const Second& second) {
  const auto learnedIn = configurationOf(life_.registry(), *file);
  if (learnedIn && learnedIn->names.environment != life_.configuration().names.environment)
    return Q_EMIT refused(
        tr("%1 was learned in %2; it cannot stand beside a Q-function of %3.")
            .arg(second.name, toText(learnedIn->names.environment), toText(life_.configuration().names.environment)));
  const auto agent = std::make_shared<Result<std::unique_ptr<Agent>>>(Error{"cancelled"});
  making_.start([agent, file, task = life_.task(), &registry = life_.registry()](
                    const std::atomic<bool>&) { *agent = makeTeacher(registry, *file, task); },
                [this, agent, second] {
                  if (!*agent) return Q_EMIT refused(toText(agent->error().message));
                  const std::shared_ptr<Agent> made = std::move(**agent);
                  looking_.setSecond({made, &made->values()}, second.name, second.path);
                  if (second.rollsOut && (!looking_.playback() || !looking_.playback()->start)) rollOut();
                },
                std::chrono::milliseconds(100));
}

void SignalsBar::fillExport(QMenu& menu) {
  for (const QString& ending :
       {QStringLiteral("csv"), QStringLiteral("png"), QStringLiteral("svg"), QStringLiteral("pdf")})
    connect(menu.addAction(tr("As %1 …").arg(ending.toUpper())), &QAction::triggered, this,
            [this, ending] { Q_EMIT exportAsked(ending); });
}

void SignalsBar::fillAll(QMenu& menu) {
  connect(menu.addAction(tr("&Choose signals …")), &QAction::triggered, this, &SignalsBar::choose);
  connect(menu.addAction(tr("&Roll out 25 s")), &QAction::triggered, this, &SignalsBar::rollOut);
  fillSecond(*menu.addMenu(tr("&Second Q-function")));
  connect(menu.addAction(tr("&Film …")), &QAction::triggered, this, &SignalsBar::filmAsked);
  fillExport(*menu.addMenu(tr("&Export")));
}

}  // namespace surefoot

#include "moc_signals_bar.cpp"
