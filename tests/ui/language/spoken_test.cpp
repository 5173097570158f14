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
#include "ui/controls/message_bar.h"
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

/// Words that are the same in every language: units, signs, keys, functions, names of files and of parameters.
bool isWords(const QString& rest) {
  static const QRegularExpression kWord(QStringLiteral("[A-Za-z]{3,}"));
  static const QRegularExpression kSame(
      QStringLiteral("\\b(rad|min|sin|cos|exp|max|mod|hash|sign|Nms|kgm|Esc|Tab|Ctrl|Shift|Alt|Space|Home|End|PgUp|"
                     "PgDown|Return|Enter|Left|Right|Up|Down|Del|"
                     "English|Nederlands|Deutsch)\\b|surefoot "
                     "[^\n]*|[\\w./-]*/[\\w./-]+|[a-z_]+\\.[a-z_.]+|[\\w-]+\\.(toml|sqlite|safetensors)"));
  QString bare = rest;
  return bare.remove(kSame).contains(kWord);
}

/// A number that a file could have: "0.5", but not "section 3.1" or "Box2D 2.4.1".
bool hasPoint(QString text) {
  static const QRegularExpression kNoNumber(
      QStringLiteral("\\pL+\\.? [0-9.]+|surefoot .*|[0-9]+(\\.[0-9]+){2,}|<[^>]*>"));
  static const QRegularExpression kPoint(QStringLiteral("[0-9]\\.[0-9]"));
  return text.remove(kNoNumber).contains(kPoint);
}

/// The numbers that a window shows as a file would have them.
void addPoints(QWidget& window, std::set<std::string>& found) {
  const auto note = [&](const QWidget& w, const QString& text) {
    if (hasPoint(text)) found.insert((nameOf(w) + ": " + text).toStdString());
  };
  for (QWidget* w : window.findChildren<QWidget*>()) {
    if (!w->isVisible() || w->window() != &window || w->size().isEmpty()) continue;
    if (const auto* label = qobject_cast<QLabel*>(w)) note(*w, label->text());
    if (const auto* field = qobject_cast<QLineEdit*>(w)) note(*w, field->text());
    if (const auto* table = qobject_cast<QTableView*>(w); table && table->model())
      for (int row = 0; row < table->model()->rowCount(); ++row)
        for (int c = 0; c < table->model()->columnCount(); ++c)
          note(*w, table->model()->index(row, c).data().toString());
    if (!QString(w->metaObject()->className()).startsWith("surefoot::")) continue;
    auto* area = qobject_cast<QAbstractScrollArea*>(w);
    for (const DrawnText& drawn : drawnTexts(area ? *area->viewport() : *w)) note(*w, drawn.text);
  }
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

constexpr const char* kDialogs[] = {"Rob&ustness …", "&Shortcuts", "Pre&ferences …",
                                    "&Words",        "Fil&m …",    "&Pre-learn, then transfer …"};

/// Every page and the dialogs on every screen; each is opened there.
template <class Look>
void everywhere(Window& w, const std::vector<Screen>& screens, Look look) {
  const auto onEach = [&](const auto& open) {
    for (const Screen& screen : screens) {
      applyTextSize(screen.text);
      w.window->resize(screen.size);
      w.window->messages().dismiss();
      open(screen);
    }
  };
  const auto lookAtWindow = [&](const Screen& screen) {
    QTest::qWait(30);
    look(*w.window, screen);
  };
  for (const char* environment : {"pendulum", "leo"}) {
    ASSERT_NO_FATAL_FAILURE(live(w, environment));
    LivePage& page = w.window->livePage();
    onEach([&](const Screen& screen) {
      page.resetLayout();
      lookAtWindow(screen);
      for (const auto layout : {LivePage::Layout::Teaching, LivePage::Layout::Falls, LivePage::Layout::Maps}) {
        page.useLayout(layout);
        lookAtWindow(screen);
      }
      page.resetLayout();
      page.setComparing(true);
      lookAtWindow(screen);
      page.setComparing(false);
    });
  }
  for (const char* name : kDialogs)
    onEach([&](const Screen& screen) {
      QDialog* dialog = openDialog(w, name);
      if (!dialog) return;
      dialog->resize(dialog->size().boundedTo(screen.size - QSize(16, 40)));
      QTest::qWait(20);
      look(*dialog, screen);
      dialog->close();
      QApplication::sendPostedEvents(dialog, QEvent::DeferredDelete);
    });
  for (const int number : {1, 2, 3}) {
    w.window->setPage(number);
    QTest::qWait(200);
    onEach(lookAtWindow);
  }
}

class InLanguage : public testing::TestWithParam<const char*> {};

}  // namespace

TEST(Untranslated, NoTextIsLeftInEnglish) {
  const UsualLook usual;
  Marking marking;
  QCoreApplication::installTranslator(&marking);
  Texts texts;
  {
    Window w;
    everywhere(w, {kScreens[0]}, [&](QWidget& window, const Screen&) { texts.addAll(window); });
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
  std::set<std::string> points;
  {
    Window w;
    everywhere(w, {kScreens[0], kScreens[2]}, [&](QWidget& window, const Screen& screen) {
      addPoints(window, points);
      expectReadable(window, QStringLiteral("%1 %2, %3").arg(GetParam(), nameOf(window), textOf(screen)));
    });
  }
  QCoreApplication::removeTranslator(&missing);
  for (const std::string& text : points) ADD_FAILURE() << "a number with a point: " << text;
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
