// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/handbook/handbook_browser.h"

#include <QImageReader>
#include <QPixmap>
#include <QScrollBar>
#include <QTextDocument>
#include <algorithm>

#include "core/handbook/html.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr int kMargin = 24, kWidest = 760;  // [px], of the text's column

/// What Qt's HTML knows of CSS. %1 to %3 are colours, %4 to %9 lengths [px].
QString pageStyle(const Theme& t) {
  const auto px = [](int pixels) { return QString::number(scaled(pixels)); };
  const auto css = QStringLiteral(
      "h1 { font-size: %4px; font-weight: 500; margin-top: 0; margin-bottom: %6px; }"
      "h2 { font-size: %5px; font-weight: 500; margin-top: %7px; margin-bottom: %8px; }"
      "h3 { font-size: %9px; font-weight: 500; margin-top: %6px; margin-bottom: %8px; }"
      "p, li { line-height: 130%; margin-top: 0; margin-bottom: %8px; }"
      "a { color: %1; text-decoration: none; }"
      "code { background-color: %2; }"
      "blockquote { margin-left: %7px; margin-top: 0; }"
      "pre { background-color: %2; margin-top: %8px; margin-bottom: %6px; }"
      "table { border-color: %3; border-style: solid; border-collapse: collapse; margin-bottom: %6px; }"
      "td, th { border: 1px solid %3; padding: %8px; }");
  return css.arg(t.accent.name(), t.fill.name(), t.hairline.name(), px(24), px(17), px(12), px(20), px(6), px(14));
}

}  // namespace

HandbookBrowser::HandbookBrowser(const Handbook& handbook, QString pictures, QWidget* parent)
    : QTextBrowser(parent),
      handbook_(handbook),
      pictures_(std::move(pictures)) {
  setAccessibleName(tr("Page of the handbook"));
  setFrameShape(QFrame::NoFrame);
  setOpenExternalLinks(true);
  document()->setDocumentMargin(0);
  connect(this, &QTextBrowser::sourceChanged, this, &HandbookBrowser::showMarks);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  again_.setSingleShot(true);
  connect(&again_, &QTimer::timeout, this, &HandbookBrowser::readAgain);
  whenScaled(this, [this] { again_.start(0); });
}

void HandbookBrowser::open(const QString& page) {
  const bool there = pageNamed(handbook_, page.section(u'#', 0, 0).toStdString());
  setSource(QUrl(there ? page : QString::fromStdString(handbook_.front().name)));
}

int HandbookBrowser::pictureWidth() const {
  return viewport()->width();
}

QVariant HandbookBrowser::loadResource(int type, const QUrl& name) {
  if (type == QTextDocument::HtmlResource) {
    const HandbookPage* page = pageNamed(handbook_, name.path().toStdString());
    return page ? QString::fromStdString(htmlOf(*page)) : QString();
  }
  if (type != QTextDocument::ImageResource) return {};  // nothing is fetched from anywhere
  const QImage picture = QImageReader(pictures_ + u'/' + QUrl(name).fileName()).read();
  const qreal pixels = devicePixelRatioF();
  const int width = std::min(pictureWidth(), picture.width());
  if (picture.isNull() || width <= 0) return {};
  QPixmap fitted =
      QPixmap::fromImage(picture.scaledToWidth(static_cast<int>(width * pixels), Qt::SmoothTransformation));
  fitted.setDevicePixelRatio(pixels);
  return fitted;
}

/// Lines are no longer than one reads well.
void HandbookBrowser::fit() {
  const int margin = scaled(kMargin), most = scaled(kWidest);
  setViewportMargins(margin, margin / 2, std::max(margin / 2, width() - margin - most), 0);
}

// Colours, sizes and pictures are fixed when a page is read; so it is read again, and stays where it was.
void HandbookBrowser::readAgain() {
  fit();
  width_ = viewport()->width();
  document()->setDefaultFont(scaledFont(13));
  document()->setDefaultStyleSheet(pageStyle(themeOf(*this)));
  if (source().isEmpty()) return;
  const int first = cursorForPosition({0, 0}).position();  // in sight
  document()->clear();
  reload();
  document()->setTextWidth(viewport()->width());  // what was laid out before may have been wider
  QTextCursor place(document());
  place.setPosition(std::min(first, document()->characterCount() - 1));
  verticalScrollBar()->setValue(verticalScrollBar()->value() + cursorRect(place).top());
  showMarks();
}

void HandbookBrowser::changeEvent(QEvent* event) {
  QTextBrowser::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) again_.start(0);
}

void HandbookBrowser::resizeEvent(QResizeEvent* event) {
  QTextBrowser::resizeEvent(event);
  fit();
  document()->setTextWidth(viewport()->width());
  if (viewport()->width() != width_) again_.start(0);
}

void HandbookBrowser::mark(const QString& words) {
  marked_ = words;
  showMarks();
}

void HandbookBrowser::showMarks() {
  const Theme& t = themeOf(*this);
  QList<ExtraSelection> marks;
  for (const QString& word : marked_.split(u' ', Qt::SkipEmptyParts))
    for (QTextCursor at = document()->find(word); !at.isNull(); at = document()->find(word, at)) {
      ExtraSelection mark;
      mark.cursor = at;
      mark.format.setBackground(t.track);
      marks << mark;
    }
  setExtraSelections(marks);
}

bool HandbookBrowser::findNext(const QString& text, bool backward) {
  const auto way = backward ? QTextDocument::FindBackward : QTextDocument::FindFlags();
  if (text.isEmpty() || find(text, way)) return !text.isEmpty();
  moveCursor(backward ? QTextCursor::End : QTextCursor::Start);
  return find(text, way);
}

}  // namespace surefoot

#include "moc_handbook_browser.cpp"
