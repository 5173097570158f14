// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language/numbers.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include "core/text/number_text.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

constexpr const char* kDecimalComma = "decimalComma";
constexpr QChar kThousands(0x202F);  // a narrow blank at which no line breaks

bool isDigitAt(const QString& text, qsizetype at) {
  return at >= 0 && at < text.size() && text[at] >= '0' && text[at] <= '9';
}

QString swapped(QString text) {
  for (QChar& c : text)
    if (c == '.' || c == ',') c = c == '.' ? ',' : '.';
  return text;
}

}  // namespace

void setDecimalComma(bool comma) {
  qApp->setProperty(kDecimalComma, comma);
}

bool decimalComma() {
  return qApp && qApp->property(kDecimalComma).toBool();
}

QString localNumbers(QString text) {
  if (!decimalComma()) return text;
  for (qsizetype i = 0; i < text.size(); ++i) {
    if (!isDigitAt(text, i - 1) || !isDigitAt(text, i + 1)) continue;
    if (text[i] == '.')
      text[i] = ',';
    else if (text[i] == ',')
      text[i] = kThousands;
  }
  return text;
}

QString localNumbers(const std::string& text) {
  return localNumbers(QString::fromStdString(text));
}

QString fixedNumber(double value, int decimals) {
  return localNumbers(fixedText(value, decimals));
}

QString countNumber(double value) {
  return localNumbers(countText(value));
}

std::string typedNumber(const QString& text) {
  if (!decimalComma()) return text.toStdString();
  QString plain = text;
  plain.remove(kThousands);
  if (plain.contains(',')) return swapped(plain).toStdString();
  const bool asThousands = readNumberText(swapped(plain).toStdString()).good;
  const bool asDecimals = readNumberText(plain.toStdString()).good;
  if (plain.contains('.') && asThousands)  // "1.250,0" is refused, "1.250.000" is not
    return (asDecimals ? plain + QStringLiteral(",0") : swapped(plain)).toStdString();
  return plain.toStdString();
}

std::string typedNumbers(const QString& text) {
  if (!decimalComma()) return text.toStdString();
  static const QRegularExpression kBetween(QStringLiteral("\\s*[;\\s]\\s*")),
      kDecimals(QStringLiteral("([0-9]),([0-9])"));
  std::string all;
  for (QString value : text.trimmed().split(kBetween, Qt::SkipEmptyParts)) {
    if (value.endsWith(',')) value.chop(1);
    const bool range = value.contains(QStringLiteral(".."));
    if (range) value.replace(kDecimals, QStringLiteral("\\1.\\2"));
    all += (all.empty() ? "" : "; ") + (range ? value.toStdString() : typedNumber(value));
  }
  return all;
}

}  // namespace surefoot
