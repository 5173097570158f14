// SPDX-License-Identifier: GPL-3.0-or-later
// Draws what stands under and beside the lines of a robot's text.
#include <QPainter>
#include <QTextBlock>

#include "ui/robot/robot_text.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

void RobotText::paintEvent(QPaintEvent* event) {
  const Theme& t = themeOf(*this);
  {
    QPainter painter(viewport());  // the caret's line on fill
    const QRectF line = blockBoundingGeometry(textCursor().block()).translated(contentOffset());
    painter.fillRect(QRectF(0, line.top(), viewport()->width(), QFontMetrics(font()).height()), t.fill);
  }
  QPlainTextEdit::paintEvent(event);
  QPainter painter(viewport());
  links_.clear();
  for (QTextBlock block = firstVisibleBlock(); block.isValid(); block = block.next()) {
    const QRectF r = blockBoundingGeometry(block).translated(contentOffset());
    if (r.top() > viewport()->height()) break;
    double y = r.top() + QFontMetrics(font()).height() + scaled(2);
    for (const Complaint* c : at(block.blockNumber() + 1)) {
      const QFontMetrics words(scaledFont(12)), small(scaledFont(11));
      const QRect room(scaled(4), static_cast<int>(y), viewport()->width() - scaled(16), 10'000);
      const QRect text = words.boundingRect(room, Qt::TextWordWrap, sentenceOf(*c));
      painter.setFont(scaledFont(12));
      painter.setPen(t.ink);
      painter.drawText(room, Qt::TextWordWrap, sentenceOf(*c));
      y += text.height() + scaled(4);
      const auto proposal = proposalOf(*c);
      if (!proposal) continue;
      const QString write = tr("Write “%1”").arg(proposal->right), key = tr("Alt+Enter");
      QFont strong = scaledFont(11, 500);
      strong.setUnderline(true);
      painter.setFont(strong);
      const double width = QFontMetricsF(strong).horizontalAdvance(write);
      painter.drawText(QPointF(scaled(4), y + small.ascent()), write);
      links_.emplace_back(QRectF(scaled(4), y, width, small.height()),
                          static_cast<std::size_t>(c - complaints_.data()));
      painter.setFont(scaledFont(11));
      painter.setPen(t.quiet);
      painter.drawText(QPointF(scaled(16) + width, y + small.ascent()), key);
      y += small.height() + scaled(4);
    }
  }
}

void RobotText::paintNumbers(QPainter& painter, const QRect& dirty) {
  const Theme& t = themeOf(*this);
  painter.fillRect(dirty, t.panel);
  painter.setFont(font());
  const int height = QFontMetrics(font()).height();
  for (QTextBlock block = firstVisibleBlock(); block.isValid(); block = block.next()) {
    const QRectF r = blockBoundingGeometry(block).translated(contentOffset());
    if (r.top() > dirty.bottom()) break;
    const bool wrong = !at(block.blockNumber() + 1).empty();
    if (wrong) painter.fillRect(QRectF(0, r.top(), scaled(3), r.height()), t.caution);
    const bool here = textCursor().blockNumber() == block.blockNumber();
    painter.setPen(wrong ? t.caution : here ? t.ink : t.quiet);
    painter.drawText(QRectF(0, r.top(), numbers_->width() - scaled(8), height), Qt::AlignRight,
                     QString::number(block.blockNumber() + 1));
  }
}

}  // namespace surefoot
