// SPDX-License-Identifier: GPL-3.0-or-later
// A monkey at the window: random clicks, drags, wheels, keys and numbers, the same ones every time. It must not crash,
// no single input may hold the window up, and none may end a life that learned something unsaved without undo or a
// question. SUREFOOT_MONKEY is the number of inputs, SUREFOOT_MONKEY_SEED which ones.
#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTimer>
#include <QWheelEvent>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include "core/basics/cpu_time.h"
#include "core/basics/random.h"
#include "tests/ui/window_setup.h"
#include "ui/controls/message_bar.h"
#include "ui/live/live_page.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

class Monkey {
 public:
  Monkey(MainWindow& window, std::uint64_t seed) : window_(window), random_(seed) {}

  QString last;  ///< the last input, in a word

  void act() {
    last = "nothing";
    switch (below(8)) {
      case 0:
      case 1:
        return click();
      case 2:
        return drag();
      case 3:
        return wheel();
      case 4:
        return type();
      case 5:
        return trigger();
      default:
        return press();
    }
  }

 private:
  int below(int n) { return static_cast<int>(random_.uniform() * n); }

  QWidget* someWidget() {
    QList<QWidget*> shown;
    for (QWidget* w : window_.findChildren<QWidget*>())
      if (w->isVisible() && w->isEnabled() && w->window() == &window_) shown << w;
    return shown.isEmpty() ? &window_ : shown[below(static_cast<int>(shown.size()))];
  }
  QPoint somewhere(const QWidget& w) { return {below(std::max(1, w.width())), below(std::max(1, w.height()))}; }

  void click() {
    QWidget* w = someWidget();
    if (qobject_cast<QMenuBar*>(w) || qobject_cast<QComboBox*>(w)) return;  // their menus wait for an answer
    if (auto* button = qobject_cast<QAbstractButton*>(w); button && button->property("popupMode").isValid()) return;
    const auto modifiers = below(4) == 0 ? Qt::ShiftModifier : Qt::NoModifier;
    last = QString("click on ") + w->metaObject()->className() + " " + w->accessibleName();
    QTest::mouseClick(w, below(5) == 0 ? Qt::RightButton : Qt::LeftButton, modifiers, somewhere(*w));
  }
  void drag() {
    QWidget* w = someWidget();
    if (qobject_cast<QMenuBar*>(w) || qobject_cast<QComboBox*>(w) || qobject_cast<QAbstractButton*>(w)) return;
    last = QString("drag on ") + w->metaObject()->className() + " " + w->accessibleName();
    QTest::mousePress(w, Qt::LeftButton, {}, somewhere(*w));
    for (int i = 0; i < 4; ++i) QTest::mouseMove(w, somewhere(*w));
    QTest::mouseRelease(w, Qt::LeftButton, {}, somewhere(*w));
  }
  void wheel() {
    QWidget* w = someWidget();
    last = QString("wheel on ") + w->metaObject()->className() + " " + w->accessibleName();
    const QPointF at = somewhere(*w);
    QWheelEvent event(at, w->mapToGlobal(at), {}, {0, below(2) ? 120 : -120}, Qt::NoButton, {}, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(w, &event);
  }
  void type() {
    const auto fields = window_.findChildren<QLineEdit*>();
    if (fields.isEmpty()) return;
    QLineEdit* field = fields[below(static_cast<int>(fields.size()))];
    if (!field->isVisible() || !field->isEnabled()) return;
    static const char* const kTexts[] = {"0",   "1", "-1",  "0.5",    "1e9",  "nan",
                                         "inf", "",  "abc", "1e-300", "12,5", "9999999999999999999999"};
    const char* const text = kTexts[below(std::size(kTexts))];
    last = QString("typing %1 in %2").arg(text, field->accessibleName());
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
  }
  void press() {
    static constexpr int kKeys[] = {Qt::Key_Space, Qt::Key_Period, Qt::Key_Left, Qt::Key_Right,  Qt::Key_Up,
                                    Qt::Key_Down,  Qt::Key_T,      Qt::Key_R,    Qt::Key_C,      Qt::Key_Plus,
                                    Qt::Key_Minus, Qt::Key_Tab,    Qt::Key_Home, Qt::Key_Return, Qt::Key_Escape,
                                    Qt::Key_F1,    Qt::Key_Z};
    const auto key = static_cast<Qt::Key>(kKeys[below(std::size(kKeys))]);
    const auto modifiers = key == Qt::Key_Z ? Qt::ControlModifier : below(5) == 0 ? Qt::ShiftModifier : Qt::NoModifier;
    last = "key " + QKeySequence(key).toString();
    QWidget* focus = window_.focusWidget();
    QTest::keyClick(focus ? focus : &window_, key, modifiers);
  }
  void trigger() {
    QList<QAction*> actions;
    for (QAction* action : window_.findChildren<QAction*>())
      if (action->isEnabled() && !action->menu() && !action->text().contains("Quit")) actions << action;
    // A new session now and then, not all the time.
    QAction* action = actions[below(static_cast<int>(actions.size()))];
    last = "menu: " + action->text();
    action->trigger();
  }

  MainWindow& window_;
  Random random_;
};

/// Sees to it that every life that learned something unsaved is within reach of undo when another one takes its place,
/// or that a question was answered so.
class Witness {
 public:
  explicit Witness(Window& w) : session_(*w.session) {
    QObject::connect(&session_.looking(), &Looking::frame, w.window.get(), [this] { note(); });
    session_.history().setAskBeforeEnding(
        [this, ask = session_.history().askBeforeEnding()](const auto& kept, const History::GoOn& goOn) {
          ask(kept, [this, running = !kept, goOn] {
            if (running) ++answered_;
            goOn();
          });
        });
    QObject::connect(&session_.life(), &RunningLife::replaced, w.window.get(), [this] {
      if (std::exchange(answered_, 0) == 0 && unsaved_) ++ended_;
      note();
    });
    for (auto signal : {&History::lifeKept, &History::lifeBroughtBack})
      QObject::connect(&session_.history(), signal, w.window.get(), [this] {
        if (ended_ > 0) --ended_, ++kept_;
      });
    note();
  }
  int ended() const { return ended_; }  ///< for good
  int kept() const { return kept_; }

