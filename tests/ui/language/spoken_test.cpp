// SPDX-License-Identifier: GPL-3.0-or-later
// The window in other languages: no text is left in English, none is cut.
#include <QAbstractButton>
#include <QComboBox>
#include <QDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTabBar>
#include <QTableView>
#include <QTranslator>
#include <map>
#include <set>

#include "tests/ui/language/spoken.h"
#include "tests/ui/window/size_setup.h"
#include "tests/ui/window/text_recorder.h"
#include "ui/live/live_page.h"

namespace surefoot {

namespace {

constexpr QChar kOpen(0x27E6), kClose(0x27E7);  // ⟦ ⟧

/// A language in which every text that is translated is marked.
class Marking final : public QTranslator {
 public:
  bool isEmpty() const override { return false; }
  QString translate(const char*, const char* text, const char*, int) const override {
    return kOpen + QString::fromUtf8(text) + kClose;
  }
};

/// Notes which texts of ours a language does not have under the context in which they are asked for.
class Missing final : public QTranslator {
 public:
  explicit Missing(const QString& code) { EXPECT_TRUE(language_.load(":/languages/surefoot_" + code)); }
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* text, const char* comment, int n) const override {
    const QString found = language_.translate(context, text, comment, n);
    const std::string_view of = context;
    if (found.isEmpty() && (of.starts_with("surefoot") || of == "QObject")) texts.insert(std::string(of) + ": " + text);
    return found;
  }
  mutable std::set<std::string> texts;

 private:
  QTranslator language_;
};

/// What stands outside of the marks. `depth` goes on from one text to the next, as lines of a text are drawn apart.
QString outside(const QString& text, int& depth) {
  QString rest;
  for (const QChar c : text) {
    if (c == kClose)
      depth = std::max(0, depth - 1);
    else if (c == kOpen)
      ++depth;
    else if (depth == 0)
      rest += c;
  }
  if (text.endsWith(QChar(0x2026))) depth = 0;  // cut short; its end is not drawn
  return rest;
}

/// Words that are the same in every language: units, signs, keys, names of files and of parameters.
bool isWords(const QString& rest) {
  static const QRegularExpression kWord(QStringLiteral("[A-Za-z]{3,}"));
  static const QRegularExpression kSame(QStringLiteral(
      "\\b(rad|min|Nms|kgm|Esc|Tab|Ctrl|Shift|Alt|Space|Home|End|PgUp|PgDown|Return|Enter|Left|Right|Up|Down|Del|"
      "English|Nederlands|Deutsch)\\b|[\\w./-]*/[\\w./-]+|[a-z_]+\\.[a-z_.]+|[\\w-]+\\.(toml|sqlite|safetensors)"));
  QString bare = rest;
  return bare.remove(kSame).contains(kWord);
}

class Texts {
 public:
  void add(const QWidget& w, const char* part, const QString& text) {
    int depth = 0;
    add(w, part, text, depth);
  }
  void add(const QWidget& w, const char* part, const QString& text, int& depth) {
    const QString rest = outside(QString(text).remove('&'), depth);
    if (isWords(rest)) left.insert((nameOf(w) + ", " + part + ": " + text).toStdString());
  }
  void addAll(QWidget& window) {
    QList<QWidget*> widgets = window.findChildren<QWidget*>();
    widgets.prepend(&window);
    for (QWidget* w : widgets)
      if (w->isVisible() && w->window() == &window && !w->size().isEmpty()) addOne(*w);
    for (const QAction* action : window.findChildren<QAction*>()) {
      add(window, "menu", action->text());
      add(window, "tip of a menu", action->toolTip());
    }
  }
  std::set<std::string> left;

