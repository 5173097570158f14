// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <QApplication>
#include <QFileInfo>
#include <QIcon>
#include <QStandardPaths>
#include <QTimer>
#include <filesystem>

#include "app/commands/commands.h"
#include "app/open_window.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "app/process/resources.h"
#include "app/reports/report.h"
#include "app/requests/command_help.h"
#include "app/versions.h"
#include "core/basics/guarded_call.h"
#include "core/basics/version.h"
#include "core/environment_programs.h"
#include "core/files/whole_file.h"
#include "core/lessons/reading/lesson_reading.h"
#include "core/text/printable.h"
#include "core/text/text.h"
#include "core/text/words.h"
#include "ui/controls/preferences.h"
#include "ui/crash/crash_notes.h"
#include "ui/crash/crash_reports.h"
#include "ui/language/language.h"
#include "ui/language/speech.h"
#include "ui/lessons/kiosk/kiosk_window.h"
#include "ui/lessons/lessons_page.h"
#include "ui/session/session.h"
#include "ui/window/main_window.h"

namespace surefoot {

namespace {

Error noDisplay() {
  const char* platform = std::getenv("QT_QPA_PLATFORM");
  const char* display = std::getenv("DISPLAY");
  const std::string tried = platform  ? fmt::format(" (QT_QPA_PLATFORM is {})", platform)
                            : display ? fmt::format(" (DISPLAY is {})", display)
                                      : "";
  return Error{
      fmt::format("there is no display for the window{}; `surefoot train --minutes 9` learns without one.", tried)};
}

/// Without a display, Qt prints several lines and ends the program: this prints one sentence instead. Qt's remarks on
/// the platform help nobody and are left out.
void onMessage(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  if (type == QtFatalMsg) _exit(fail(noDisplay()));
  const QLatin1String category(context.category);
  if (category.startsWith(QLatin1String("qt.qpa")) || text.contains("plugin") || text.contains("XDG_RUNTIME_DIR"))
    return;
  std::fprintf(stderr, "%s\n", qPrintable(text));
}

/// The heading of a recipe in the list of experiments.
std::string groupOf(const ShippedPlan& plan) {
  if (plan.name.starts_with("walker")) return QT_TRANSLATE_NOOP("core", "Walking robot LEO");
  if (plan.name.starts_with("beyond") || plan.name == "readings") return QT_TRANSLATE_NOOP("core", "Beyond the thesis");
  if (plan.name.starts_with("caution")) return QT_TRANSLATE_NOOP("core", "Caution: falling less");
  if (plan.name.starts_with("2.")) return QT_TRANSLATE_NOOP("core", "Chapter 2: reinforcement learning");
  if (plan.name.starts_with("4.") || plan.name.starts_with("table-4"))
    return QT_TRANSLATE_NOOP("core", "Chapter 4: thresholds (TRL)");
  return plan.name.starts_with("5.") ? QT_TRANSLATE_NOOP("core", "Chapter 5: Softmax")
                                     : QT_TRANSLATE_NOOP("core", "Chapter 6: resolution, and two Q-functions");
}

/// Reports the window's life as `train` does, with the life's configuration at the end. `unanswered`: it stood still,
/// because its environment did not answer.
int report(const WindowRequest& request, const Configuration& configuration, const Life& life,
           const std::string& unanswered, std::optional<WholeFile> log) {
  const std::vector<LifeResult> lives = {summarise(life, 0, 0.0)};
  const Status logged = log ? log->commit(logAsCsv(lives, life.environment().task().stepTime)) : Status(Done{});
  const int printed = request.json ? print(resultAsJson(configuration, lives)) : kDone;
  if (!logged) return fail(logged.error());
  if (printed != kDone) return printed;
  if (!unanswered.empty()) return fail({unanswered, ErrorKind::Unanswered});
  return life.diverged() ? fail({life.divergence(), ErrorKind::Diverged}) : kDone;
}

/// The class and the lesson that the command line names.
Status enterLessons(const WindowRequest& request, MainWindow& window) {
  const QString student = QString::fromStdString(request.student);
  if (!student.isEmpty())
    if (const Status s = window.lessonsPage().setClass(QString::fromStdString(request.classFolder), student); !s)
      return s;
  if (!request.lesson) return Done{};
  window.setPage(2);
  std::error_code error;
  if (std::filesystem::is_regular_file(*request.lesson, error)) {
    const QString path = QString::fromStdString(*request.lesson);
    if (const Status s = window.lessonsPage().open(path); !s) return s;
    return window.lessonsPage().startChosen();
  }
  if (window.lessonsPage().start(*request.lesson)) return Done{};
  std::vector<std::string> names;
  for (const ShelvedLesson& one : window.lessonsPage().lessons())
    if (one.lesson) names.push_back(one.lesson->name);
  const std::string near = nearestWord(*request.lesson, names);
  return Error{fmt::format("--lesson: there is no lesson \"{}\"{}; there are {}.",
                           printable(shortened(*request.lesson)), near.empty() ? "" : ", did you mean " + near,
                           joinWords(names))};
}

/// An exception in a slot does not end the program and the life: the window shows it.
class Application final : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override {
    bool done = true;
    const std::string trouble = troubleOf([&] { done = QApplication::notify(receiver, event); });
    if (!trouble.empty() && tell) static_cast<void>(troubleOf([&] { tell(QString::fromStdString(trouble)); }));
    return done;
  }
  std::function<void(const QString& sentence)> tell;
};

/// The lesson's two robots on the whole screen, until the teacher leaves.
int kioskCommand(const Registry& registry, const WindowRequest& request, Application& application) {
  applyAppearance(application, Appearance::Light);
  std::error_code error;
  std::optional<Lesson> lesson;
  std::vector<std::string> names;
  if (std::filesystem::is_regular_file(*request.kiosk, error)) {
    const auto one = readLessonFile(registry, *request.kiosk, lessonInLanguage);
    if (!one) return fail(one.error());
    if (!one->lesson) return fail({complaintText(one->path, one->complaints.at(0))});
    lesson = one->lesson;
  }
  for (const ShelvedLesson& one : lessonsIn(registry, resourceFolder("lessons"), lessonInLanguage)) {
    if (!one.lesson || !one.lesson->kiosk) continue;
    names.push_back(one.lesson->name);
    if (one.lesson->name == *request.kiosk) lesson = one.lesson;
  }
  if (!lesson || !lesson->kiosk)
    return fail({fmt::format("--kiosk: \"{}\" is no lesson with a [kiosk]; there are {}.",
                             printable(shortened(*request.kiosk)), joinWords(names))});
  const auto start = kioskStart(registry, *lesson);
  if (!start) return fail(start.error());
  KioskWindow window(registry, *lesson, *start, request.resetAfter);
  window.showFullScreen();
  const std::atomic<bool>& interrupted = watchForInterrupt();
  QTimer watch;
  QObject::connect(&watch, &QTimer::timeout, &window, [&] {
    if (interrupted) window.close();
  });
  watch.start(100);
  QApplication::exec();
  return interrupted ? kInterrupted : kDone;
}

}  // namespace

