// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/handout.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextDocumentFragment>

#include "core/lessons/verdict.h"
#include "ui/language/numbers.h"
#include "ui/lessons/lesson_picture.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr double kText = 10.5, kSmall = 8.5, kHeadline = 13, kTitle = 20;  // [pt]

class Handout {
  Q_DECLARE_TR_FUNCTIONS(surefoot::Handout)

 public:
  Handout(const Registry& registry, const Lesson& lesson, const std::vector<ToldStep>& told)
      : registry_(registry),
        lesson_(lesson),
        told_(told),
        cursor_(&document_) {
    document_.setDocumentMargin(0);
    QFont font = textFont(13);
    font.setPointSizeF(kText);
    document_.setDefaultFont(font);
  }

  void write() {
    line(toText(lesson_.title), kTitle, true, 4);
    line(tr("%1 minutes, level %2 of 3").arg(lesson_.minutes).arg(lesson_.level), kSmall, false, 8);
    if (!solved()) line(tr("Name _______________________________   Date ______________"), kText, false, 10);
    picture();
    if (!lesson_.about.empty()) line(toText(lesson_.about), kText, false, 10);
    if (solved() && !lesson_.notes.empty()) line(tr("For the teacher: %1").arg(toText(lesson_.notes)), kText, false, 8);
    for (std::size_t i = 0; i < lesson_.steps.size(); ++i) step(i);
    line(tr("You know now: %1").arg(toText(lesson_.goal)), kText, true, 8);
    if (!solved()) return;
    for (const std::string& discuss : lesson_.discuss) line(tr("To discuss: %1").arg(toText(discuss)), kText, false, 4);
  }

  QByteArray asPdf() {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(toText(lesson_.title));
    writer.setCreator(QStringLiteral("Surefoot"));
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0), QPageLayout::Millimeter);
    document_.print(&writer);
    return bytes;
  }

 private:
  bool solved() const { return !told_.empty(); }

  void line(const QString& text, double points, bool bold, double below) {
    QTextBlockFormat block;
    block.setBottomMargin(below);
    QTextCharFormat format;
    format.setFontPointSize(points);
    format.setFontWeight(bold ? QFont::DemiBold : QFont::Normal);
    first_ ? cursor_.setBlockFormat(block) : cursor_.insertBlock(block);
    first_ = false;
    cursor_.insertText(text, format);
  }
  void room(int lines) {
    for (int i = 0; i < lines; ++i) line(QString(74, QLatin1Char('_')), kText, false, 6);
  }

  void picture() {
    constexpr int kWidth = 424, kHeight = 176;
    constexpr double kSharper = 3;
    QImage image(QSize(kWidth, kHeight) * kSharper, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter p(&image);
    p.scale(kSharper, kSharper);
    drawLessonPicture(p, QRectF(0, 0, kWidth, kHeight), registry_, lesson_, lightTheme());
    p.end();
    document_.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("picture")), image);
    QTextImageFormat format;
    format.setName(QStringLiteral("picture"));
    format.setWidth(kWidth);
    format.setHeight(kHeight);
    cursor_.insertBlock();
    cursor_.insertImage(format);
  }

  /// What the step says; without the answers its numbers are left open.
  QString say(std::size_t i) const {
    if (solved()) return toText(told_[i].say);
    QStringList parts;
    for (const std::string& part : lesson_.steps[i].say.between) parts << toText(part);
    return parts.join(QStringLiteral("\\_\\_\\_\\_\\_"));
  }

  void step(std::size_t i) {
    const LessonStep& step = lesson_.steps[i];
    line(tr("%1  %2").arg(i + 1).arg(toText(step.title)), kHeadline, true, 3);
    QTextDocument text;
    text.setMarkdown(say(i), QTextDocument::MarkdownNoHTML);
    line(text.toPlainText(), kText, false, 4);
    if (const std::string question = questionOf(step); !question.empty()) line(toText(question), kText, true, 4);
    if (step.predict) predict(*step.predict, i);
    if (step.ask) std::visit([&](const auto& q) { ask(q); }, *step.ask);
    if (step.done && !solved()) line(tr("I set: ____________________   It came to: ____________"), kText, false, 4);
    if (!step.hint.empty() && solved()) line(tr("Hint: %1").arg(toText(step.hint)), kSmall, false, 4);
    if (solved() && step.minutes > 0) line(tr("about %1 min").arg(step.minutes), kSmall, false, 4);
    line({}, 4, false, 4);
  }

  void predict(const LessonPrediction& p, std::size_t i) {
    line(tr("I say: ____________ %1 (%2 to %3). It came to: ____________")
             .arg(toText(p.unit), countNumber(p.low), countNumber(p.high)),
         kText, false, 4);
    if (solved())
      line(tr("It comes to %1.")
               .arg(toText(told_[i].came).section(QLatin1Char('\n'), 0, 0).section(QLatin1Char(':'), 1).trimmed()),
           kText, true, 4);
  }

  void ask(const ChoiceQuestion& q) {
    for (std::size_t i = 0; i < q.options.size(); ++i)
      line((solved() && i == q.answer ? QStringLiteral("☒  ") : QStringLiteral("☐  ")) + toText(q.options[i]), kText,
           false, 3);
    if (solved() && !q.why.empty()) line(toText(q.why), kText, false, 4);
    if (q.because && !solved()) line(tr("because"), kSmall, false, 2), room(2);
  }
  void ask(const OrderQuestion& q) {
    for (std::size_t i = 0; i < q.options.size(); ++i) {
      std::size_t place = 0;
      while (place < q.answer.size() && q.answer[place] != i) ++place;
      line(
          (solved() ? QString::number(place + 1) : QStringLiteral("___")) + QStringLiteral("  ") + toText(q.options[i]),
          kText, false, 3);
    }
  }
  void ask(const NumberQuestion& q) {
    line(solved() ? toText(q.answer.text) : tr("____________ %1").arg(toText(q.unit)), kText, solved(), 4);
  }
  void ask(const PointQuestion& q) { line(solved() ? toText(q.accept.text) : QString(), kText, false, 4); }
  void ask(const WordsQuestion& q) { solved() ? line(toText(q.model), kText, false, 4) : room(4); }
  void ask(const CompareQuestion&) { room(solved() ? 0 : 1); }

  const Registry& registry_;
  const Lesson& lesson_;
  const std::vector<ToldStep>& told_;
  QTextDocument document_;
  QTextCursor cursor_;
  bool first_ = true;
};

}  // namespace

QByteArray handoutOf(const Registry& registry, const Lesson& lesson, const std::vector<ToldStep>& told) {
  Handout handout(registry, lesson, told);
  handout.write();
  return handout.asPdf();
}

}  // namespace surefoot
