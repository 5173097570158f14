// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/about/about_dialog.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QListWidget>
#include <QTextBrowser>

#include "tests/ui/window_setup.h"

namespace surefoot {

namespace {
AboutFacts facts() {
  return {{{"Surefoot", "9.8.7"}, {"Qt", "6.4.2"}},
          QStringLiteral(SUREFOOT_SOURCE) + QStringLiteral("/resources/about")};
}
}  // namespace

TEST(About, ShowsVersionsAndThePagesThatComeWithTheProgram) {
  AboutDialog dialog(facts());
  auto* list = dialog.findChild<QListWidget*>();
  auto* text = dialog.findChild<QTextBrowser*>();
  ASSERT_TRUE(list && text);
  QStringList titles;
  const std::map<QString, QString> holds = {{"Surefoot", "without any warranty"},
                                            {"Versions", "Qt 6.4.2"},
                                            {"Citing", "cff-version"},
                                            {"Contributing", "Copy the versions"},
                                            {"Security", "A file never runs anything."}};
  for (int i = 0; i < list->count(); ++i) {
    list->setCurrentRow(i);
    titles << list->item(i)->text();
    EXPECT_TRUE(text->toPlainText().contains(holds.at(titles.last()))) << text->toPlainText().toStdString();
  }
  EXPECT_EQ(titles, QStringList({"Surefoot", "Versions", "Citing", "Contributing", "Security"}));
}

TEST(About, CopiesTheVersions) {
  AboutDialog dialog(facts());
  for (auto* button : dialog.findChildren<QAbstractButton*>())
    if (button->text() == "Copy the versions") button->click();
  EXPECT_EQ(QApplication::clipboard()->text(), "Surefoot 9.8.7\nQt 6.4.2\n");
}

TEST(About, LeavesOutPagesThatAreNotThere) {
  AboutDialog dialog({{{"Surefoot", "9.8.7"}}, "/nowhere"});
  EXPECT_EQ(dialog.findChild<QListWidget*>()->count(), 2);
}

}  // namespace surefoot
