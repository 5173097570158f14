// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window that keeps lives from being lost: the questions before a life ends, the name of the session
// and its mark, and the work on quitting and after it.
#include <QCloseEvent>
#include <QFileInfo>
#include <QSettings>
#include <QTimer>

#include "core/environment_library.h"
#include "core/environment_programs.h"
#include "ui/controls/message_bar.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/live/live_page.h"
#include "ui/live/rival.h"
#include "ui/session/life_follower.h"
#include "ui/session/session.h"
#include "ui/session/session_name.h"
#include "ui/style/symbol_text.h"
#include "ui/support/ask_for_file.h"
#include "ui/support/counted.h"
#include "ui/window/autosave.h"
#include "ui/window/main_window.h"

namespace surefoot {

void MainWindow::askQuestions() {
  connect(&session_.newLives(), &NewLives::refused, messages_, &MessageBar::say);
  connect(&session_.newLives(), &NewLives::remarked, messages_, &MessageBar::say);
  connect(&session_.newLives().background(), &Background::busyChanged, this, [this] {
    if (session_.newLives().background().busy())
      messages_->tell(tr("It is being made ready; the world goes on meanwhile."));
  });
  connect(run_.live, &QAction::triggered, messages_, &MessageBar::cancel);
  connect(bar_, &RunBar::environmentAsked, this, [this](const std::string& name) {
    begin([this, name] { return session_.newLives().beginEnvironment(name); });
  });
  connect(bar_, &RunBar::agentAsked, this, &MainWindow::askForAgent);
  connect(&session_.editing(), &Editing::needsNewTable, this, &MainWindow::askForNewTable);
  connect(&session_.history(), &History::lifeKept, this,
          [this] { messages_->tell(tr("The life before is kept: Ctrl+Z brings it back.")); });
  connect(&session_.history(), &History::lifeBroughtBack, this,
          [this] { messages_->tell(tr("This life is back as it was; the other one is kept for undo and redo.")); });
  connect(live_, &LivePage::told, messages_, &MessageBar::tell);
  connect(live_, &LivePage::newTableAsked, this, [this](const QString& sentence, const std::function<void()>& go) {
    messages_->ask(sentence, {{tr("Start again"), go}});
  });
  session_.history().setAskBeforeEnding(
      [this](const std::shared_ptr<KeptLife>& kept, const History::GoOn& goOn) { askBeforeEnding(kept, goOn); });
  for (auto signal : {&RunningLife::fileChanged, &RunningLife::replaced})
    connect(&session_.life(), signal, this, &MainWindow::refresh);
  connect(&session_.looking(), &Looking::frame, this, [this] {
    if (name_->text() != sessionName() + (session_.life().unsaved() ? "*" : "")) refreshTitle();
  });
  connect(&session_.life(), &RunningLife::valuesArrived, this, &MainWindow::refreshName);
}

/// The environment does not answer: the life stands still until somebody tells it to go on.
void MainWindow::tellUnanswered() {
  RunningLife& life = session_.life();
  if (!life.isShown()) return;
  const Snapshot& now = life.snapshot();
  if (std::exchange(unansweredTries_, now.unansweredTries) == now.unansweredTries || now.unanswered.empty()) return;
  const Registry& registry = life.registry();
  const auto file = life.configuration().environmentFile;
  const bool asks = file && registry.programs && !registry.programs->isAllowed(file->program);
  if (life.running()) life.setRunning(false);
  messages_->ask(toText(now.unanswered), {{asks ? tr("Allow it, and go on") : tr("Try again"), [this, asks, file] {
                                             if (asks) session_.life().registry().programs->allow(file->program);
                                             session_.life().setRunning(true);
                                           }}});
}

void MainWindow::askForAgent(const QString& name, const QString& title) {
  messages_->ask(
      tr("%1 needs a new table, so learning starts again from the beginning, with the same seed.").arg(title),
      {{tr("Start again"), [this, name] {
          if (const Status s = session_.newLives().setAgent(name.toStdString()); !s)
            messages_->say(toText(s.error().message));
        }}});
}

void MainWindow::askForNewTable(const QString& key, double value) {
  const auto* entry = session_.life().configuration().parameters.find(key.toStdString());
  const auto told = [this](const Status& status) {
    if (!status) messages_->say(toText(status.error().message));
  };
  messages_->ask(
      tr("%1 = %2 needs a new table. Start again from the beginning, with the same seed, or carry what "
         "is learned over into it?")
          .arg(fromCore(entry->parameter.title), valueText(entry->parameter, value)),
      {{tr("Start again"),
        [this, key, value, told] { told(session_.newLives().setParameterAndRestart(key.toStdString(), value)); }},
       {tr("Carry over"),
        [this, key, value, told] { session_.newLives().carryOver(key.toStdString(), value, told); }}});
}

void MainWindow::askBeforeEnding(const std::shared_ptr<KeptLife>& kept, const std::function<void()>& goOn) {
  if (kept)
    return messages_->ask(
        tr("There is not enough memory to keep one more life for undo: a life before this one, of %1, is not saved and "
           "would end.")
            .arg(episodesText(kept->known.progress.episodes)),
        {{tr("Save it first"), [this, kept, goOn] { saveKept(kept, goOn); }}, {tr("End it"), goOn}});
  messages_->ask(tr("This life has %1, is not saved, and there is not enough memory to keep it for undo.")
                     .arg(episodesText(session_.life().progress().episodes)),
                 {{tr("Save it first"), [this, goOn] { saveSession(goOn); }}, {tr("End it"), goOn}});
}

QString MainWindow::sessionName() const {
  const QString& path = session_.life().file().path;
  if (session_.life().file().followed && follower_->following()) return follower_->following()->name();
  return path.isEmpty() ? tr("untitled session") : QFileInfo(path).completeBaseName();
}

// The title holds the mark's placeholder only while the mark is shown: scripts compare the title without it.
void MainWindow::refreshTitle() {
  const bool finished = session_.life().finished(), named = !session_.life().file().path.isEmpty();
  const bool unsaved = session_.life().unsaved(), marked = unsaved && !finished;
  if (!marked) setWindowModified(false);
  setWindowTitle(finished          ? tr("Surefoot: the life is complete")
                 : named || marked ? tr("Surefoot: %1").arg(sessionName()) + (marked ? "[*]" : "")
                                   : tr("Surefoot"));
  if (marked) setWindowModified(true);
  refreshName();
}

/// The session's name beside the tabs, and the counts in its tooltip.
void MainWindow::refreshName() {
  const bool unsaved = session_.life().unsaved();
  const QString& path = session_.life().file().path;
  const std::int64_t more = session_.life().progress().episodes - session_.life().file().saved.episodes;
  const QString since =
      unsaved ? counted(more, tr("%1 episodes are not saved", nullptr, forms(more))) : tr("everything is saved");
  name_->say(sessionName(), unsaved, path.isEmpty() ? since : path + '\n' + since);
}

void MainWindow::closeForNow() {
  if (closing_) return;
  closing_ = true;
  constexpr int kPatience = 5000;  // [ms]
  QTimer::singleShot(kPatience, this, &QWidget::close);
  autosave_->leave([this](const Status& s) {
    if (!s) whyNotKept_ = s.error();
    close();
  });
}

/// A text about the lives that would be lost: the present one, and those that undo could bring back.
QString MainWindow::whatIsNotSaved() const {
  const auto before = session_.history().unsavedBefore();
  QStringList others;
  for (auto life = before.rbegin(); life != before.rend() && others.size() < 4; ++life)
    others << countNumber(static_cast<double>((*life)->known.progress.episodes));
  if (before.size() > 4) others << tr("…");
  const QString kept =
      before.size() == 1
          ? tr("A life before this one, of %1,").arg(episodesText(before[0]->known.progress.episodes))
          : tr("%1 lives before this one, of %2 episodes,").arg(before.size()).arg(others.join(QStringLiteral(", ")));
  QString second;
  if (Session* other = secondUnsaved())
    second = tr("What the second learned in %1 is not saved.").arg(episodesText(other->life().progress().episodes));
  const auto with = [&](const QString& sentence) {
    return second.isEmpty() ? sentence : sentence.isEmpty() ? second : sentence + ' ' + second;
  };
  if (!session_.life().unsaved())
    return with(before.empty() ? QString() : tr("%1 kept for Ctrl+Z only, not saved.").arg(kept));
  const QString episodes = episodesText(session_.life().progress().episodes - session_.life().file().saved.episodes);
  const QString now =
      session_.life().file().path.isEmpty()
          ? (pages_->currentIndex() == 0 ? tr("What this life learned in %1 is not saved.")
                                         : tr("What the robot of the Live page learned in %1 is not saved."))
                .arg(episodes)
          : tr("What %1 learned in %2 is not saved.").arg(sessionName(), episodes);
  return with(before.empty() ? now : now + ' ' + tr("%1 kept for Ctrl+Z only.").arg(kept));
}

/// The second learner of Compare, if it learned something that is not saved.
Session* MainWindow::secondUnsaved() const {
  Rival* rival = live_->rival();
  return rival && rival->session().life().unsaved() ? &rival->session() : nullptr;
}

/// Asks about unsaved lives; false: there are none. They are saved one after the other.
bool MainWindow::askBeforeQuit() {
  const QString sentence = asksOnQuit_ ? whatIsNotSaved() : QString();
  if (sentence.isEmpty()) return false;
  const auto save = [this] {
    const auto before = session_.history().unsavedBefore();
    if (session_.life().unsaved())
      saveSession([this] { close(); });
    else if (before.empty())
      saveSecond([this] { close(); });
    else
      saveKept(before.back(), [this] { close(); });
  };
  messages_->ask(sentence, {{tr("Save"), save}, {tr("Don't save"), [this] { quit(); }}}, MessageBar::Question::Quit);
  return true;
}

void MainWindow::saveKept(const std::shared_ptr<KeptLife>& kept, const std::function<void()>& then) {
  askForNewFile(this, tr("Save the session"), "session.surefoot", "*.surefoot", "surefoot",
                [this, kept, then](const QString& path) {
                  session_.files().saveKept(*kept, path.toStdString(), [this, kept, path, then](const Status& s) {
                    if (!s) return messages_->say(toText(s.error().message));
                    remember(path);
                    kept->known.file = {path, kept->known.progress};
                    then();
                  });
                });
}

void MainWindow::saveSecond(const std::function<void()>& then) {
  Session* second = secondUnsaved();
  if (!second) return then();
  askForNewFile(this, tr("Save the second learner's session"), "second.surefoot", "*.surefoot", "surefoot",
                [this, second, then](const QString& path) {
                  second->files().save(SavedAs::Session, path.toStdString(),
                                       [this, second, path, then](const Status& s) {
                                         if (!s) return messages_->say(toText(s.error().message));
                                         remember(path);
                                         if (second->files().written())
                                           second->life().setFile({path, *second->files().written()});
                                         then();
                                       });
                });
}

/// Keeps the lives for the next start, whatever the answer was. If they cannot be written, the window stays open once.
void MainWindow::quit() {
  if (closing_) return;
  closing_ = true;
  constexpr int kPatience = 60'000;  // [ms]
  const bool again = std::exchange(couldNotKeep_, false);
  QTimer::singleShot(kPatience, this, [this] {
    if (closing_) close();
  });
  autosave_->keepLast([this, again](const Status& s) {
    if (s || again) return static_cast<void>(close());
    closing_ = false;
    couldNotKeep_ = true;
    messages_->say(tr("The session could not be kept for the next start: %1 Closing the window again gives it up.")
                       .arg(toText(s.error().message)));
  });
}

void MainWindow::closeEvent(QCloseEvent* event) {
  const bool learned = session_.life().learned() || !session_.history().unsavedBefore().empty() || secondUnsaved();
  if (!closing_ && learned) {
    event->ignore();
    if (!askBeforeQuit()) quit();
    return;
  }
  QSettings settings;
  settings.setValue("geometry", saveGeometry());
  settings.setValue("layout", live_->layoutState());
  autosave_->finish();
  event->accept();
}

void MainWindow::offerToRestore() {
  const QString left = autosave_->leftBehind();
  if (left.isEmpty() || !autosave_->claim(left)) return;
  const auto restored = [this, left] { restore(left); };
  if (Autosave::isOfLastSession(left))
    return messages_->ask(tr("The last session can go on where it was closed."),
                          {{tr("Go on with it"), restored}, {tr("Begin anew"), [this] { autosave_->leaveThere(); }}},
                          MessageBar::Question::Lasting);
  messages_->ask(tr("The last session was not closed. Its last minutes may be missing."),
                 {{tr("Restore it"), restored},
                  {tr("Not now"), [this] { autosave_->leaveThere(); }},
                  {tr("Forget it"),
                   [this, left] {
                     autosave_->forget(left);
                     offerToRestore();
                   }}},
                 MessageBar::Question::Lasting);
}

void MainWindow::restore(const QString& file) {
  session_.files().open(file.toStdString(), [this, file](const Status& s) {
    if (s) {
      session_.life().setFile({});  // it has no file of its own yet
      setPage(0);
      return autosave_->takeOver(file);
    }
    const bool damaged = s.error().kind == ErrorKind::File || s.error().kind == ErrorKind::Mismatch;
    const QString aside = damaged ? autosave_->setAside(file) : QString();
    messages_->say(
        toText(s.error().message) + ' ' +
        (aside.isEmpty() ? tr("It stays where it is: %1.").arg(file) : tr("It is set aside as %1.").arg(aside)));
    if (!aside.isEmpty()) offerToRestore();
  });
}

}  // namespace surefoot
