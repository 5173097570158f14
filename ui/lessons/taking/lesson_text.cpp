// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/lesson_text.h"

#include <QTextBlock>
#include <QTextDocument>
#include <cmath>

#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

MarkdownView::MarkdownView(QWidget* parent) : QTextBrowser(parent) {
  setFrameShape(QFrame::NoFrame);
  setOpenLinks(false);
  setOpenExternalLinks(false);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
  setTabChangesFocus(true);
  viewport()->setAutoFillBackground(false);
  document()->setDocumentMargin(0);
  connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
    if (url.scheme() == QLatin1String("lesson")) Q_EMIT lessonAsked(url.path());
  });
  whenScaled(this, [this] { style(); });
}

void MarkdownView::show(const QString& markdown) {
  markdown_ = markdown;
  style();
}

void MarkdownView::changeEvent(QEvent* event) {
  QTextBrowser::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) style();
}

void MarkdownView::style() {
  constexpr int kLine = 20, kBetween = 8;  // [px]
  document()->setDefaultFont(scaledFont(13));
  document()->setMarkdown(markdown_, QTextDocument::MarkdownNoHTML);
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    QTextCursor cursor(block);
    QTextBlockFormat format = block.blockFormat();
    format.setLineHeight(scaled(kLine), QTextBlockFormat::FixedHeight);
    format.setTopMargin(0);
    format.setBottomMargin(block.next().isValid() ? scaled(kBetween) : 0);
    cursor.setBlockFormat(format);
    for (auto part = block.begin(); !part.atEnd(); ++part) {
      if (part.fragment().charFormat().fontWeight() <= QFont::Medium) continue;
      QTextCursor bold(document());
      bold.setPosition(part.fragment().position());
      bold.setPosition(part.fragment().position() + part.fragment().length(), QTextCursor::KeepAnchor);
      QTextCharFormat medium;
      medium.setFont(scaledFont(13, 500));
      bold.mergeCharFormat(medium);
      break;  // the fragments of the block have changed
    }
  }
  setAccessibleName(document()->toPlainText());
  updateGeometry();
}

int MarkdownView::heightForWidth(int width) const {
  const std::unique_ptr<QTextDocument> copy(document()->clone());
  copy->setTextWidth(std::max(width, 40));
  return static_cast<int>(std::ceil(copy->size().height()));
}

QSize MarkdownView::sizeHint() const {
  return {scaled(296), heightForWidth(width() > 40 ? width() : scaled(296))};
}

}  // namespace surefoot

#include "moc_lesson_text.cpp"