int windowCommand(const Registry& registry, const WindowRequest& request, int argc, char** argv) {
  std::optional<WholeFile> log;
  if (request.log) {
    auto file = WholeFile::createNew("--log", *request.log);
    if (!file) return fail(file.error());
    log.emplace(std::move(*file));
  }
  const char* platform = std::getenv("QT_QPA_PLATFORM");
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY") && !platform) return fail(noDisplay());

  tell(request.note);
  qInstallMessageHandler(onMessage);
  int qtArguments = 1;  // ours are not Qt's
  static_cast<void>(argc);
  Application application(qtArguments, argv);
  QApplication::setApplicationName("Surefoot");
  QApplication::setOrganizationName("Surefoot");
  QApplication::setApplicationVersion(kVersion);
  QApplication::setDesktopFileName("surefoot");
  QApplication::setWindowIcon(QIcon(QString::fromStdString(resourceFolder("desktop") + "/surefoot.svg")));
  if (request.reuseWindow && handToOpenWindow(QString::fromStdString(request.file.value_or("")))) return kDone;
  const Preferences preferences = readPreferences();
  useLanguage(application, request.language ? QString::fromStdString(*request.language) : preferences.language);
  if (request.kiosk) return kioskCommand(registry, request, application);
  applyAppearance(application, preferences.appearance);

  Session session(registry, request.configuration, log.has_value());
  WindowSetup setup;
  setup.folder = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
  std::string versions;
  for (const PartVersion& part : partVersions()) versions += fmt::format("  {} {}\n", part.name, part.version);
  watchForCrashes(QFile::encodeName(crashFile(setup.folder)).toStdString(),
                  fmt::format("Versions\n{}  platform {}\n", versions, QApplication::platformName().toStdString()));
  for (const ShippedPlan& plan : allShipped(registry))
    setup.plans.push_back({plan.title, plan.path, plan.recipe, plan.recipe ? groupOf(plan) : "", plan.name, plan.shows,
                           plan.answers, plan.minutes});
  setup.lessons = QString::fromStdString(resourceFolder("lessons"));
  setup.about.folder = QString::fromStdString(resourceFolder("about"));
  for (const PartVersion& part : partVersions())
    setup.about.versions.emplace_back(QString::fromStdString(part.name), QString::fromStdString(part.version));
  setup.handbook = [&registry] {
    return makeHandbook(registry, resourceFolder("handbook"), commandHelp(registry), handbookInLanguage());
  };
  setup.pictures = QString::fromStdString(resourceFolder("screenshots"));
  setup.asksOnQuit = !request.json && !request.log;  // with these, quitting writes the results
  MainWindow window(session, std::move(setup));
  window.show();
  if (request.page) window.setPage(*request.page);
  if (const Status s = enterLessons(request, window); !s) return fail(s.error());
  application.tell = [&session](const QString& sentence) { Q_EMIT session.newLives().refused(sentence); };
  session.life().setTurbo(request.turbo);
  session.life().setRunning(preferences.beginRunning && !request.follow && !request.file);
  const auto runs = [&session, runs = preferences.beginRunning] { session.life().setRunning(runs); };
  if (request.file) window.openFile(QString::fromStdString(*request.file), runs);
  const OpenWindow open([&window](const QString& path) {
    window.setWindowState(window.windowState() & ~Qt::WindowMinimized);
    window.raise();
    window.activateWindow();
    if (!path.isEmpty()) window.openFile(path);
  });
  if (request.follow) window.follow(QString::fromStdString(*request.follow));
  if (const auto& start = request.configuration.start)
    window.tellLoaded(QFileInfo(QString::fromStdString(start->name)).fileName());

  const std::atomic<bool>& interrupted = watchForInterrupt();
  QTimer watch;
  QObject::connect(&watch, &QTimer::timeout, &window, [&] {
    if (interrupted) window.closeForNow();
  });
  watch.start(100);

  QApplication::exec();
  application.tell = nullptr;
  const std::string waiting = interrupted ? "" : session.life().snapshot().unanswered;
  registry.programs->stopWaiting();  // nobody waits for an answer any more
  const std::unique_ptr<Life> life = session.life().finish();
  const int code = report(request, session.life().configuration(), *life, waiting, std::move(log));
  if (const auto& why = window.whyNotKept())
    return fail({fmt::format("the session is not kept for the next start: {}", why->message), why->kind});
  return code == kDone && interrupted && !life->finished() ? kInterrupted : code;
}

}  // namespace surefoot
