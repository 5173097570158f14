// SPDX-License-Identifier: GPL-3.0-or-later
// The window: menus, pages, toolbar, message bar, status line.
#pragma once

#include <QMainWindow>
#include <QPointer>
#include <functional>
#include <map>
#include <optional>

#include "core/basics/result.h"
#include "core/handbook/page.h"
#include "ui/about/about_dialog.h"
#include "ui/experiment/experiment.h"
#include "ui/live/run_bar.h"

class QAbstractButton;
class QActionGroup;
class QMenu;
class QStackedWidget;

class QUndoGroup;

namespace surefoot {

class Autosave;
class FilmDialog;
class ExperimentPage;
class HandbookWindow;
class LifeFollower;
class LinkButton;
class LessonsPage;
class LivePage;
class RobotPage;
class MessageBar;
class NoticeStrip;
struct KeptLife;
class Session;
class SessionName;
class PreLearningDialog;
class RobustnessDialog;
class StatusLine;
class WordsDialog;
struct Preferences;
enum class Appearance;
enum class SavedAs;

/// The data that the program gives to its window.
struct WindowSetup {
  std::vector<PlanSource> plans;                 ///< to choose from on the Experiment page
  std::function<Result<Handbook>()> handbook{};  ///< makes it, when it is first asked for
  QString pictures{};                            ///< the folder of the handbook's pictures
  QString lessons{};                             ///< the folder of the lessons
  QString folder{};                              ///< for results and autosaves; empty: the user's data folder
  AboutFacts about{};                            ///< for Help › About
  bool asksOnQuit = true;  ///< whether quitting asks to save; false if quitting writes the results
};

class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(Session& session, WindowSetup setup = {}, QWidget* parent = nullptr);
  LivePage& livePage() { return *live_; }
  ExperimentPage& experimentPage() { return *experiment_; }
  LessonsPage& lessonsPage() { return *lessons_; }
  RobotPage& robotPage() { return *robot_; }
  MessageBar& messages() { return *messages_; }
  void setPage(int page);
  /// Opens any kind of file: a session, a Q-function, a journal, a robot, a lesson, a plan, results. `lives` is called
  /// when a life of the file is there.
  void openFile(const QString& path, const std::function<void()>& lives = {});
  /// Says that a life was loaded, whether it learns, and how one looks at it without teaching it anything.
  void tellLoaded(const QString& name);
  /// Looks at a store or a checkpoint that another process writes, read only, on the page where it belongs.
  void follow(const QString& path);
  void stopFollowing();
  LifeFollower& follower() { return *follower_; }
  void saveTo(SavedAs what, const QString& path, const std::function<void()>& then = {});
  /// The program is ended from outside: the session is kept for the next start, then the window closes.
  void closeForNow();
  /// Opens the handbook at a page; empty: at the page of what has the focus.
  void showHandbook(const QString& page = {});
  HandbookWindow* handbook() const;
  /// Why the session could not be kept when the window was closed for now.
  const std::optional<Error>& whyNotKept() const { return whyNotKept_; }

 protected:
  bool event(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  static constexpr int kLessonsPage = 2, kRobotPage = 3;

  QAction* addAction(QMenu* menu, const QString& text, const QString& tip, const QKeySequence& key);
  void makeActions();
  void makeMenus();
  void makeFileMenu();
  bool onRobotPage() const;
  void makeEditMenu();
  void makeViewMenu();
  void makeTextSizes(QMenu* view);
  void makeHelpMenu();
  /// Applies a text size and keeps it for the next start.
  void setTextSize(double size);
  void keepLayout();
  void fillLayouts();
  void fillWhatIf(QMenu& menu);
  void fillRecent();
  void showPreLearning();
  void showRobustness();
  void showFilm();
  void askForSeed();
  void begin(const std::function<Status()>& what);
  void openWithDialog();
  void saveSession(const std::function<void()>& then = {});
  void saveSessionAs(const std::function<void()>& then = {});
  void saveWithDialog(SavedAs what, const QString& title, const QString& name, const QString& ending,
                      const std::function<void()>& then = {});
  void saveKept(const std::shared_ptr<KeptLife>& kept, const std::function<void()>& then);
  void exportWithDialog(QWidget* view, const QString& title);
  void remember(const QString& path);
  void offerToRestore();
  void offerReport();
  void showReport();
  void restore(const QString& file);
  void askQuestions();
  void tellUnanswered();
  void askForAgent(const QString& name, const QString& title);
  void askForNewTable(const QString& key, double value);
  void askBeforeEnding(const std::shared_ptr<KeptLife>& kept, const std::function<void()>& goOn);
  QString whatIsNotSaved() const;
  Session* secondUnsaved() const;
  void saveSecond(const std::function<void()>& then);
  bool askBeforeQuit();
  void quit();
  void tellHowItBegan();
  QString sessionName() const;
  void refreshTitle();
  void refreshName();
  QWidget* makeTabs();
  void makeLessons(const WindowSetup& setup);
  void makeRobot(const WindowSetup& setup);
  void openRobot(const QString& path);
  void addFollowing(QMenu* file);
  void makeFollowing();
  void followWithDialog();
  void showFollowing();
  void usePreferences(const Preferences& preferences);
  void showPreferences();
  /// The focus goes where the page's single keys work.
  void focusHome();
  void restoreSettings();
  /// No larger than the screen has room for, with the frame around the window, and wholly on it.
  void fitToScreen();
  /// The message bar stands below the toolbar of the page that is shown.
  void placeMessages();
  void refresh();
  void refreshStatus();
  void showShortcuts();
  void showAbout();
  void showWords(const std::string& name);

  Session& session_;
  RunActions run_{};
  RunBar* bar_ = nullptr;
  MessageBar* messages_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  LivePage* live_ = nullptr;
  ExperimentPage* experiment_ = nullptr;
  LessonsPage* lessons_ = nullptr;
  RobotPage* robot_ = nullptr;
  LifeFollower* follower_ = nullptr;
  NoticeStrip* following_ = nullptr;  ///< of the Live page; the Experiment page has its own
  LinkButton* goOnFromHere_ = nullptr;
  QAction* stopFollowing_ = nullptr;
  StatusLine* status_ = nullptr;
  QUndoGroup* undoOfPage_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr;
  QString experimentLeft_, experimentRight_, lessonsLeft_, lessonsRight_, robotLeft_, robotRight_;
  std::vector<QAbstractButton*> tabs_;
  std::vector<QAction*> shortcuts_, liveActions_;
  QMenu *recent_ = nullptr, *ownLayouts_ = nullptr;
  std::map<std::string, QPointer<PreLearningDialog>> preLearning_;  // by environment: each keeps its pool
  QPointer<RobustnessDialog> robustness_;
  QActionGroup* appearances_ = nullptr;
  Appearance appearance_;
  Autosave* autosave_ = nullptr;
  QPointer<WordsDialog> words_;
  std::function<Result<Handbook>()> makeHandbook_;
  QString pictures_;
  QPointer<HandbookWindow> handbook_;
  QPointer<FilmDialog> film_;
  SessionName* name_ = nullptr;
  QString troubleShown_;
  QString folder_;  // for results and autosaves
  AboutFacts about_;
  std::int64_t unansweredTries_ = 0;  ///< that were told
  bool asksOnQuit_ = true, closing_ = false, couldNotKeep_ = false;
  std::optional<Error> whyNotKept_;
  QSize fitted_;  // the size that the program chose; empty: it has been fitted, frame and all
};

}  // namespace surefoot
