// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/support/ask_for_file.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSettings>

namespace surefoot {

namespace {

/// "svg" from "Vector graphics (*.svg)"; empty: any ending.
QString endingOf(const QString& filter) {
  static const QRegularExpression ending(QStringLiteral("\\*\\.(\\w+)"));
  return ending.match(filter).captured(1);
}

/// A name without an ending gets the ending of the chosen kind of file.
class FileDialog final : public QFileDialog {
 public:
  FileDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filter)
      : QFileDialog(parent, title, folder, filter) {
    connect(this, &QFileDialog::filterSelected, this, &FileDialog::take);
  }
  void accept() override {
    if (acceptMode() == AcceptSave && !endingOf(selectedNameFilter()).isEmpty())
      setDefaultSuffix(endingOf(selectedNameFilter()));
    QFileDialog::accept();
  }

 private:
  /// Another kind of file: the ending of the name changes with it, if it was one of the others'.
  void take(const QString& filter) {
    const QString ending = endingOf(filter);
    if (acceptMode() != AcceptSave || ending.isEmpty()) return;
    setDefaultSuffix(ending);
    const QStringList files = selectedFiles();
    if (files.isEmpty() || QFileInfo(files[0]).isDir()) return;
    const QFileInfo file(files[0]);
    for (const QString& other : nameFilters())
      if (endingOf(other) == file.suffix() && file.suffix() != ending)
        return selectFile(file.completeBaseName() + '.' + ending);
  }
};

QFileDialog* makeDialog(QWidget* parent, const QString& title, const QString& filter, WithPath then) {
  auto* dialog = new FileDialog(parent, title, QSettings().value("folder").toString(), filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, &QFileDialog::fileSelected, parent, [then = std::move(then)](const QString& path) {
    const QFileInfo info(path);
    QSettings().setValue("folder", info.isDir() ? path : info.absolutePath());
    then(path);
  });
  return dialog;
}

}  // namespace

void askForFile(QWidget* parent, const QString& title, const QString& filter, WithPath then) {
  QFileDialog* dialog = makeDialog(parent, title, filter, std::move(then));
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->open();
}

void askForNewFile(QWidget* parent, const QString& title, const QString& suggested, const QString& filter,
                   const QString& ending, WithPath then) {
  QFileDialog* dialog = makeDialog(parent, title, filter, std::move(then));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(ending);
  dialog->selectFile(suggested);
  dialog->open();
}

void askForFolder(QWidget* parent, const QString& title, WithPath then) {
  QFileDialog* dialog = makeDialog(parent, title, {}, std::move(then));
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  dialog->open();
}

}  // namespace surefoot
