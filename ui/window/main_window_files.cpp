// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window that opens, saves and exports.
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QSettings>

#include "core/files/read_file.h"
#include "ui/controls/message_bar.h"
#include "ui/experiment/experiment_page.h"
#include "ui/experiment/suggested_command.h"
#include "ui/lessons/lessons_page.h"
#include "ui/session/session.h"
#include "ui/style/symbol_text.h"
#include "ui/support/ask_for_file.h"
#include "ui/support/exporting.h"
#include "ui/support/plain_text.h"
#include "ui/window/main_window.h"

namespace surefoot {

namespace {
constexpr int kMostRecent = 8;

bool belongsToExperiments(const QString& path) {
  const auto head = readHead(path.toStdString(), 15);
  return path.endsWith(QStringLiteral(".toml")) || (head && *head == "SQLite format 3");
}
/// A plan has conditions, a lesson has steps, a robot says what it is.
bool holds(const QString& path, std::string_view word) {
  constexpr std::size_t kMost = 256u << 10;
  const auto text = path.endsWith(QStringLiteral(".toml")) ? readHead(path.toStdString(), kMost) : Error{"none"};
  return text && text->find(word) != std::string::npos;
}
bool isLesson(const QString& path) {
  return holds(path, "[[step]]");
}
bool isRobot(const QString& path) {
  return holds(path, "surefoot = \"robot");
}
}  // namespace

void MainWindow::begin(const std::function<Status()>& what) {
  if (const Status s = what(); !s) return messages_->say(toText(s.error().message));
  setPage(0);
}

void MainWindow::openWithDialog() {
  askForFile(this, tr("Open"),
             tr("Everything that can be opened (*.surefoot *.safetensors *.jsonl *.toml *.sqlite);;All files (*)"),
             [this](const QString& path) { openFile(path); });
}

void MainWindow::openFile(const QString& path, const std::function<void()>& lives) {
  if (isRobot(path)) {
    openRobot(path);
    return remember(path);
  }
  if (isLesson(path)) {
    setPage(2);
    const Status s = lessons_->open(path);
    return s ? remember(path) : messages_->say(toText(s.error().message));
  }
  if (belongsToExperiments(path)) {
    setPage(1);
    experiment_->open(path);
    return remember(path);
  }
  session_.files().open(path.toStdString(), [this, path, lives](const Status& status) {
    if (!status) return messages_->say(toText(status.error().message));
    setPage(0);
    remember(path);
    if (lives) lives();
    tellLoaded(QFileInfo(path).fileName());
  });
}

void MainWindow::tellLoaded(const QString& name) {
  const QString does = session_.life().running() ? tr("%1 is loaded and goes on learning.").arg(name)
                                                 : tr("%1 is loaded, not running: Run goes on learning.").arg(name);
  messages_->tell(session_.looking().hasViewer()
                      ? tr("%1 Run › Roll out 25 s shows what it does now, without learning.").arg(does)
                      : does);
}

void MainWindow::remember(const QString& path) {
  QSettings settings;
  QStringList files = settings.value("recent").toStringList();
  files.removeAll(path);
  files.prepend(path);
  settings.setValue("recent", files.mid(0, kMostRecent));
}

void MainWindow::fillRecent() {
  recent_->clear();
  const QStringList files = QSettings().value("recent").toStringList();
  for (const QString& path : files)
    connect(recent_->addAction(menuText(path)), &QAction::triggered, this, [this, path] { openFile(path); });
  if (files.isEmpty()) recent_->addAction(tr("Nothing yet"))->setEnabled(false);
}

void MainWindow::saveSession(const std::function<void()>& then) {
  const QString& path = session_.life().file().path;
  path.isEmpty() ? saveSessionAs(then) : saveTo(SavedAs::Session, path, then);
}

void MainWindow::saveSessionAs(const std::function<void()>& then) {
  saveWithDialog(SavedAs::Session, tr("Save the session"), "session.surefoot", "surefoot", then);
}

void MainWindow::saveWithDialog(SavedAs what, const QString& title, const QString& name, const QString& ending,
                                const std::function<void()>& then) {
  askForNewFile(this, title, name, QStringLiteral("*.") + ending, ending,
                [this, what, then](const QString& path) { saveTo(what, path, then); });
}

void MainWindow::saveTo(SavedAs what, const QString& path, const std::function<void()>& then) {
  session_.files().save(what, path.toStdString(), [this, what, path, then](const Status& s) {
    if (!s) return messages_->say(toText(s.error().message));
    if (what != SavedAs::PolicyInC) remember(path);
    const auto& written = session_.files().written();
    if (what == SavedAs::Session && written) session_.life().setFile({path, *written});
    const QString says = what == SavedAs::PolicyInC ? tr("%1 is written. It checks itself: %2")
                                                    : tr("%1 is written. Without a window: %2");
    messages_->tell(says.arg(QFileInfo(path).fileName(),
                             suggestedCommand(what, path, session_.life(), session_.files().lastWritten())));
    if (then) then();
  });
}

void MainWindow::exportWithDialog(QWidget* view, const QString& title) {
  QString name = title.toLower();
  name.replace(' ', '-');
  askForNewFile(this, tr("Export %1").arg(title), name + QStringLiteral(".png"),
                tr("Picture (*.png);;Vector graphics (*.svg);;Document (*.pdf);;Table (*.csv)"), QStringLiteral("png"),
                [this, view](const QString& path) {
                  const Status s = exportView(*view, path.toStdString());
                  s ? messages_->tell(tr("%1 is written.").arg(path)) : messages_->say(toText(s.error().message));
                });
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) return openFile(url.toLocalFile());
  messages_->say(tr("Only files of this machine can be opened."));
}

}  // namespace surefoot
