// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robot/robot_text.h"

#include <QFontDatabase>
#include <QKeyEvent>
#include <QPainter>
#include <QPlainTextDocumentLayout>
#include <QScrollBar>
#include <QTextBlock>
#include <QToolTip>
#include <algorithm>
#include <map>

#include "ui/robot/toml_highlighter.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

/// Leaves room under lines that have a sentence.
class RobotText::Roomy final : public QPlainTextDocumentLayout {
 public:
  using QPlainTextDocumentLayout::QPlainTextDocumentLayout;
  QRectF blockBoundingRect(const QTextBlock& block) const override {
    QRectF r = QPlainTextDocumentLayout::blockBoundingRect(block);
    const auto extra = extra_.find(block.blockNumber());
    if (extra != extra_.end() && r.isValid()) r.setHeight(r.height() + extra->second);
    return r;
  }
  void setExtra(std::map<int, int> extra) {
    extra_ = std::move(extra);
    requestUpdate();
    Q_EMIT documentSizeChanged(documentSize());
  }

 private:
  std::map<int, int> extra_;  // [px] by block
};

class LineNumbers final : public QWidget {
 public:
  explicit LineNumbers(RobotText& text) : QWidget(&text), text_(text) {}

 protected:
  void paintEvent(QPaintEvent* event) override {
    QPainter painter(this);
    text_.paintNumbers(painter, event->rect());
  }

 private:
  RobotText& text_;
};

RobotText::RobotText(QWidget* parent) : QPlainTextEdit(parent), roomy_(nullptr), numbers_(new LineNumbers(*this)) {
  auto* document = new QTextDocument(this);
  roomy_ = new Roomy(document);
  document->setDocumentLayout(roomy_);
  setDocument(document);
  setFrameShape(QFrame::NoFrame);
  setLineWrapMode(NoWrap);
  setTabChangesFocus(true);
  setAccessibleName(tr("Description of the robot"));
  auto* highlighter = new TomlHighlighter(document);
  whenScaled(this, [this, highlighter] {
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPixelSize(scaled(12));
    setFont(fixed);
    placeNumbers();
    refresh();
    highlighter->setQuiet(themeOf(*this).quiet);
  });
  connect(this, &QPlainTextEdit::updateRequest, this, [this] { numbers_->update(); });
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, [this] {
    numbers_->update();
    viewport()->update();
    Q_EMIT lineChanged(textCursor().blockNumber() + 1);
  });
}

void RobotText::placeNumbers() {
  setViewportMargins(scaled(48), 0, 0, 0);
  const QRect r = contentsRect();
  numbers_->setGeometry(r.left(), r.top(), scaled(44), r.height());
}

void RobotText::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  placeNumbers();
  refresh();
}

void RobotText::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  for (auto* highlighter : document()->findChildren<QSyntaxHighlighter*>())
    static_cast<TomlHighlighter*>(highlighter)->setQuiet(themeOf(*this).quiet);
}

std::vector<const Complaint*> RobotText::at(int line) const {
  std::vector<const Complaint*> own;
  for (const Complaint& c : complaints_)
    if (std::max(1, c.at.line) == line) own.push_back(&c);
  return own;
}

QString RobotText::sentenceOf(const Complaint& complaint) const {
  return toText(complaint.sentence);
}

int RobotText::gapHeight(int line) const {
  const QFontMetrics words(scaledFont(12));
  int height = 0;
  for (const Complaint* c : at(line)) {
    const QRect room(0, 0, std::max(scaled(120), viewport()->width() - scaled(16)), 10'000);
    height += words.boundingRect(room, Qt::TextWordWrap, sentenceOf(*c)).height() + scaled(4);
    if (proposalOf(*c)) height += QFontMetrics(scaledFont(11)).height() + scaled(4);
  }
  return height;
}

void RobotText::setComplaints(std::vector<Complaint> complaints) {
  complaints_ = std::move(complaints);
  refresh();
  // The sentence under the caret's line is seen, too.
  const auto below = [this] {
    return blockBoundingGeometry(textCursor().block()).translated(contentOffset()).bottom() - viewport()->height();
  };
  QScrollBar& bar = *verticalScrollBar();
  while (!at(textCursor().blockNumber() + 1).empty() && below() > 0 && bar.value() < bar.maximum() &&
         cursorRect().top() > cursorRect().height())
    bar.setValue(bar.value() + 1);
}

void RobotText::refresh() {
  std::map<int, int> extra;
  for (const Complaint& c : complaints_) extra[std::max(1, c.at.line) - 1] = gapHeight(std::max(1, c.at.line));
  roomy_->setExtra(std::move(extra));
  QList<QTextEdit::ExtraSelection> marks;
  for (const Complaint& c : complaints_) {
    if (c.at.column < 1) continue;
    QTextEdit::ExtraSelection mark;
    mark.cursor = cursorAt(c.at);
    static const QRegularExpression kWord(QStringLiteral("^\"?[\\w.]+|^."));
    const auto word = kWord.match(lineFrom(c.at));
    mark.cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor,
                             std::max(1, static_cast<int>(word.capturedLength())));
    mark.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    mark.format.setUnderlineColor(themeOf(*this).caution);
    marks.append(mark);
  }
  setExtraSelections(marks);
  viewport()->update();
  numbers_->update();
}