 private:
  void note() { unsaved_ = session_.life().unsaved(); }

  Session& session_;
  bool unsaved_ = false;
  int ended_ = 0, kept_ = 0, answered_ = 0;
};

int fromEnvironment(const char* name, int otherwise) {
  bool good = false;
  const int value = qEnvironmentVariableIntValue(name, &good);
  return good ? value : otherwise;
}

}  // namespace

TEST(Monkey, DoesNotBreakTheWindow) {
  Window w;
  Monkey monkey(*w.window, static_cast<std::uint64_t>(fromEnvironment("SUREFOOT_MONKEY_SEED", 1)));
  const int inputs = fromEnvironment("SUREFOOT_MONKEY", 400);
  Witness witness(w);
  std::map<qint64, QString, std::greater<>> longest;  // [ms]
  QTimer closer;                                      // a menu has an event loop of its own, which would wait for ever
  QObject::connect(&closer, &QTimer::timeout, [] {
    if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
  });
  closer.start(5);
  for (int i = 0; i < inputs; ++i) {
    QElapsedTimer timer;
    timer.start();
    const double cpu = threadCpuSeconds();
    monkey.act();
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    longest[timer.elapsed()] =
        QString("%1 (%2 ms of the processor)").arg(monkey.last).arg(1000 * (threadCpuSeconds() - cpu), 0, 'f', 0);
    if (longest.size() > 5) longest.erase(std::prev(longest.end()));
    for (auto* dialog : w.window->findChildren<QDialog*>()) dialog->close();
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // as the loop of the program does
    ASSERT_EQ(witness.ended(), 0) << "a life that was not saved is gone: " << monkey.last.toStdString();
    if (i % 50 == 0 && w.session->life().unsaved()) {
      w.window->close();
      ASSERT_TRUE(w.window->isVisible()) << "quitting asks";
      while (w.window->messages().cancel()) {
      }  // all of them: one that stays may be answered by a click
    }
    if (w.window->isFullScreen()) w.window->showNormal();
  }
  std::printf("lives kept for undo: %d\n", witness.kept());
  for (const auto& [wait, what] : longest)
    std::printf("longest wait for the window: %lld ms: %s\n", static_cast<long long>(wait), qPrintable(what));
  w.key(Qt::Key_Escape);
  w.window->setPage(0);
  ASSERT_TRUE(w.session->newLives().beginEnvironment("pendulum"));
  w.session->life().setRunning(true);
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps > 10; })) << "it still learns";
  applyAppearance(*qApp, Appearance::Light);
}

}  // namespace surefoot
