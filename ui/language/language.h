// SPDX-License-Identifier: GPL-3.0-or-later
// The languages of the window. English is that of the source; the others come inside the program (resources/languages).
// Window's thread.
#pragma once

#include <QString>
#include <vector>

class QCoreApplication;

namespace surefoot {

struct Language {
  QString code;  ///< "nl"
  QString name;  ///< in itself: "Nederlands"
};

/// All of them, English first.
const std::vector<Language>& languages();

/// The first of a person's languages ("nl-BE", "en-GB", …), in their order, that the window speaks; else "en".
QString spokenOf(const QStringList& wanted);

/// From now on texts and numbers are in this language; empty: in the system's. Before any of them is made: what is
/// shown already does not change.
void useLanguage(QCoreApplication& application, const QString& code);

/// The one in use.
QString languageInUse();

}  // namespace surefoot
