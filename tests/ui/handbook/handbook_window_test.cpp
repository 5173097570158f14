// SPDX-License-Identifier: GPL-3.0-or-later
// The handbook as a person uses it: by F1, by the "?" of a panel, by searching, by keys alone.
#include "ui/handbook/handbook_window.h"

#include <QLineEdit>
#include <QScrollBar>
#include <QTextDocument>
#include <QTreeWidget>
#include <QUrl>

#include "core/handbook/handbook.h"
#include "tests/ui/language/spoken.h"
#include "tests/ui/window/size_setup.h"
#include "ui/controls/header_button.h"
#include "ui/controls/message_bar.h"
#include "ui/controls/panel.h"
#include "ui/handbook/handbook_browser.h"
#include "ui/handbook/handbook_contents.h"
#include "ui/language/speech.h"
#include "ui/live/live_page.h"
#include "ui/support/help.h"

namespace surefoot {

namespace {

/// A window that has its handbook.
struct Reader {
  Reader() {
    WindowSetup setup;
    setup.handbook = [this] {
      return makeHandbook(registry, SUREFOOT_SOURCE "/resources/handbook", {{.name = "train", .summary = "learn"}},
                          handbookInLanguage());
    };
    setup.pictures = QStringLiteral(SUREFOOT_SOURCE "/resources/screenshots");
    setup.lessons = QStringLiteral(SUREFOOT_SOURCE "/resources/lessons");
    window = std::make_unique<MainWindow>(*session, std::move(setup));
    window->resize(1280, 800);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    window->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window.get()));
  }
  /// Opens a page and waits until keys go to the handbook.
  void read(const QString& page) {
    window->showHandbook(page);
    EXPECT_TRUE(QTest::qWaitForWindowActive(window->handbook()));
    QTest::qWait(30);
  }
  HandbookBrowser& browser() { return window->handbook()->browser(); }
  HandbookContents& contents() { return window->handbook()->contents(); }
  QString page() { return window->handbook() ? browser().page() : QString(); }
  QLineEdit* field() { return contents().findChild<QLineEdit*>(); }

  Registry registry = fullRegistry();
  std::unique_ptr<Session> session = std::make_unique<Session>(registry, pendulumConfiguration(registry, "trl"), false);
  std::unique_ptr<MainWindow> window;
};

}  // namespace

TEST(HandbookWindow, F1OpensThePageOfWhatHasTheFocus) {
  Reader r;
  QTest::keyClick(r.window.get(), Qt::Key_F1);
  EXPECT_EQ(r.page(), "panel-world") << "which has the focus at first";
  EXPECT_TRUE(r.window->handbook()->isVisible());
  for (const auto& [page, name] : {std::pair{1, "page-experiment"}, {2, "page-lessons"}, {3, "page-robot"}}) {
    r.window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(r.window.get()));
    r.window->setPage(page);
    r.window->showHandbook();
    EXPECT_EQ(r.page(), name);
  }
}

TEST(HandbookWindow, EveryPanelsQuestionMarkOpensItsPage) {
  Reader r;
  for (Panel* panel : r.window->livePage().panels()) {
    panel->show();
    panel->raise();
    auto* help = panel->header().findChild<HelpButton*>();
    ASSERT_TRUE(help) << panel->objectName().toStdString();
    EXPECT_TRUE(help->accessibleName().contains(panel->windowTitle())) << help->accessibleName().toStdString();
    help->click();
    EXPECT_EQ(r.page(), "panel-" + panel->objectName());
    EXPECT_GT(r.browser().document()->characterCount(), 300);
  }
  Panel* floats = r.window->livePage().panels().back();
  floats->setFloating(true);
  r.browser().open("first-steps");
  floats->header().findChild<HelpButton*>()->click();
  EXPECT_EQ(r.page(), "panel-" + floats->objectName()) << "as a window of its own, too";
}

TEST(HandbookWindow, NoQuestionMarkLeadsNowhere) {
  Reader r;
  ASSERT_TRUE(r.window->livePage().isVisible());
  const auto handbook = makeHandbook(r.registry, SUREFOOT_SOURCE "/resources/handbook", {});
  ASSERT_TRUE(handbook);
  const auto all = r.window->findChildren<HelpButton*>();
  EXPECT_GE(all.size(), 18) << "panels, and the other pages";
  for (const HelpButton* help : all)
    EXPECT_TRUE(pageNamed(*handbook, helpPageOf(help).toStdString())) << helpPageOf(help).toStdString();
}

TEST(HandbookWindow, SearchingShowsWhatIsFoundAndReturnReadsIt) {
  Reader r;
  r.read("window");
  const auto all = r.contents().listed();
  QTest::keyClick(r.window->handbook(), Qt::Key_L, Qt::ControlModifier);
  QTest::keyClicks(r.field(), "exit codes");
  EXPECT_EQ(r.contents().listed().front(), "exit-codes");
  EXPECT_LT(r.contents().listed().size(), all.size());
  QTest::keyClick(r.field(), Qt::Key_Return);
  EXPECT_EQ(r.page(), "exit-codes");
  EXPECT_FALSE(r.browser().extraSelections().isEmpty()) << "the words are marked";
  r.contents().search("bubblewrap penguins");
  EXPECT_TRUE(r.contents().listed().isEmpty());
  r.contents().startSearch();
  QTest::keyClick(r.field(), Qt::Key_Escape);
  EXPECT_TRUE(r.field()->text().isEmpty()) << "Escape forgets the words";
  EXPECT_TRUE(r.window->handbook()->isVisible());
  EXPECT_EQ(r.contents().listed(), all);
}

