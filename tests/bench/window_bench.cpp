// SPDX-License-Identifier: GPL-3.0-or-later
// What the window costs the learner: turbo in a visible window and the same task without one, in turns of half a
// second, because a machine's speed wanders from second to second by more than what is to be measured. Needs two
// processors and a display:
//
//   xvfb-run window_bench [MINUTES | signals]
//
// With "signals" the Signals layout is open. With MINUTES every panel is open in a window of 1920×1080, two thirds of
// the time are the window's, and the memory of the process is told every minute.
//
// Speeds are per second by the clock and per CPU-second of the learner's thread: where the window, the display and the
// learner share too few processors, the first tells how long the learner waited for one. The ratio is a geometric mean
// with its 95 % interval; every turn is held against the turns without the window before and after it.
#include <fmt/format.h>

#include <QApplication>
#include <QThread>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include <unistd.h>

#include "core/statistics/statistics.h"
#include "tests/full_registry.h"
#include "ui/controls/panel.h"
#include "ui/live/live_page.h"
#include "ui/live/world/world_view.h"
#include "ui/session/session.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"

using namespace surefoot;

namespace {

using Clock = std::chrono::steady_clock;
constexpr double kWith = 0.6, kWithout = 0.3;  // [s], measured
constexpr double kSettle = 0.05;               // [s], before each
constexpr double kMinutes = 0.5;               // where none are asked for

/// Counts how often a widget was painted while it is on.
class PaintCounter final : public QObject {
 public:
  bool on = false;
  int count = 0;
  double seconds = 0;  // that it was on
  bool eventFilter(QObject*, QEvent* event) override {
    count += on && event->type() == QEvent::Paint;
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
  /// `end`: when they had been taken.
  Speed of(std::int64_t steps, Clock::time_point end) const {
    double most = 0;
    for (const auto& [thread, cpu] : cpuOfThreads())
      if (const auto before = cpu_.find(thread); thread != std::to_string(getpid()) && before != cpu_.end())
        most = std::max(most, cpu - before->second);
    const double share = most / secondsUntil(Clock::now());
    const double clock = static_cast<double>(steps) / secondsUntil(end);
    return {clock, clock / share};
  }
  double secondsUntil(Clock::time_point end) const { return std::chrono::duration<double>(end - start_).count(); }

 private:
  std::map<std::string, double> cpu_ = cpuOfThreads();
  Clock::time_point start_ = Clock::now();
};

/// A life that steps on a thread of its own whenever it may, and nothing else.
class Headless {
 public:
  explicit Headless(std::unique_ptr<Life> life) : life_(std::move(life)), thread_([this] { run(); }) {}
  ~Headless() {
    end_ = true;
    setRunning(true);
    thread_.join();
  }
  void setRunning(bool running) {
    running_ = running;
    running_.notify_one();
  }
  std::int64_t steps() const { return steps_.load(std::memory_order_relaxed); }

 private:
  void run() {
    while (!end_) {
      running_.wait(false);
      for (int i = 0; i < 256; ++i) life_->step();
      steps_.store(life_->steps(), std::memory_order_relaxed);
    }
  }

  std::unique_ptr<Life> life_;
  std::atomic<bool> running_{false}, end_{false};
  std::atomic<std::int64_t> steps_{0};
  std::thread thread_;
};

/// Of a life without a window, while this thread sleeps.
Speed withoutWindow(Headless& headless) {
  const auto sleep = [](double s) { std::this_thread::sleep_for(std::chrono::duration<double>(s)); };
  headless.setRunning(true);
  sleep(kSettle);
  const std::int64_t first = headless.steps();
  const Stopwatch watch;
  sleep(kWithout);
  const Speed speed = watch.of(headless.steps() - first, Clock::now());
  headless.setRunning(false);
  return speed;
}

/// In turbo. Steps are those of the snapshots of the first frame and the last, taken when these were.
Speed withWindow(Session& session, PaintCounter& frames) {
  session.life().setRunning(true);
  processEventsFor(kSettle);
  std::optional<Stopwatch> watch;
  std::int64_t first = 0, last = 0;
  Clock::time_point end;
  const auto connection = QObject::connect(&session.looking(), &Looking::frame, [&] {
    last = session.life().snapshot().steps;
    end = Clock::now();
    if (!watch) watch.emplace(), first = last;
  });
  const Stopwatch whole;
  frames.on = true;
  processEventsFor(kWith);
  frames.on = false;
  frames.seconds += whole.secondsUntil(Clock::now());
  QObject::disconnect(connection);
  const Speed speed = watch ? watch->of(last - first, end) : Speed{};
  session.life().setRunning(false);
  processEventsFor(kSettle);
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

/// The geometric mean of ratios with its 95 % interval, "0.981 (0.975 … 0.987)".
std::string meanText(const std::vector<double>& logarithms) {
  const auto mean = meanInterval(logarithms);
  if (!mean) return "too few turns";
  return fmt::format("{:.3f} ({:.3f} … {:.3f})", std::exp(mean->value), std::exp(mean->low), std::exp(mean->high));
}

}  // namespace

int main(int argc, char** argv) {
  const bool signals = argc > 1 && std::string_view(argv[1]) == "signals", everyPanel = argc > 1 && !signals;
  const double minutes = everyPanel ? std::atof(argv[1]) : kMinutes;
  QApplication application(argc, argv);
  applyAppearance(application, Appearance{});
  Registry registry = fullRegistry();
  const auto configuration = configure(registry, {}, {});
  auto life = makeLife(registry, *configuration, 0, false);
  Headless headless(std::move(*life));

  Session session(registry, *configuration, false);
  MainWindow window(session);
  everyPanel ? window.resize(1920, 1080) : window.resize(1280, 800);
  window.show();
  if (everyPanel) openEveryPanel(window.livePage());
  if (signals) window.livePage().useLayout(LivePage::Layout::Signals);
  PaintCounter frames;
  window.findChild<WorldView*>()->installEventFilter(&frames);
  session.life().setTurbo(true);

  const auto start = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count() / 60; };
  std::vector<double> byClock, byCpu;  // logarithms of ratios
  double minute = 0;
  Speed before = withoutWindow(headless), with;
  while (elapsed() < minutes) {
    with = withWindow(session, frames);
    const Speed after = withoutWindow(headless);
    byClock.push_back(std::log(with.clock / std::sqrt(before.clock * after.clock)));
    byCpu.push_back(std::log(with.cpu / std::sqrt(before.cpu * after.cpu)));
    before = after;
    if (elapsed() < std::min(minute + 1, minutes)) continue;
    minute += 1;
    fmt::print(
        "{:.0f} min: with the window {:.2f} M steps/s, without {:.2f} M; {:.1f} frames/s, {:.1f} MB; so far {} of the "
        "speed without\n",
        minute, with.clock * 1e-6, before.clock * 1e-6, frames.count / frames.seconds, residentMemory(),
        meanText(byClock));
    std::fflush(stdout);
    frames.count = 0, frames.seconds = 0;
  }
  fmt::print("{} turns: {} of the speed without a window, {} per CPU-second\n", byClock.size(), meanText(byClock),
             meanText(byCpu));
}
