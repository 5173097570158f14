// SPDX-License-Identifier: GPL-3.0-or-later
// What comes from outside is shown to the letter: no HTML, no mnemonics. And the words that the window explains.
#include "ui/support/plain_text.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <QTextDocument>
#include <QToolButton>
#include <filesystem>
#include <fstream>

#include "tests/ui/window_setup.h"
#include "ui/controls/message_bar.h"
#include "ui/window/words_dialog.h"

namespace surefoot {

namespace {

const QString kHostile = QStringLiteral("<img src='x'>a&b <b>bold</b>");

/// What Qt would show of a text in a tooltip.
QString shownAsTip(const QString& tip) {
  if (!Qt::mightBeRichText(tip)) return tip;
  QTextDocument document;
  document.setHtml(tip);
  return document.toPlainText();
}

}  // namespace

TEST(PlainText, ATooltipShowsEveryTextToTheLetter) {
  for (const QString& text : {kHostile, QStringLiteral("plain"), QStringLiteral("a & b"), QString(200, 'x') + kHostile,
                              QStringLiteral("two\nlines <i>")})
    EXPECT_EQ(shownAsTip(tipText(text)), text) << text.toStdString();
}

TEST(PlainText, NoLabelOfTheWindowTakesHtml) {
  Window w;
  w.window->messages().say(kHostile);
  w.window->messages().ensurePolished();
  int labels = 0;
  for (QLabel* label : w.window->findChildren<QLabel*>()) {
    label->ensurePolished();
    const bool ours = label->textFormat() == Qt::RichText;  // the sentence of results, whose names are escaped
    if (!ours) {
      EXPECT_EQ(label->textFormat(), Qt::PlainText) << label->text().toStdString();
    }
    labels += label->text() == kHostile;
  }
  EXPECT_EQ(labels, 1) << "the bar shows what it was told";
}

TEST(PlainText, ALabelThatIsMadeLaterTakesNoneEither) {
  QLabel label(kHostile);
  label.ensurePolished();
  EXPECT_EQ(label.textFormat(), Qt::PlainText);
}

TEST(PlainText, RecentFilesAreShownWithTheirAmpersands) {
  Window w;
  QSettings().setValue("recent", QStringList{"/tmp/a&b <i>.surefoot"});
  for (QMenu* menu : w.window->findChildren<QMenu*>()) {
    Q_EMIT menu->aboutToShow();
    for (const QAction* action : menu->actions())
      if (action->text().contains("surefoot") && action->text().contains("/tmp")) {
        EXPECT_EQ(action->text(), "/tmp/a&&b <i>.surefoot");
      }
  }
  QSettings().remove("recent");
}

// A tooltip is a sentence of the program's own, or goes through tipText; those of actions are shown by BarButton.
TEST(PlainText, EveryTooltipInTheSourcesIsSafe) {
  static const QRegularExpression call(R"(setToolTip\(("(\\.|[^"\\])*"|[^;"])*;)"), literal(R"("(\\.|[^"\\])*"|\s)");
  int calls = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SUREFOOT_SOURCE "/ui")) {
    if (entry.path().extension() != ".cpp" || entry.path().filename().string().starts_with("main_window")) continue;
    std::ifstream in(entry.path());
    const QString text = QString::fromStdString({std::istreambuf_iterator<char>(in), {}});
    for (auto matches = call.globalMatch(text); matches.hasNext(); ++calls) {
      const QString statement = matches.next().captured();
      QString code = statement;
      code.remove(literal);
      const bool own = code == "setToolTip(tr());" || code == "setToolTip(tip);" || code == "setToolTip({});";
      EXPECT_TRUE(own || code.contains("tipText(") || code.contains("tipOf("))
          << entry.path().filename() << ": " << statement.toStdString();
    }
  }
  EXPECT_GT(calls, 10);
}

TEST(Words, AreOneClickAwayFromTheToolbar) {
  Window w;
  auto* ask = w.named<QToolButton>("What do these words mean?");
  ASSERT_TRUE(ask && ask->isVisible());
  auto* menu = ask->findChild<QMenu*>();
  Q_EMIT menu->aboutToShow();
  QStringList offered;
  for (QAction* action : menu->actions()) offered << action->text();
  EXPECT_TRUE(offered.contains("TRL")) << offered.join(", ").toStdString();
  EXPECT_TRUE(offered.contains("Sarsa"));
  for (QAction* action : menu->actions())
    if (action->text() == "TRL") action->trigger();
  auto* dialog = w.window->findChild<WordsDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  QString all;
  for (const QLabel* label : dialog->findChildren<QLabel*>()) all += label->text() + '\n';
  for (const char* part : {"TRL", "A⁺", "thesis, section 4.1"}) EXPECT_TRUE(all.contains(part)) << all.toStdString();
}

TEST(Words, CanBeSearched) {
  WordsDialog dialog;
  auto* list = dialog.findChild<QListWidget*>();
  auto* search = dialog.findChild<QLineEdit*>();
  const auto shown = [&] {
    QStringList titles;
    for (int i = 0; i < list->count(); ++i)
      if (!list->item(i)->isHidden()) titles << list->item(i)->text();
    return titles;
  };
  EXPECT_GT(shown().size(), 25);
  search->setText("n*");
  EXPECT_TRUE(shown().contains("Rule of thumb")) << shown().join(", ").toStdString();
  EXPECT_LT(shown().size(), 6);
  search->setText("SOFTMAX");
  EXPECT_TRUE(shown().contains("Softmax"));
  search->setText("zebra");
  EXPECT_TRUE(shown().isEmpty());
  search->clear();
  EXPECT_GT(shown().size(), 25);
}

}  // namespace surefoot
