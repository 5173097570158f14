// SPDX-License-Identifier: GPL-3.0-or-later
// The files of the languages: all is translated, and what is computed with stands in every translation.
#include "ui/language/language.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <map>

#include "app/requests/open_line.h"
#include "core/lessons/reading/lesson_library.h"
#include "tests/full_registry.h"
#include "tests/ui/language/declared_texts.h"
#include "tests/ui/language/spoken.h"
#include "ui/language/from_core.h"
#include "ui/language/speech.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {

struct Message {
  QString context, source;
  QStringList forms;  ///< one, or singular and plural
  bool numbered = false, finished = true;
};

std::vector<Message> messagesOf(const QString& code) {
  QFile file(QStringLiteral(SUREFOOT_SOURCE "/resources/languages/surefoot_%1.ts").arg(code));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << code.toStdString();
  QXmlStreamReader xml(&file);
  std::vector<Message> all;
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QStringLiteral("name")) context = xml.readElementText();
    if (xml.name() == QStringLiteral("message"))
      all.push_back(
          {.context = context, .source = {}, .forms = {}, .numbered = xml.attributes().hasAttribute("numerus")});
    if (xml.name() == QStringLiteral("source")) all.back().source = xml.readElementText();
    if (xml.name() == QStringLiteral("translation")) {
      Message& m = all.back();
      m.finished = !xml.attributes().hasAttribute("type");
      if (!m.numbered) m.forms << xml.readElementText();
    }
    if (xml.name() == QStringLiteral("numerusform")) all.back().forms << xml.readElementText();
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return all;
}

/// %1, %2, %n, tags, what is computed in braces, and links of lessons, sorted.
QStringList placesIn(const QString& text) {
  static const QRegularExpression kPlace(QStringLiteral("%L?[0-9n]|</?[a-z]+>|\\{[^}:]*\\}|\\*\\*|\\]\\([^)]*\\)"));
  QStringList places;
  for (auto found = kPlace.globalMatch(text); found.hasNext();) places << found.next().captured();
  places.sort();
  return places;
}

bool hasKey(const QString& text) {
  static const QRegularExpression kKey(QStringLiteral("(^|[^&])&[^&\\s]"));
  return text.contains(kKey);
}

/// Blanks at both ends, which join a text to its neighbours.
QString edgesOf(const QString& text) {
  const QString bare = text.trimmed();
  const qsizetype at = text.indexOf(bare);
  return bare.isEmpty() ? text : text.left(at) + '|' + text.mid(at + bare.size());
}

class LanguageFile : public testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(LanguageFile, IsComplete) {
  const auto all = messagesOf(GetParam());
  EXPECT_GT(all.size(), 1500u);
  for (const Message& m : all) {
    const std::string text = (m.context + ": " + m.source).toStdString();
    EXPECT_TRUE(m.finished) << text;
    EXPECT_EQ(m.forms.size(), m.numbered ? 2 : 1) << text;
    for (const QString& form : m.forms) EXPECT_FALSE(form.isEmpty()) << text;
  }
}

TEST_P(LanguageFile, KeepsPlacesTagsKeysAndEdges) {
  for (const Message& m : messagesOf(GetParam()))
    for (qsizetype i = 0; i < m.forms.size(); ++i) {
      const std::string text = (m.source + " → " + m.forms[i]).toStdString();
      const bool one = m.numbered && i == 0;  // "once", "one step" need no number
      EXPECT_TRUE(one || placesIn(m.forms[i]) == placesIn(m.source)) << text;
      EXPECT_EQ(hasKey(m.forms[i]), hasKey(m.source)) << text;
      EXPECT_EQ(edgesOf(m.forms[i]).section('|', 0, 0), edgesOf(m.source).section('|', 0, 0)) << text;
      EXPECT_EQ(edgesOf(m.forms[i]).section('|', 1), edgesOf(m.source).section('|', 1)) << text;
    }
}

TEST_P(LanguageFile, HasEveryTextThatIsDeclared) {
  std::set<std::string> there;
  for (const Message& m : messagesOf(GetParam()))
    if (m.context == QStringLiteral("core")) there.insert(m.source.toStdString());
  for (const std::string& text : declaredTexts(fullRegistry(), SUREFOOT_SOURCE "/resources/robots"))
    EXPECT_TRUE(there.contains(text)) << text << ": `ninja -C build/release languages` puts it there";
}