 private:
  void addOne(QWidget& w) {
    add(w, "name", w.accessibleName());
    add(w, "tip", QString(w.toolTip()).remove(QRegularExpression(QStringLiteral("<[^>]*>"))));
    if (w.isWindow()) add(w, "title", w.windowTitle());
    if (const auto* label = qobject_cast<QLabel*>(&w)) add(w, "text", label->text());
    if (const auto* button = qobject_cast<QAbstractButton*>(&w)) add(w, "text", button->text());
    if (const auto* field = qobject_cast<QLineEdit*>(&w)) add(w, "place-holder", field->placeholderText());
    if (const auto* combo = qobject_cast<QComboBox*>(&w))
      for (int i = 0; i < combo->count(); ++i) add(w, "entry", combo->itemText(i));
    if (const auto* tabs = qobject_cast<QTabBar*>(&w))
      for (int i = 0; i < tabs->count(); ++i) add(w, "tab", tabs->tabText(i));
    if (const auto* table = qobject_cast<QTableView*>(&w); table && table->model())
      for (int c = 0; c < table->model()->columnCount(); ++c)
        add(w, "head", table->model()->headerData(c, Qt::Horizontal).toString());
    if (!QString(w.metaObject()->className()).startsWith("surefoot::") || w.isWindow()) return;
    auto* area = qobject_cast<QAbstractScrollArea*>(&w);
    int depth = 0;
    for (const DrawnText& drawn : drawnTexts(area ? *area->viewport() : w)) add(w, "drawn", drawn.text, depth);
  }
};

void learn(Window& w, const std::string& environment) {
  const auto life = w.session->life().snapshot().life;
  ASSERT_TRUE(w.session->newLives().beginEnvironment(environment));
  ASSERT_TRUE(
      w.waitFor([&] { return w.session->life().snapshot().life > life && w.session->life().values(); }, 30'000));
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().totals.episodes > 12; }, 30'000));
  w.session->life().setRunning(false);
  QTest::qWait(100);
}

/// The dialog behind an entry of the menus.
QDialog* openDialog(Window& w, const char* menuItem) {
  for (QAction* action : w.window->findChildren<QAction*>())
    if (action->text() == QCoreApplication::translate("surefoot::MainWindow", menuItem)) action->trigger();
  QTest::qWait(50);
  for (auto* dialog : w.window->findChildren<QDialog*>())
    if (dialog->isVisible()) return dialog;
  ADD_FAILURE() << menuItem;
  return nullptr;
}

void closeDialog(QDialog& dialog) {
  dialog.close();
  QApplication::sendPostedEvents(&dialog, QEvent::DeferredDelete);
}

constexpr const char* kDialogs[] = {"Rob&ustness …", "&Shortcuts", "Pre&ferences …",
                                    "&Words",        "Fil&m …",    "&Pre-learn, then transfer …"};

/// Every page and the dialogs, once each.
template <class Look>
void everywhere(Window& w, Look look) {
  for (const char* environment : {"pendulum", "leo"}) {
    ASSERT_NO_FATAL_FAILURE(learn(w, environment));
    look(*w.window);
    w.window->livePage().setComparing(true);
    QTest::qWait(50);
    look(*w.window);
    w.window->livePage().setComparing(false);
    for (const auto layout : {LivePage::Layout::Teaching, LivePage::Layout::Falls, LivePage::Layout::Maps}) {
      w.window->livePage().useLayout(layout);
      QTest::qWait(50);
      look(*w.window);
    }
    w.window->livePage().resetLayout();
  }
  for (const char* name : kDialogs)
    if (QDialog* dialog = openDialog(w, name)) {
      look(*dialog);
      closeDialog(*dialog);
    }
  for (const int page : {1, 2, 3}) {
    w.window->setPage(page);
    QTest::qWait(200);
    look(*w.window);
  }
}

class InLanguage : public testing::TestWithParam<const char*> {};

}  // namespace

TEST(Untranslated, NoTextIsLeftInEnglish) {
  Marking marking;
  QCoreApplication::installTranslator(&marking);
  Texts texts;
  {
    Window w;
    everywhere(w, [&](QWidget& window) { texts.addAll(window); });
  }
  QCoreApplication::removeTranslator(&marking);
  for (const std::string& text : texts.left) ADD_FAILURE() << text;
}

TEST(Untranslated, ATextThatIsLeftIsFound) {
  QWidget window;
  auto* label = new QLabel(QStringLiteral("⟦marked %1⟧ and not").arg(QStringLiteral("⟦nested⟧")), &window);
  window.show();
  Texts texts;
  texts.addAll(window);
  EXPECT_EQ(texts.left.size(), 1u);
  label->setText(QStringLiteral("⟦all of it⟧ 12 rad"));
  texts.left.clear();
  texts.addAll(window);
  EXPECT_TRUE(texts.left.empty());
}

TEST_P(InLanguage, EveryTextIsFoundAndFitsItsPlace) {
  const UsualLook usual;
  const Spoken spoken(GetParam());
  Missing missing(QString::fromLatin1(GetParam()));
  QCoreApplication::installTranslator(&missing);
  {
    Window w;
    everywhere(w, [&](QWidget& window) {
      const bool dialog = &window != w.window.get();
      for (const Screen& screen : {kScreens[0], kScreens[2]}) {
        applyTextSize(screen.text);
        const QSize room = screen.size - (dialog ? QSize(16, 40) : QSize());
        window.resize(dialog ? window.size().boundedTo(room) : room);
        QTest::qWait(30);
        expectReadable(window, QStringLiteral("%1 %2, %3").arg(GetParam(), nameOf(window), textOf(screen)));
      }
    });
  }
  QCoreApplication::removeTranslator(&missing);
  for (const std::string& text : missing.texts) ADD_FAILURE() << "not in the language under this context: " << text;
}

TEST_P(InLanguage, NoMenuHasAKeyTwice) {
  const Spoken spoken(GetParam());
  Window w;
  const auto check = [](const QList<QAction*>& actions, const QString& menu) {
    std::map<QChar, QString> keys;
    for (const QAction* action : actions) {
      const qsizetype at = QString(action->text()).replace("&&", "  ").indexOf('&');
      if (at < 0 || !action->isVisible()) continue;
      const auto [other, fresh] = keys.emplace(action->text()[at + 1].toLower(), action->text());
      EXPECT_TRUE(fresh) << menu.toStdString() << ": " << action->text().toStdString() << " and "
                         << other->second.toStdString();
    }
  };
  check(w.window->menuBar()->actions(), "menus");
  for (const QMenu* menu : w.window->findChildren<QMenu*>()) check(menu->actions(), menu->title());
}

INSTANTIATE_TEST_SUITE_P(Languages, InLanguage, testing::Values("nl", "de"));

}  // namespace surefoot
