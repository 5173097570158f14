// SPDX-License-Identifier: GPL-3.0-or-later
// What the window costs the learner: turbo in a visible window and the same life without one, in turns, each for the
// same wall-clock time, so that a machine whose speed wanders favours neither. Needs two processors and a display:
//
//   xvfb-run window_bench [MINUTES]
//
// With MINUTES every panel is open in a window of 1920×1080, a turn takes a minute of which the last seconds are
// without the window, and the memory of the process is told, too.
#include <fmt/format.h>

#include <QApplication>
#include <QThread>
#include <algorithm>
#include <fstream>
#include <thread>

#include <unistd.h>

#include "physics/register.h"
#include "ui/live_page.h"
#include "ui/main_window.h"
#include "ui/panel.h"
#include "ui/session.h"
#include "ui/theme.h"
#include "ui/world_view.h"

using namespace surefoot;

namespace {

using Clock = std::chrono::steady_clock;
constexpr int kTurns = 9;
constexpr double kTurn = 3.0;       // [s]
constexpr double kLongTurn = 56.0;  // [s]
constexpr double kWarmUp = 0.5;     // [s]

/// Counts how often a widget was painted.
class PaintCounter final : public QObject {
 public:
  int count = 0;
  bool eventFilter(QObject*, QEvent* event) override {
    count += event->type() == QEvent::Paint;
    return false;
  }
};

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void processEventsFor(double seconds) {
  QEventLoop loop;
  QTimer::singleShot(static_cast<int>(seconds * 1000), &loop, &QEventLoop::quit);
  loop.exec();
}

/// Steps a second of a life on a thread of its own, while this thread sleeps.
double withoutWindow(Life& life) {
  double speed = 0;
  std::thread learner([&] {
    for (int i = 0; i < 100'000; ++i) life.step();
    const std::int64_t first = life.steps();
    const auto start = Clock::now();
    while (secondsSince(start) < kTurn)
      for (int i = 0; i < 10'000; ++i) life.step();
    speed = static_cast<double>(life.steps() - first) / secondsSince(start);
  });
  learner.join();
  return speed;
}

/// [MB] of this process that are in memory.
double residentMemory() {
  std::ifstream in("/proc/self/statm");
  double size = 0, resident = 0;
  in >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// All of them beside each other, none behind another.
void openEveryPanel(LivePage& page) {
  page.useLayout(LivePage::Layout::Usual);
  for (Panel* panel : page.panels()) panel->show();
  const auto panel = [&](const char* name) { return page.findChild<Panel*>(QLatin1String(name)); };
  page.splitDockWidget(panel("actions"), panel("step"), Qt::Horizontal);
  page.splitDockWidget(panel("step"), panel("rule"), Qt::Horizontal);
  page.splitDockWidget(panel("falls"), panel("list"), Qt::Horizontal);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int minutes = argc > 1 ? std::atoi(argv[1]) : 0;
  QApplication application(argc, argv);
  applyAppearance(application, Appearance{});
  Registry registry;
  registerCore(registry);
  registerPhysics(registry);
  const auto configuration = configure(registry, {}, {});
  auto life = makeLife(registry, *configuration, 0, false);

  Session session(registry, *configuration, false);
  MainWindow window(session);
  minutes > 0 ? window.resize(1920, 1080) : window.resize(1280, 800);
  window.show();
  if (minutes > 0) openEveryPanel(window.livePage());
  PaintCounter frames;
  window.findChild<WorldView*>()->installEventFilter(&frames);
  session.setTurbo(true);

  std::vector<double> ratios, rates;
  for (int turn = 0; turn < (minutes > 0 ? minutes : kTurns); ++turn) {
    session.setRunning(true);
    processEventsFor(kWarmUp);
    const std::int64_t first = session.snapshot().steps;
    frames.count = 0;
    const auto start = Clock::now();
    processEventsFor(minutes > 0 ? kLongTurn - kWarmUp : kTurn);
    const double seconds = secondsSince(start);
    const double with = static_cast<double>(session.snapshot().steps - first) / seconds;
    rates.push_back(frames.count / seconds);
    session.setRunning(false);
    processEventsFor(kWarmUp);
    const double without = withoutWindow(**life);
    ratios.push_back(with / without);
    fmt::print("with the window {:.2f} M steps/s, without {:.2f} M: {:.3f}; {:.1f} frames/s, {:.1f} MB\n", with * 1e-6,
               without * 1e-6, ratios.back(), rates.back(), residentMemory());
    std::fflush(stdout);
  }
  fmt::print("median of {}: {:.3f} of the speed without a window, {:.1f} frames/s\n", ratios.size(), median(ratios),
             median(rates));
}
