// SPDX-License-Identifier: GPL-3.0-or-later
// The window: menus, pages, toolbar, message bar, status line.
#pragma once

#include <QMainWindow>

#include "ui/experiment.h"
#include "ui/run_bar.h"

class QAbstractButton;
class QMenu;
class QStackedWidget;

namespace surefoot {

class ExperimentPage;
class LivePage;
class MessageBar;
class Session;
class StatusLine;
enum class Appearance;

/// What the program gives its window.
struct WindowSetup {
  std::vector<PlanSource> plans;  ///< to choose from on the Experiment page
  QString folder;                 ///< for results and what must survive a crash; empty: the user's data folder
};

class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(Session& session, WindowSetup setup = {}, QWidget* parent = nullptr);
  LivePage& livePage() { return *live_; }
  ExperimentPage& experimentPage() { return *experiment_; }
  MessageBar& messages() { return *messages_; }
  void setPage(int page);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  QAction* addAction(QMenu* menu, const QString& text, const QString& tip, const QKeySequence& key);
  void makeActions();
  void makeMenus();
  QWidget* makeTabs();
  QWidget* makePlaceholder(const QString& title, const QString& words);
  void setAppearance(Appearance appearance);
  void restoreSettings();
  void refresh();
  void refreshStatus();
  void showShortcuts();
  void showAbout();

  Session& session_;
  RunActions run_{};
  RunBar* bar_ = nullptr;
  MessageBar* messages_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  LivePage* live_ = nullptr;
  ExperimentPage* experiment_ = nullptr;
  StatusLine* status_ = nullptr;
  QString experimentLeft_, experimentRight_;
  std::vector<QAbstractButton*> tabs_;
  std::vector<QAction*> shortcuts_;
  QString troubleShown_;
};

}  // namespace surefoot