TEST_P(LanguageFile, HasEveryTextOfTheLessons) {
  const Registry registry = fullRegistry();
  const Spoken spoken(GetParam());
  const auto all = lessonsIn(registry, SUREFOOT_SOURCE "/resources/lessons", lessonInLanguage);
  const auto english = lessonsIn(registry, SUREFOOT_SOURCE "/resources/lessons");
  ASSERT_GT(all.size(), 10u);
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_TRUE(all[i].lesson && all[i].complaints.empty()) << all[i].path;
    EXPECT_NE(all[i].lesson->title, english[i].lesson->title);
    for (std::size_t s = 0; s < all[i].lesson->steps.size(); ++s)
      EXPECT_NE(all[i].lesson->steps[s].say.between, english[i].lesson->steps[s].say.between) << all[i].path << s + 1;
  }
  std::set<std::string> there;
  for (const Message& m : messagesOf(GetParam()))
    if (m.context == QStringLiteral("lessons")) there.insert(m.source.toStdString());
  EXPECT_EQ(there, lessonTexts(registry, SUREFOOT_SOURCE "/resources/lessons"));
}

INSTANTIATE_TEST_SUITE_P(Languages, LanguageFile, testing::Values("nl", "de"));

TEST(Languages, EnglishHasFormsForOneAndMany) {
  for (const Message& m : messagesOf(QStringLiteral("en"))) {
    EXPECT_TRUE(m.numbered && m.finished && m.forms.size() == 2) << m.source.toStdString();
    EXPECT_EQ(m.forms.value(1), m.source);
  }
  EXPECT_EQ(episodesText(1).toStdString(), "1 episode");
  EXPECT_EQ(episodesText(12345).toStdString(), "12,345 episodes");
}

TEST(Languages, AreChosenByThePersonsOrder) {
  EXPECT_EQ(spokenOf({"fr-FR", "de-AT", "nl"}).toStdString(), "de");
  EXPECT_EQ(spokenOf({"nl_BE"}).toStdString(), "nl");
  EXPECT_EQ(spokenOf({"en-GB", "nl"}).toStdString(), "en");
  EXPECT_EQ(spokenOf({"C"}).toStdString(), "en");
  EXPECT_EQ(spokenOf({}).toStdString(), "en");
}

TEST(Languages, OfTheCommandLineAreThoseOfTheWindow) {
  ASSERT_EQ(OpenLine::languages().size(), languages().size());
  for (std::size_t i = 0; i < languages().size(); ++i)
    EXPECT_EQ(OpenLine::languages()[i], languages()[i].code.toStdString());
}

TEST(FromCore, TranslatesWhatIsComposedByItsParts) {
  const Spoken spoken("nl");
  const QString angle = fromCore("Pole angle");
  EXPECT_NE(angle.toStdString(), "Pole angle");
  EXPECT_EQ(fromCore("Q⁺ Pole angle, from"), "Q⁺ " + angle + QCoreApplication::translate("core", ", from"));
  EXPECT_EQ(fromCore("a title of one's own").toStdString(), "a title of one's own");
  EXPECT_TRUE(fromCore("").isEmpty());
}

TEST(FromCore, WritesWhatAParameterTakes) {
  const Parameter number{.key = "x", .low = 0.5, .high = 1000};
  EXPECT_EQ(allowedText(number).toStdString(), allowedValues(number));
  const Parameter choice{.key = "y", .kind = Kind::Choice, .choices = {"one", "two", "three"}};
  EXPECT_EQ(allowedText(choice).toStdString(), "one, two or three");
  EXPECT_EQ(allowedValues(choice), "one of one, two or three");
  const Spoken spoken("de");
  EXPECT_EQ(valueText(number, 0.75).toStdString(), "0,75");
  EXPECT_EQ(valueText(number, -1.5).toStdString(), "−1,5");
}

TEST(Spoken, QtsOwnWordsAreTranslatedToo) {
  const Spoken spoken("nl");
  EXPECT_FALSE(QCoreApplication::translate("QPlatformTheme", "Cancel").isEmpty());
  EXPECT_NE(QCoreApplication::translate("QPlatformTheme", "Cancel").toStdString(), "Cancel");
}

}  // namespace surefoot
