// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of worlds, maps and rows: nothing struck through, nothing cut, cells where states are cells.
#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QPainter>
#include <QWheelEvent>

#include "tests/ui/pixels_of.h"
#include "tests/ui/window_setup.h"
#include "ui/live/actions/action_rows.h"
#include "ui/live/live_page.h"
#include "ui/live/maps/value_maps.h"
#include "ui/live/rival.h"
#include "ui/live/world/world_view.h"
#include "ui/style/scene_painter.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

int painted = 0;
struct PaintCounter : QObject {
  bool eventFilter(QObject*, QEvent* event) override {
    painted += event->type() == QEvent::Paint;
    return false;
  }
};

}  // namespace

TEST(ScenePainter, NoLineGoesThroughWordsOverABody) {
  Scene scene;
  scene.shapes.push_back(Label{{0, 0}, "−7.1 V", 0, 0, 0, Ink::Solid, true});
  scene.shapes.push_back(Polyline{{{-1, 0}, {1, 0}}, Ink::Fall, 3});
  QImage image(200, 100, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter p(&image);
  paintScene(scene, ScenePainter(
                        p, lightTheme(), false, [](Point at) { return QPointF(100 + 90 * at.x, 50); }, 90));
  p.end();
  EXPECT_GT(pixelsOf(image, lightTheme().fall, {20, 40, 30, 20}), 20) << "the line is there";
  EXPECT_EQ(pixelsOf(image, lightTheme().fall, {82, 40, 36, 20}), 0) << "but not behind the words";
}

TEST(ScenePainter, WordsStayInTheirBounds) {
  Scene scene;
  scene.shapes.push_back(Label{{0, 0}, "fall −0.45π", -8, 0, -1, Ink::Solid});
  QImage image(200, 40, QImage::Format_RGB32), free = image;
  const auto paint = [&](QImage& to, double left) {
    to.fill(Qt::white);
    QPainter p(&to);
    ScenePainter painter(
        p, lightTheme(), false, [left](Point) { return QPointF(left, 20); }, 90);
    painter.setBounds({0, 0, 200, 40});
    paintScene(scene, painter);
  };
  const auto ink = [](const QImage& of) {
    int count = 0;
    for (int y = 0; y < of.height(); ++y)
      for (int x = 0; x < of.width(); ++x) count += qGray(of.pixel(x, y)) < 200;
    return count;
  };
  paint(image, 30);  // would end left of the edge
  paint(free, 150);
  EXPECT_GT(ink(free), 100);
  EXPECT_NEAR(ink(image), ink(free), 0.15 * ink(free)) << "all of it";
}

TEST(SymbolText, AnUnderscoreBetweenTwoLettersIsASubscript) {
  const QFont font = textFont(13);
  EXPECT_LT(symbolWidth(font, "U_h"), symbolWidth(font, "Uh"));
  EXPECT_GT(symbolWidth(font, "U_h"), symbolWidth(font, "U"));
  EXPECT_EQ(symbolWidth(font, "swing_hip"), QFontMetricsF(font).horizontalAdvance("swing_hip")) << "a key is none";
  EXPECT_EQ(plainSymbols("U_h, a_key"), "Uh, a_key");
}

TEST(WorldView, TwoWorldsSideBySideHaveOneScale) {
  Window w("epsilon-greedy");
  w.window->livePage().setComparing(true);
  Rival* rival = w.window->livePage().rival();
  ASSERT_TRUE(rival);
  w.session->life().setRunning(true);
  const WorldView &first = w.window->livePage().world(), &second = rival->world();
  ASSERT_TRUE(w.waitFor([&] { return second.pixelsPerMetre() > 1; }));
  QTest::qWait(200);
  EXPECT_EQ(first.pixelsPerMetre(), second.pixelsPerMetre());
  EXPECT_LT(first.pixelsPerMetre() * 0.36, first.width()) << "arrows and words of the fall, too";
}

TEST(WorldView, NoZoomReachesTheReadOuts) {
  Window w;
  ASSERT_TRUE(w.waitFor([&] { return !w.session->looking().shown().pose.empty(); }));
  QTest::qWait(400);
  WorldView& world = w.window->livePage().world();
  const auto below = [&] {
    const QImage image = world.grab().toImage();
    return image.copy(0, image.height() - 36, image.width(), 36);
  };
  const QImage before = below(), whole = world.grab().toImage();
  const QPointF at(world.width() / 2.0, 40);
  QWheelEvent wheel(at, world.mapToGlobal(at), {}, {0, 900}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&world, &wheel);
  EXPECT_NE(world.grab().toImage(), whole);
  EXPECT_EQ(below(), before);
}

TEST(ActionRows, AThresholdBeyondTheScaleDoesNotTouchTheNumbers) {
  for (const char* environment : {"pendulum", "cliff", "mountain-car", "compass", "grid-world", "chain"}) {
    Elsewhere w(environment, "trl");
    auto* rows = w.window->findChild<ActionRows*>();
    for (const int width : {480, 560, 900}) {
      rows->resize(width, 240);
      rows->grab();
      const auto [scale, numbers] = rows->scaleAndNumbers();
      EXPECT_LT(scale + 2, numbers) << environment << " " << width;
    }
  }
}

TEST(ActionRows, ThePolicyInForceHasNumbersOfItsOwn) {
  Elsewhere w("leo", "greedy");
  const std::string csv = w.window->findChild<ActionRows*>()->asCsv();
  EXPECT_EQ(w.session->life().configuration().names.policy, "greedy");
  const std::string head = csv.substr(0, csv.find('\n'));
  // The policy in force, then those of the thesis.
  EXPECT_TRUE(head.ends_with(",greedy,epsilon-greedy,trl,softmax")) << head;
}

TEST(ActionRows, NumbersStandStillLongEnoughToBeRead) {
  Elsewhere w("pendulum");
  auto* rows = w.window->findChild<ActionRows*>();
  const auto [scale, numbers] = rows->scaleAndNumbers();
  const QRect where(static_cast<int>(numbers), 40, 20, 150);
  int changes = 0;
  QImage last = rows->grab(where).toImage();
  QElapsedTimer clock;
  for (clock.start(); clock.elapsed() < 3000;) {
    QTest::qWait(20);
    const QImage now = rows->grab(where).toImage();
    changes += now != last;
    last = now;
  }
  EXPECT_GE(changes, 2);
  EXPECT_LE(changes, clock.elapsed() / 100) << "ten times a second at most";
}

TEST(ValueMap, StatesOfWholeNumbersAreCells) {
  const Registry registry = fullRegistry();
  const auto taskOf = [&](const char* name) {
    return (*findEntry(registry.environments, "environment", name))->make()->task();
  };
  ValueMap map;
  const auto zero = [](std::span<const double>) { return 0.0; };
  const Task cliff = taskOf("cliff"), chain = taskOf("chain"), pendulum = taskOf("pendulum");
  map.evaluate(cliff, {0, 1, {0, 0}}, 70, zero);
  EXPECT_EQ(map.columns(), 12);
  EXPECT_EQ(map.rows(), 4);
  const QRectF area = ValueMap::area(cliff, {0, 1, {}}, {0, 0, 216, 216});
  EXPECT_NEAR(area.width() / 12, area.height() / 4, 0.5) << "square cells";
  const auto state = map.stateAt(cliff, {area.width() * 0.99, area.height() * 0.99}, area);
  ASSERT_TRUE(state);
  EXPECT_EQ(*state, (std::vector<double>{11, 0}));
  map.evaluate(chain, {0, 0, {5}}, 70, zero);
  EXPECT_EQ(map.columns(), static_cast<int>(chain.state[0].high - chain.state[0].low + 1));
  EXPECT_EQ(map.rows(), 1);
  EXPECT_TRUE(map.asCsv(chain, "q").starts_with("state,q\n"));
  map.evaluate(pendulum, {0, 1, {0, 0, 0}}, 70, zero);
  EXPECT_EQ(map.columns(), 70);
  EXPECT_EQ(map.rows(), 70);
}

TEST(ValueMap, AScaleThatEndsAtZeroHasNoColourBeyond) {
  const MapScale scale{MapScale::Kind::Diverging, -50, 0};
  EXPECT_EQ(scale.colour(0.01, false), scale.colour(0.0, false));
  EXPECT_NE(scale.colour(-25, false), scale.colour(0.0, false));
}

TEST(ValueMaps, TheRingGoesWithTheWorld) {
  Elsewhere w("cliff");
  auto* maps = w.window->findChild<ValueMaps*>();
  PaintCounter counter;
  maps->installEventFilter(&counter);
  int arrived = 0, moved = 0;
  std::vector<double> last;
  QObject::connect(&w.session->life(), &RunningLife::valuesArrived, maps, [&] { ++arrived; });
  QObject::connect(&w.session->looking(), &Looking::frame, maps, [&] {
    moved += w.session->looking().shown().state != last;
    last = w.session->looking().shown().state;
  });
  painted = 0;
  QTest::qWait(2000);
  EXPECT_GE(painted, std::min(moved, 2 * arrived)) << "not only when values come";
}

}  // namespace surefoot
