// SPDX-License-Identifier: GPL-3.0-or-later
// What the window costs the learner: turbo in a visible window and the same life without one, in turns, each for the
// same wall-clock time, so that a machine whose speed wanders favours neither. Needs two processors and a display:
//
//   xvfb-run window_bench [MINUTES]
//
// With MINUTES every panel is open in a window of 1920×1080, a turn takes a quarter of a minute, of which the last
// fifth is without the window, and the memory of the process is told, too.
//
// Speeds are per second by the clock and per CPU-second of the learner's thread: where the window, the display and the
// learner share too few processors, the first tells how long the learner waited for one.
#include <fmt/format.h>

#include <QApplication>
#include <QThread>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
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
constexpr double kLongTurn = 11.5;  // [s]
constexpr int kTurnsAMinute = 4;
constexpr double kWarmUp = 0.5;  // [s]

/// Counts how often a widget was painted.
class PaintCounter final : public QObject {
 public:
  int count = 0;
  bool eventFilter(QObject*, QEvent* event) override {
    count += event->type() == QEvent::Paint;
    return false;
  }
};

void processEventsFor(double seconds) {
  QEventLoop loop;
  QTimer::singleShot(static_cast<int>(seconds * 1000), &loop, &QEventLoop::quit);
  loop.exec();
}

/// CPU time [s] of every thread of this process.
std::map<std::string, double> cpuOfThreads() {
  std::map<std::string, double> seconds;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    double nanoseconds = 0;
    std::ifstream(task.path() / "schedstat") >> nanoseconds;
    seconds[task.path().filename()] = nanoseconds * 1e-9;
  }
  return seconds;
}

/// Steps a second, by the clock and by the CPU time of the thread that took them.
struct Speed {
  double clock = 0, cpu = 0;
};

/// Of the steps that were counted since then. The learner's thread is the one, but for this, that worked most.
class Stopwatch {
 public:
  Speed of(std::int64_t steps) const {
    double most = 0;
    for (const auto& [thread, cpu] : cpuOfThreads())
      if (const auto before = cpu_.find(thread); thread != std::to_string(getpid()) && before != cpu_.end())
        most = std::max(most, cpu - before->second);
    return {static_cast<double>(steps) / seconds(), static_cast<double>(steps) / most};
  }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  std::map<std::string, double> cpu_ = cpuOfThreads();
  Clock::time_point start_ = Clock::now();
};

/// Of a life on a thread of its own, while this thread sleeps.
Speed withoutWindow(Life& life) {
  Speed speed;
  std::thread learner([&] {
    for (int i = 0; i < 100'000; ++i) life.step();
    const std::int64_t first = life.steps();
    const Stopwatch watch;
    while (watch.seconds() < kTurn)
      for (int i = 0; i < 10'000; ++i) life.step();
    speed = watch.of(life.steps() - first);
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

  std::vector<double> ratios, ratiosOfCpu, rates;
  for (int turn = 0; turn < (minutes > 0 ? kTurnsAMinute * minutes : kTurns); ++turn) {
    session.setRunning(true);
    processEventsFor(kWarmUp);
    const std::int64_t first = session.snapshot().steps;
    frames.count = 0;
    const Stopwatch watch;
    processEventsFor(minutes > 0 ? kLongTurn - kWarmUp : kTurn);
    const Speed with = watch.of(session.snapshot().steps - first);
    rates.push_back(frames.count / watch.seconds());
    session.setRunning(false);
    processEventsFor(kWarmUp);
    const Speed without = withoutWindow(**life);
    ratios.push_back(with.clock / without.clock);
    ratiosOfCpu.push_back(with.cpu / without.cpu);
    fmt::print(
        "with the window {:.2f} M steps/s, without {:.2f} M: {:.3f}, per CPU-second {:.3f}; {:.1f} frames/s, {:.1f} "
        "MB\n",
        with.clock * 1e-6, without.clock * 1e-6, ratios.back(), ratiosOfCpu.back(), rates.back(), residentMemory());
    std::fflush(stdout);
  }
  fmt::print("median of {}: {:.3f} of the speed without a window, {:.3f} per CPU-second, {:.1f} frames/s\n",
             ratios.size(), median(ratios), median(ratiosOfCpu), median(rates));
}