QTextCursor RobotText::cursorAt(TextPlace place) const {
  const QTextBlock block = document()->findBlockByNumber(std::max(1, place.line) - 1);
  QTextCursor cursor(document());
  if (!block.isValid()) return cursor;
  // Columns count characters; Qt's positions count UTF-16 units.
  const QString text = block.text();
  int position = 0;
  for (int column = 1; column < place.column && position < text.size(); ++column)
    position += text.at(position).isHighSurrogate() ? 2 : 1;
  cursor.setPosition(block.position() + std::min<int>(position, static_cast<int>(text.size())));
  return cursor;
}

QString RobotText::lineFrom(TextPlace place) const {
  const QTextCursor cursor = cursorAt(place);
  return cursor.block().text().mid(cursor.positionInBlock());
}

void RobotText::goTo(TextPlace place) {
  setTextCursor(cursorAt(place));
  const double bottom = blockBoundingGeometry(textCursor().block()).translated(contentOffset()).bottom();
  if (bottom > viewport()->height()) centerCursor();  // with the sentence under it
  ensureCursorVisible();
}

void RobotText::goToNextComplaint() {
  if (complaints_.empty()) return;
  const int line = textCursor().blockNumber() + 1;
  const auto next =
      std::find_if(complaints_.begin(), complaints_.end(), [line](const Complaint& c) { return c.at.line > line; });
  goTo((next == complaints_.end() ? complaints_.front() : *next).at);
  setFocus(Qt::OtherFocusReason);
}

void RobotText::write(TextPlace place, int length, const QString& text) {
  QTextCursor cursor = cursorAt(place);
  cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor, length);
  cursor.insertText(text);
}

void RobotText::setHead(const QString& key, const QString& value) {
  const QRegularExpression line(QStringLiteral("^%1\\s*=\\s*\"([^\"]*)\"").arg(key));
  for (QTextBlock block = document()->begin(); block.isValid() && !block.text().startsWith(u'[');
       block = block.next()) {
    const auto found = line.match(block.text());
    if (!found.hasMatch()) continue;
    QTextCursor cursor(block);
    cursor.setPosition(block.position() + static_cast<int>(found.capturedStart(1)));
    cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor, static_cast<int>(found.capturedLength(1)));
    return cursor.insertText(value);
  }
}

void RobotText::replaceAll(const QString& text) {
  if (toPlainText() == text) return;
  if (document()->isEmpty()) return setPlainText(text);  // undo does not go behind the first text
  const int line = textCursor().blockNumber(), column = textCursor().positionInBlock();
  const int seen = verticalScrollBar()->value();
  QTextCursor cursor(document());
  cursor.select(QTextCursor::Document);
  cursor.insertText(text);
  const QTextBlock block = document()->findBlockByNumber(std::min(line, document()->blockCount() - 1));
  cursor.setPosition(block.position() + std::min(column, block.length() - 1));
  setTextCursor(cursor);
  verticalScrollBar()->setValue(seen);
}

RobotTextPlace RobotText::caret() const {
  const QTextCursor cursor = textCursor();
  QStringList before;
  for (QTextBlock block = document()->begin(); block != cursor.block(); block = block.next()) before << block.text();
  return placeInRobot(before, cursor.block().text(), cursor.positionInBlock());
}

void RobotText::explain(const QString& sentence) {
  QToolTip::showText(viewport()->mapToGlobal(cursorRect().bottomLeft()), tipText(sentence), this);
}

/// F1 is the handbook elsewhere.
bool RobotText::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_F1) event->accept();
  return QPlainTextEdit::event(event);
}

void RobotText::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && event->modifiers() == Qt::AltModifier) {
    repair();
    return;
  }
  if (event->key() == Qt::Key_F8) return goToNextComplaint();
  if (event->key() == Qt::Key_F1) return Q_EMIT helpAsked();
  QPlainTextEdit::keyPressEvent(event);
}

void RobotText::mouseReleaseEvent(QMouseEvent* event) {
  for (const auto& [where, complaint] : links_)
    if (where.contains(event->position()) && complaint < complaints_.size()) {
      repair(Complaint(complaints_[complaint]));
      return;
    }
  QPlainTextEdit::mouseReleaseEvent(event);
}

}  // namespace surefoot

#include "moc_robot_text.cpp"
