// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/ask_for_file.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

namespace surefoot {

namespace {

QFileDialog* makeDialog(QWidget* parent, const QString& title, const QString& filter, WithPath then) {
  auto* dialog = new QFileDialog(parent, title, QSettings().value("folder").toString(), filter);
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
