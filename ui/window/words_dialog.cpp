// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/words_dialog.h"

#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScreen>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "core/glossary.h"
#include "ui/language/from_core.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {

QLabel* paragraph(QVBoxLayout* column, const QFont& font) {
  auto* label = new QLabel;
  label->setTextFormat(Qt::PlainText);
  label->setFont(font);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  label->setFocusPolicy(Qt::NoFocus);
  column->addWidget(label);
  return label;
}

}  // namespace

WordsDialog::WordsDialog(QWidget* parent) : QDialog(parent), search_(new QLineEdit), list_(new QListWidget) {
  setWindowTitle(tr("Words"));
  search_->setPlaceholderText(tr("Search"));
  search_->setAccessibleName(tr("Search the words"));
  search_->setClearButtonEnabled(true);
  list_->setAccessibleName(tr("Words"));
  for (const Word& word : glossary()) list_->addItem(fromCore(word.title));
  auto* left = new QVBoxLayout;
  left->addWidget(search_);
  left->addWidget(list_, 1);

  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(16, 0, 16, 0);
  column->setSpacing(12);
  title_ = paragraph(column, scaledFont(16, 500));
  text_ = paragraph(column, scaledFont(13));
  formula_ = paragraph(column, scaledFont(13, 500));
  source_ = paragraph(column, scaledFont(11));
  column->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setWidget(page);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 16, 1, 16);  // its outline
  row->addLayout(left, 2);
  row->addWidget(scroll, 3);
  whenScaled(this, [this] {
    const QFontMetrics metrics(scaledFont(13));
    list_->setFont(scaledFont(13));
    const int longest = list_->sizeHintForColumn(0) + style()->pixelMetric(QStyle::PM_ScrollBarExtent) + scaled(8);
    list_->setMinimumWidth(std::max(24 * metrics.averageCharWidth(), longest));
    title_->setFont(scaledFont(16, 500));
    text_->setFont(scaledFont(13));
    formula_->setFont(scaledFont(13, 500));
    source_->setFont(scaledFont(11));
    const QSize room = screen()->availableGeometry().size() * 0.9;
    resize(QSize(80 * metrics.averageCharWidth() + 60, 26 * metrics.height()).boundedTo(room));
  });
  connect(search_, &QLineEdit::textChanged, this, &WordsDialog::search);
  connect(list_, &QListWidget::currentRowChanged, this, &WordsDialog::showRow);
  list_->setCurrentRow(0);
}

void WordsDialog::showWord(const std::string& name) {
  search_->clear();
  for (std::size_t i = 0; i < glossary().size(); ++i)
    if (!name.empty() && glossary()[i].name == name) list_->setCurrentRow(static_cast<int>(i));
  list_->scrollToItem(list_->currentItem());
}

void WordsDialog::search(const QString& text) {
  int first = -1;
  for (int i = 0; i < list_->count(); ++i) {
    const Word& word = glossary()[static_cast<std::size_t>(i)];
    const bool shown = mentions(word, text.trimmed().toStdString()) ||
                       linesOf(word).join('\n').contains(text.trimmed(), Qt::CaseInsensitive);
    list_->item(i)->setHidden(!shown);
    if (shown && first < 0) first = i;
  }
  const bool still = list_->currentItem() && !list_->currentItem()->isHidden();
  if (!still) list_->setCurrentRow(first);
}

void WordsDialog::showRow(int row) {
  const Word none{
      .name = {}, .title = tr("No word has this in it.").toStdString(), .formula = {}, .text = {}, .source = {}};
  const Word& word = row < 0 ? none : glossary()[static_cast<std::size_t>(row)];
  title_->setText(fromCore(word.title));
  text_->setText(fromCore(word.text));
  formula_->setText(fromCore(word.formula));
  source_->setText(word.source.empty() ? QString() : tr("Source: %1.").arg(sourceText(word.source)));
  for (QLabel* label : {title_, text_, formula_, source_}) label->setVisible(!label->text().isEmpty());
}

}  // namespace surefoot

#include "moc_words_dialog.cpp"
