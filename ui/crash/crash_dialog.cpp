// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/crash/crash_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QScreen>
#include <QVBoxLayout>

#include "ui/controls/header_button.h"
#include "ui/controls/text_button.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"
#include "ui/support/help.h"

namespace surefoot {

namespace {
constexpr qint64 kMost = 65'536;  // [bytes] that are read; reports are smaller

QString textOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.read(kMost)) : QString();
}
}  // namespace

CrashDialog::CrashDialog(const QString& file, QWidget* parent) : QDialog(parent) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Report of the last crash"));
  setHelpPage(*this, QStringLiteral("saving"));
  auto* words =
      new QLabel(tr("Versions, the life's parameters and the last commands; no names of files. Nothing is "
                    "sent. You can send it to the maintainers yourself, with what you did last: it helps."));
  words->setWordWrap(true);
  auto* text = new QPlainTextEdit(textOf(file));
  text->setReadOnly(true);
  text->setTabChangesFocus(true);
  text->setAccessibleName(tr("The report"));
  auto* where = new QLabel(tr("It lies in %1.").arg(QDir::toNativeSeparators(file)));
  where->setTextFormat(Qt::PlainText);
  where->setWordWrap(true);
  where->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* copy = new TextButton(tr("Copy"), TextButton::Look::Main);
  copy->setToolTip(tr("To the clipboard"));
  connect(copy, &QAbstractButton::clicked, this, [text] { QApplication::clipboard()->setText(text->toPlainText()); });
  auto* remove = new TextButton(tr("Delete it"), TextButton::Look::Framed);
  connect(remove, &QAbstractButton::clicked, this, [this, file] {
    QFile::remove(file);
    close();
  });

  auto* buttons = new QHBoxLayout;
  buttons->addWidget(new HelpButton(windowTitle()));
  buttons->addStretch(1);
  buttons->addWidget(remove);
  buttons->addWidget(copy);
  auto* column = new QVBoxLayout(this);
  column->addWidget(words);
  column->addWidget(text, 1);
  column->addWidget(where);
  column->addLayout(buttons);
  text->setFocus();
  whenScaled(this, [this, column, buttons, words, text, where] {
    const QFont font = scaledFont(13);
    const QFontMetrics metrics(font);
    words->setFont(font);
    text->setFont(font);
    where->setFont(scaledFont(11));
    column->setContentsMargins(scaled({16, 16, 16, 16}));
    column->setSpacing(scaled(12));
    buttons->setSpacing(scaled(8));
    const QSize room = screen()->availableGeometry().size() * 0.9;
    resize(QSize(76 * metrics.averageCharWidth(), 28 * metrics.height()).boundedTo(room));
  });
}

}  // namespace surefoot

#include "moc_crash_dialog.cpp"
