// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window that opens, saves and exports.
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QSettings>

#include "core/files/read_file.h"
#include "ui/ask_for_file.h"
#include "ui/autosave.h"
#include "ui/experiment_page.h"
#include "ui/exporting.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/session.h"
#include "ui/suggested_command.h"
#include "ui/symbol_text.h"

namespace surefoot {

namespace {
constexpr int kMostRecent = 8;

bool belongsToExperiments(const QString& path) {
  const auto head = readHead(path.toStdString(), 15);
  return path.endsWith(QStringLiteral(".toml")) || (head && *head == "SQLite format 3");
}
}  // namespace

void MainWindow::begin(const std::function<Status()>& what) {
  if (const Status s = what(); !s) return messages_->say(toText(s.error().message));
  setPage(0);
  setSessionPath({});
}

void MainWindow::openWithDialog() {
  askForFile(this, tr("Open"),
             tr("Everything that can be opened (*.surefoot *.safetensors *.jsonl *.toml *.sqlite);;All files (*)"),
             [this](const QString& path) { openFile(path); });
}

void MainWindow::openFile(const QString& path) {
  if (belongsToExperiments(path)) {
    setPage(1);
    experiment_->open(path);
    return remember(path);
  }
  session_.open(path.toStdString(), [this, path](const Status& status) {
    if (!status) return messages_->say(toText(status.error().message));
    setPage(0);
    setSessionPath(path.endsWith(QStringLiteral(".surefoot")) ? path : QString());
    remember(path);
  });
}

void MainWindow::remember(const QString& path) {
  QSettings settings;
  QStringList files = settings.value("recent").toStringList();
  files.removeAll(path);
  files.prepend(path);
  settings.setValue("recent", files.mid(0, kMostRecent));
}

void MainWindow::setSessionPath(const QString& path) {
  sessionPath_ = path;
  refresh();
}

void MainWindow::saveSession() {
  sessionPath_.isEmpty() ? saveSessionAs() : saveTo(SavedAs::Session, sessionPath_);
}

void MainWindow::saveSessionAs() {
  saveWithDialog(SavedAs::Session, tr("Save the session"), "session.surefoot", "surefoot");
}

void MainWindow::saveWithDialog(SavedAs what, const QString& title, const QString& name, const QString& ending) {
  askForNewFile(this, title, name, QStringLiteral("*.") + ending, ending,
                [this, what](const QString& path) { saveTo(what, path); });
}

void MainWindow::saveTo(SavedAs what, const QString& path) {
  session_.save(what, path.toStdString(), [this, what, path](const Status& s) {
    if (!s) return messages_->say(toText(s.error().message));
    remember(path);
    if (what == SavedAs::Session) setSessionPath(path);
    messages_->tell(tr("%1 is written. Without a window: %2")
                        .arg(QFileInfo(path).fileName(), suggestedCommand(what, path, session_)));
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

void MainWindow::offerToRestore() {
  const QString left = autosave_->leftBehind();
  if (left.isEmpty()) return;
  messages_->ask(tr("The last session was not closed. Its last minutes may be missing."),
                 {{tr("Restore it"),
                   [this, left] {
                     session_.open(left.toStdString(), [this, left](const Status& s) {
                       if (s) return autosave_->takeOver(left);
                       messages_->say(toText(s.error().message) + ' ' + tr("It is set aside as %1.damaged.").arg(left));
                       QFile::rename(left, left + QStringLiteral(".damaged"));
                     });
                   }},
                  {tr("Forget it"), [this, left] { autosave_->forget(left); }}});
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