TEST(HandbookWindow, GoesBackAndForwardAndFollowsItsLinks) {
  Reader r;
  r.read("window");
  r.browser().open("parameters-policy#policy.temperature");
  QTest::qWait(30);
  EXPECT_GT(r.browser().verticalScrollBar()->value(), 0) << "at the parameter";
  QTest::keyClick(r.window->handbook(), Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(r.page(), "window");
  QTest::keyClick(r.window->handbook(), Qt::Key_Right, Qt::AltModifier);
  EXPECT_EQ(r.page(), "parameters-policy");
  EXPECT_EQ(r.contents().findChild<QTreeWidget*>()->currentItem()->data(0, Qt::UserRole), "parameters-policy")
      << "the contents go along";
  r.browser().open("no-such-page");
  EXPECT_EQ(r.page(), "first-steps");
}

TEST(HandbookWindow, FindsOnThePage) {
  Reader r;
  r.read("keys");
  QTest::keyClick(r.window->handbook(), Qt::Key_F, Qt::ControlModifier);
  auto* find = r.window->handbook()->findChild<QLineEdit*>(QString(), Qt::FindChildrenRecursively);
  for (QLineEdit* each : r.window->handbook()->findChildren<QLineEdit*>())
    if (each->accessibleName() == "Find on this page") find = each;
  ASSERT_TRUE(find && find->isVisible());
  QTest::keyClicks(find, "turbo");
  EXPECT_EQ(r.browser().textCursor().selectedText().toLower(), "turbo");
  QTest::keyClick(find, Qt::Key_Escape);
  EXPECT_FALSE(find->isVisible());
  EXPECT_TRUE(r.window->handbook()->isVisible());
  QTest::keyClick(r.window->handbook(), Qt::Key_Escape);
  EXPECT_FALSE(r.window->handbook()->isVisible());
}

TEST(HandbookWindow, PicturesFitAndFetchNothing) {
  Reader r;
  r.read("first-steps");
  const QVariant picture =
      r.browser().document()->resource(QTextDocument::ImageResource, QUrl(QStringLiteral("window-light.png")));
  ASSERT_TRUE(picture.isValid());
  EXPECT_LE(picture.value<QPixmap>().width() / picture.value<QPixmap>().devicePixelRatio(),
            r.browser().viewport()->width());
  EXPECT_FALSE(r.browser()
                   .document()
                   ->resource(QTextDocument::ImageResource, QUrl(QStringLiteral("../../README.md")))
                   .isValid());
}

TEST(HandbookWindow, IsReadableAtEverySize) {
  const UsualLook usual;
  Reader r;
  r.read("first-steps");
  atEverySize(kScreens, [&](const Screen& screen, const QString& text) {
    applyTextSize(screen.text);
    r.window->handbook()->resize(screen.size.boundedTo({1280, 900}) * 0.9);
    for (const char* page : {"first-steps", "panel-maps", "plans", "parameters-policy", "results", "method-trl"}) {
      r.browser().open(page);
      QTest::qWait(30);
      expectReadable(*r.window->handbook(), QStringLiteral("%1, %2").arg(page, text));
      EXPECT_EQ(r.browser().document()->defaultFont().pixelSize(), scaledFont(13).pixelSize());
      EXPECT_EQ(r.browser().document()->textWidth(), r.browser().viewport()->width())
          << page << ", " << text.toStdString();
    }
  });
}

// Large text from the beginning on: no part of a line is cut.
TEST(HandbookWindow, LinesEndWhereThePageDoes) {
  const UsualSize usual;
  applyTextSize(1.6);
  Reader r;
  r.read("panel-world");
  EXPECT_EQ(r.browser().horizontalScrollBar()->maximum(), 0);
  EXPECT_LE(r.browser().document()->idealWidth(), r.browser().viewport()->width());
}

TEST(HandbookWindow, ItsTextSizeIsTheProgramsAndStaysAtItsPlace) {
  const UsualSize usual;
  Reader r;
  r.read("plans");
  r.browser().verticalScrollBar()->setValue(r.browser().verticalScrollBar()->maximum() / 2);
  const auto inSight = [&] { return r.browser().cursorForPosition({0, 0}).position(); };
  const int before = inSight();
  ASSERT_GT(before, 1000);
  QTest::keyClick(r.window->handbook(), Qt::Key_Plus, Qt::ControlModifier);
  EXPECT_DOUBLE_EQ(textSize(), 1.1);
  QTest::qWait(50);
  EXPECT_NEAR(inSight(), before, 150) << "letters: about a line";
  EXPECT_EQ(r.page(), "plans");
}

TEST(HandbookWindow, IsInTheLanguageOfTheWindow) {
  const Spoken spoken("nl");
  Reader r;
  r.read("panel-maps");
  EXPECT_TRUE(r.browser().toPlainText().startsWith("Waardekaarten"))
      << r.browser().toPlainText().left(60).toStdString();
  const auto* list = r.contents().findChild<QTreeWidget*>();
  EXPECT_EQ(list->topLevelItem(0)->text(0), "Eerste stappen");
  r.contents().search("bubblewrap kooi");
  EXPECT_EQ(r.contents().listed(), QStringList{"robot-programs"});
  r.read("parameters-policy#policy.epsilon");
  const QString parameters = r.browser().toPlainText();
  EXPECT_TRUE(parameters.contains("standaard 0,05")) << "with the language's numbers";
  EXPECT_TRUE(parameters.contains("Geldt meteen."));
  EXPECT_FALSE(parameters.contains("default"));
}

TEST(HandbookWindow, WithoutOneItIsSaid) {
  Window w;
  w.window->showHandbook();
  EXPECT_FALSE(w.window->handbook());
  EXPECT_TRUE(w.window->messages().isVisible());
}

}  // namespace surefoot
