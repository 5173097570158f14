// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language/from_core.h"

#include <QCoreApplication>
#include <QObject>
#include <QRegularExpression>
#include <QStringList>
#include <string_view>

#include "core/text/number_text.h"
#include "ui/language/numbers.h"

namespace surefoot {

namespace {

constexpr const char* kContext = "core";
/// The function whose parameter it is.
constexpr std::string_view kFunctions[] = {"Q⁺ ", "Q⁻ ", "V ", "ρ "};
constexpr const char* kHeads[] = {QT_TRANSLATE_NOOP("core", "reward: "), QT_TRANSLATE_NOOP("core", "fall ")};
constexpr const char* kTails[] = {QT_TRANSLATE_NOOP("core", ", from"), QT_TRANSLATE_NOOP("core", ", to"),
                                  QT_TRANSLATE_NOOP("core", ", width")};

/// What is said of every variable; those of a person's own robot are in no list.
constexpr const char* kSentences[] = {
    QT_TRANSLATE_NOOP("core", "Tiles per %1 of the %2: few generalise far, many tell states apart."),
    QT_TRANSLATE_NOOP("core", "Tiles per %1 of the %2: few let near actions share more."),
    QT_TRANSLATE_NOOP("core", "The tiles cover the %1 from here to there; outside they are worth 0."),
    QT_TRANSLATE_NOOP("core", "Width σ of the Gaussians along the %1: a wide one generalises far."),
    QT_TRANSLATE_NOOP("core", "Centres per %1 of the %2."),
    QT_TRANSLATE_NOOP("core", "Split of %1"),
    QT_TRANSLATE_NOOP("core", "%1: %2 levels")};
constexpr const char* kCited[] = {QT_TRANSLATE_NOOP("core", "thesis"),   QT_TRANSLATE_NOOP("core", "chapter"),
                                  QT_TRANSLATE_NOOP("core", "section"),  QT_TRANSLATE_NOOP("core", "sections"),
                                  QT_TRANSLATE_NOOP("core", "figure"),   QT_TRANSLATE_NOOP("core", "table"),
                                  QT_TRANSLATE_NOOP("core", "example"),  QT_TRANSLATE_NOOP("core", "eq."),
                                  QT_TRANSLATE_NOOP("core", "algorithm")};

/// What stands for %1 and %2 in a text of this pattern; empty: it is of another.
QStringList partsOf(const QString& pattern, const QString& text) {
  const QString head = pattern.section(QStringLiteral("%1"), 0, 0), rest = pattern.section(QStringLiteral("%1"), 1);
  const QString between = rest.section(QStringLiteral("%2"), 0, 0), tail = rest.section(QStringLiteral("%2"), 1);
  const bool two = rest.contains(QStringLiteral("%2"));
  const QString end = two ? tail : rest;
  if (!text.startsWith(head) || !text.endsWith(end) || text.size() <= head.size() + end.size()) return {};
  const QString inner = text.mid(head.size(), text.size() - head.size() - end.size());
  if (!two) return {inner};
  const qsizetype at = inner.indexOf(between);
  return at < 0 ? QStringList() : QStringList{inner.left(at), inner.mid(at + between.size())};
}

QString toQt(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace

QString fromCore(const std::string& text) {
  if (text.empty()) return {};
  const QString whole = QCoreApplication::translate(kContext, text.c_str());
  if (whole != QString::fromStdString(text)) return whole;
  for (const std::string_view head : kFunctions)
    if (text.starts_with(head)) return toQt(head) + fromCore(text.substr(head.size()));
  for (const char* head : kHeads)
    if (text.starts_with(head))
      return QCoreApplication::translate(kContext, head) + fromCore(text.substr(std::string_view(head).size()));
  for (const char* tail : kTails)
    if (text.ends_with(tail))
      return fromCore(text.substr(0, text.size() - std::string_view(tail).size())) +
             QCoreApplication::translate(kContext, tail);
  for (const char* sentence : kSentences)
    if (const QStringList parts = partsOf(QString::fromUtf8(sentence), whole); !parts.isEmpty()) {
      QString said = QCoreApplication::translate(kContext, sentence);
      for (const QString& part : parts) said = said.arg(fromCore(part.toStdString()));
      return said;
    }
  return whole;
}

QString sourceText(const std::string& source) {
  QString text = fromCore(source);
  if (text != QString::fromStdString(source)) return text;
  for (const char* word : kCited) {
    const QRegularExpression whole(QStringLiteral("\\b%1(?!\\w)").arg(QRegularExpression::escape(QLatin1String(word))));
    text.replace(whole, QCoreApplication::translate(kContext, word));
  }
  return text;
}

QString allowedText(const Parameter& p) {
  if (p.kind != Kind::Choice)
    return (p.kind == Kind::Integer ? QObject::tr("a whole number from %1 to %2")
                                    : QObject::tr("a number from %1 to %2"))
        .arg(localNumbers(boundText(p.low)), localNumbers(boundText(p.high)));
  QStringList names;
  for (const std::string& name : p.choices) names << fromCore(name);
  const QString last = names.takeLast();
  return names.isEmpty() ? last : QObject::tr("%1 or %2", "values").arg(names.join(QStringLiteral(", ")), last);
}

QString valueText(const Parameter& parameter, double value) {
  const std::string text = formatValue(parameter, value);
  return parameter.kind == Kind::Choice ? fromCore(text) : localNumbers(text).replace('-', QChar(0x2212));
}

}  // namespace surefoot
