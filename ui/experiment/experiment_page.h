// SPDX-License-Identifier: GPL-3.0-or-later
// The Experiment page: batches of lives with their statistics.
#pragma once

#include <QWidget>

#include "ui/experiment/experiment.h"

class QAbstractButton;
class QHBoxLayout;
class QLabel;
class QSplitter;
class QSpinBox;
class QStackedWidget;

namespace surefoot {

class FigurePanel;
class LinkButton;
class NoticeStrip;
class PlanChooser;
class PanelHeader;
class PlanEditor;
class RunningLife;

class ExperimentPage final : public QWidget {
  Q_OBJECT

 public:
  ExperimentPage(const RunningLife& life, std::vector<PlanSource> sources, const QString& folder,
                 QWidget* parent = nullptr);
  Experiment& experiment() { return experiment_; }
  /// A plan, a recipe or a store of results.
  void open(const QString& path);
  /// Looks at a store that another process writes.
  void follow(const QString& path);
  void stopFollowing() { experiment_.stopFollowing(); }
  void showPlan(bool shown);
  const std::vector<FigurePanel*>& figures() const { return figures_; }

 public Q_SLOTS:
  void runOrPause();
  void startAgain();
  void copyCsv();
  void copyLatex();
  void exportCsv();
  void exportForSpreadsheets();
  void exportCharts();
  void openWithDialog();
  void savePlanAs();

 Q_SIGNALS:
  void refused(const QString& sentence);
  /// The person must decide whether to go on: the store was written by another version, or a robot starts a program.
  void asked(const QString& why, const QString& answer, const std::function<void()>& go);
  void told(const QString& sentence);
  /// The two texts of the status line while this page is shown.
  void statusChanged(const QString& left, const QString& right);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* makeBar();
  QWidget* makeColumn();
  QWidget* makeResults();
  void refresh();
  void showFollowing();
  void setFull(QWidget* panel);
  void foldBar();
  void askForLives();
  void showLives();
  void setLives(int lives);
  void inBackground(const QString& what, int steps, std::function<Status(std::atomic<int>& done)> work,
                    const QString& then);
  void writeCharts(const QString& folder);
  void exportTables(bool forSpreadsheets);

  const RunningLife& life_;
  Experiment experiment_;
  PlanChooser* source_ = nullptr;
  QSpinBox* lives_ = nullptr;
  QAbstractButton *run_ = nullptr, *stop_ = nullptr;
  QStackedWidget* stack_ = nullptr;
  PlanEditor* editor_ = nullptr;
  LinkButton* edit_ = nullptr;
  PanelHeader* columnHeader_ = nullptr;
  QLabel* summary_ = nullptr;
  bool runWhenOpen_ = false;  // it was asked for while the plan was being read
  std::vector<FigurePanel*> figures_;
  std::vector<std::pair<QWidget*, PanelHeader*>> panels_;  // the figures, then the table
  QHBoxLayout* bar_ = nullptr;
  NoticeStrip* following_ = nullptr;
  std::vector<QWidget*> copies_;  // have their places in the menu as well
  QWidget *upper_ = nullptr, *full_ = nullptr;
  Background writing_;  // last member: its destructor runs first and waits
};

/// The finding in one sentence, as rich text; with "so far" while some of its lives are missing.
QString summaryOf(const Experiment& experiment);
/// A plan's text with another number of lives per condition.
std::string withLives(const std::string& plan, int lives);

}  // namespace surefoot
