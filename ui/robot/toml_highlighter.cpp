// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robot/toml_highlighter.h"

namespace surefoot {

void TomlHighlighter::setQuiet(const QColor& quiet) {
  if (quiet == quiet_) return;
  quiet_ = quiet;
  rehighlight();
}

void TomlHighlighter::highlightBlock(const QString& text) {
  QTextCharFormat quiet, strong;
  quiet.setForeground(quiet_);
  strong.setFontWeight(QFont::Bold);
  QChar quote;  // of the text in hand
  for (int i = 0; i < text.size(); ++i) {
    const QChar c = text.at(i);
    if (!quote.isNull()) {
      if (c == quote) quote = QChar();
    } else if (c == u'"' || c == u'\'') {
      quote = c;
    } else if (c == u'#') {
      setFormat(i, static_cast<int>(text.size()) - i, quiet);
      break;
    }
  }
  if (text.startsWith(u'[')) {
    const auto end = text.indexOf(u']');
    setFormat(0, static_cast<int>(end < 0 ? text.size() : end + (text.startsWith(QStringLiteral("[[")) ? 2 : 1)),
              strong);
    return;
  }
  if (const auto equals = text.indexOf(u'='); equals > 0 && !text.startsWith(u'#'))
    setFormat(0, static_cast<int>(equals) + 1, quiet);
}

}  // namespace surefoot

#include "moc_toml_highlighter.cpp"
