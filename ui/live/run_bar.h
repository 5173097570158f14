// SPDX-License-Identifier: GPL-3.0-or-later
// The toolbar: run, step, restart; pace and turbo; task, learning rule and policy; falls and episodes. In a narrow
// window the boxes become shorter, then the pace, the episodes and the factor go; the number of falls stays.
#pragma once

#include <QAction>
#include <QWidget>
#include <vector>

#include "ui/style/painted.h"

class QToolButton;

namespace surefoot {

class Combo;
class Editing;
class RunningLife;
class Slider;
struct Theme;

/// The actions that toolbar, menu and shortcuts share.
struct RunActions {
  QAction *run, *step, *restart, *turbo, *faster, *slower, *back, *live;
};

class RunBar final : public Painted<> {
  Q_OBJECT

 public:
  RunBar(RunningLife& life, Editing& editing, const RunActions& actions, QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({1280, 48}); }
  /// The pace at a position of the slider (0 to Slider::kSteps), and back.
  static double paceAt(int position);
  static int positionOfPace(double pace);
  /// One notch up or down the slider.
  void changePace(int notches);
  /// The texts of the counters: falls, episodes, and how many times faster than real time it runs (empty: not known).
  struct Texts {
    QString falls, episodes, factor;
  };
  const Texts& texts() const { return texts_; }

 Q_SIGNALS:
  /// Another learning rule was chosen; it needs a new table.
  void agentAsked(const QString& name, const QString& title);
  /// Another environment was chosen.
  void environmentAsked(const std::string& name);
  /// A person asks for the meaning of a choice.
  void meaningAsked(const std::string& name);

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override { layOut(); }

  /// A word of the counter at the right end, with its size; the words are listed from right to left.
  struct Word {
    QString text;
    int pixels, weight;
    bool falls;
    double gap;  // to the left of it [px]
  };

 private:
  /// The parts that are left out if there is too little room, in this order.
  enum Fold { kNothing, kPaceWord, kFactor, kEpisodes, kPace, kBoxes, kShortBoxes, kFolds };
  void layOut();
  int place(int fold, int spare);
  std::vector<Word> counter(int fold) const;
  int counterWidth(int fold) const;
  void refresh();
  void readNumbers();
  void fillTasks();
  void addRobots(const std::string& here, bool hasScenarios);
  void fillAgents();
  void makeMeaning();

  RunningLife& life_;
  Editing& editing_;
  RunActions actions_;
  std::vector<QWidget*> buttons_;
  Slider* pace_;
  Combo *task_, *agent_, *policy_;
  QToolButton* meaning_;
  Texts texts_;
  double paceLabel_ = 0, factorLabel_ = 0;  // left ends [px]; 0: not shown
  int fold_ = kNothing, counterWidth_ = 0;
};

}  // namespace surefoot
