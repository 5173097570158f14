// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/about/about_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QListWidget>
#include <QScreen>
#include <QStyle>
#include <QTextBrowser>
#include <QTextDocument>
#include <QVBoxLayout>

#include "ui/controls/text_button.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

AboutDialog::AboutDialog(AboutFacts facts, QWidget* parent)
    : QDialog(parent),
      facts_(std::move(facts)),
      list_(new QListWidget),
      text_(new QTextBrowser) {
  setWindowTitle(tr("About Surefoot"));
  list_->setAccessibleName(tr("Pages"));
  list_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);  // as wide as the button below it
  text_->setAccessibleName(tr("The page"));
  text_->setFrameShape(QFrame::NoFrame);
  text_->setOpenLinks(false);
  text_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* copy = new TextButton(tr("Copy the versions"), TextButton::Look::Framed);
  copy->setToolTip(tr("To the clipboard, for a report of a fault"));
  connect(copy, &QAbstractButton::clicked, this, [this] { QApplication::clipboard()->setText(versionLines()); });

  auto* left = new QVBoxLayout;
  left->addWidget(list_, 1);
  left->addWidget(copy);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 16, 1, 16);  // its outline
  row->addLayout(left);
  row->addWidget(text_, 1);

  addPage(tr("Surefoot"),
          tr("# Surefoot %1\n\nReinforcement learning that avoids falling.\n\nThe methods are those of M. van Diepen's "
             "thesis *Avoiding failure states during Reinforcement Learning*, Delft.\n\nFree software under the GNU "
             "General Public License, version 3 or later: you may use, study, share and change it. It comes without "
             "any warranty.")
              .arg(QApplication::applicationVersion()),
          Kind::Prose);
  addPage(tr("Versions"), versionLines(), Kind::Lines);
  addFile(tr("Citing"), QStringLiteral("CITATION.cff"));
  addFile(tr("Contributing"), QStringLiteral("CONTRIBUTING.md"));
  addFile(tr("Security"), QStringLiteral("SECURITY.md"));
  connect(list_, &QListWidget::currentRowChanged, this, &AboutDialog::showPage);
  list_->setCurrentRow(0);

  whenScaled(this, [this] {
    const QFontMetrics metrics(scaledFont(13));
    list_->setFont(scaledFont(13));
    list_->setMinimumWidth(list_->sizeHintForColumn(0) + style()->pixelMetric(QStyle::PM_ScrollBarExtent) + scaled(24));
    text_->setFont(scaledFont(13));
    text_->document()->setDocumentMargin(scaled(8));
    showPage(list_->currentRow());  // sizes of headings follow the font
    const QSize room = screen()->availableGeometry().size() * 0.9;
    resize(QSize(90 * metrics.averageCharWidth() + scaled(60), 26 * metrics.height()).boundedTo(room));
  });
}

void AboutDialog::addPage(const QString& title, const QString& text, Kind kind) {
  pages_.emplace_back(text, kind);
  list_->addItem(title);
}

/// A page that does not come with the program is left out.
void AboutDialog::addFile(const QString& title, const QString& name) {
  QFile file(facts_.folder + '/' + name);
  if (facts_.folder.isEmpty() || !file.open(QIODevice::ReadOnly)) return;
  addPage(title, QString::fromUtf8(file.readAll()), name.endsWith(QStringLiteral(".md")) ? Kind::Prose : Kind::Lines);
}

QString AboutDialog::versionLines() const {
  QString lines;
  for (const auto& [name, version] : facts_.versions) lines += name + ' ' + version + '\n';
  return lines;
}

void AboutDialog::showPage(int row) {
  if (row < 0) return;
  const auto& [text, kind] = pages_[static_cast<std::size_t>(row)];
  if (kind == Kind::Lines) return text_->setPlainText(text);
  text_->document()->setMarkdown(text, QTextDocument::MarkdownNoHTML);
}

}  // namespace surefoot

#include "moc_about_dialog.cpp"
