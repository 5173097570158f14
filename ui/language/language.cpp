// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language/language.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>
#include <algorithm>

#include "ui/language/numbers.h"

/// As this library is a static one. Must stand outside of all namespaces.
static void addFiles() {
  Q_INIT_RESOURCE(languages);
}

namespace surefoot {

namespace {

constexpr const char* kInUse = "language";
const QString kFolder = QStringLiteral(":/languages");

}  // namespace

const std::vector<Language>& languages() {
  static const std::vector<Language> all = {{QStringLiteral("en"), QStringLiteral("English")},
                                            {QStringLiteral("nl"), QStringLiteral("Nederlands")},
                                            {QStringLiteral("de"), QStringLiteral("Deutsch")}};
  return all;
}

QString spokenOf(const QStringList& wanted) {
  for (const QString& one : wanted) {
    const QString code = one.section('-', 0, 0).section('_', 0, 0).toLower();
    for (const Language& language : languages())
      if (language.code == code) return code;
  }
  return languages().front().code;
}

void useLanguage(QCoreApplication& application, const QString& code) {
  addFiles();
  const QString spoken = spokenOf(code.isEmpty() ? QLocale::system().uiLanguages() : QStringList{code});
  for (QTranslator* before : application.findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly))
    delete before;
  for (const QString& texts : {QStringLiteral("qtbase"), QStringLiteral("surefoot")}) {
    auto* translator = new QTranslator(&application);
    if (translator->load(texts + '_' + spoken, kFolder)) QCoreApplication::installTranslator(translator);
  }
  QLocale locale(spoken);
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  QLocale::setDefault(locale);
  setDecimalComma(locale.decimalPoint() == QStringLiteral(","));
  application.setProperty(kInUse, spoken);
}

QString languageInUse() {
  const QString code = qApp->property(kInUse).toString();
  return code.isEmpty() ? languages().front().code : code;
}

}  // namespace surefoot
