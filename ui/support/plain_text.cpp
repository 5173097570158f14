// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/support/plain_text.h"

#include <QTextDocument>

#include "core/formulas.h"
#include "core/text/number_text.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

QString tipText(const QString& text) {
  constexpr int kLine = 60;  // [characters]; Qt wraps only texts that it takes for HTML
  const bool longLine = text.contains('\n') || text.size() > kLine;
  return longLine || Qt::mightBeRichText(text) ? Qt::convertFromPlainText(text, Qt::WhiteSpaceNormal) : text;
}

QString menuText(QString text) {
  return text.replace('&', QStringLiteral("&&"));
}

QStringList linesOf(const Parameter& p) {
  QString head = fromCore(p.title);
  if (!p.symbol.empty()) head += QStringLiteral(" ") + toText(p.symbol);
  if (!p.unit.empty()) head += QStringLiteral(" [%1]").arg(toText(p.unit));
  const QString fallback = p.kind == Kind::Choice ? valueText(p, p.fallback) : localNumbers(boundText(p.fallback));
  return {head, fromCore(p.help), fromCore(formulaOf(p)),
          QObject::tr("It takes %1. Default: %2 (%3).").arg(allowedText(p), fallback, sourceText(p.origin))};
}

QStringList linesOf(const Word& word) {
  QStringList lines = {fromCore(word.title), fromCore(word.text)};
  if (!word.formula.empty()) lines << fromCore(word.formula);
  if (!word.source.empty()) lines << QObject::tr("Source: %1.").arg(sourceText(word.source));
  return lines;
}

QString tipOf(const std::string& name, const std::string& help) {
  const Word* word = wordOf(name);
  return tipText(word ? linesOf(*word).join('\n') : toText(help));
}

}  // namespace surefoot
