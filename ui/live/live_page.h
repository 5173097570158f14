// SPDX-License-Identifier: GPL-3.0-or-later
// The Live page: the world in the middle, the panels as docks around it.
#pragma once

#include <QMainWindow>
#include <QSize>
#include <functional>
#include <utility>
#include <vector>

namespace surefoot {

class ChartSpan;
class Panel;
class Rival;
class ParameterForm;
class Session;
class SignalsBar;
class SignalsShown;
class WorldView;
class Worlds;

class LivePage final : public QMainWindow {
  Q_OBJECT

 public:
  explicit LivePage(Session& session, QWidget* parent = nullptr);
  const std::vector<Panel*>& panels() const { return panels_; }
  WorldView& world() { return *world_; }
  /// A second learner beside the first; nullptr: there is none.
  Rival* rival() { return rival_; }
  void setComparing(bool comparing);
  void resetParameters();
  enum class Layout { Usual, Teaching, Falls, Maps, Signals };
  void useLayout(Layout layout);
  /// The learner goes on from the moment that a playback shows.
  void goOn();
  /// Two lives from that moment: the first as it is, the second by another rule for learning or for acting.
  void whatIf(const std::string& agent, const std::string& policy);
  /// What the greedy policy does from a new start, in the Signals layout.
  void rollOut();
  /// The file of another Q-function, to stand beside the first in roll-outs and replays.
  void setSecond(const QString& path);
  /// False: no panel had the whole page.
  bool leaveFullSize();
  /// The widths and heights of the first start.
  void resetLayout();
  /// The layout with all panels, even while one panel has the whole page.
  QByteArray layoutState();
  bool restoreLayout(const QByteArray& state);

 Q_SIGNALS:
  void refused(const QString& sentence);
  void told(const QString& sentence);
  void filmAsked();
  void comparingAsked();  ///< a second learner is wanted beside the first
  /// A changed parameter of the second learner needs a new table.
  void newTableAsked(const QString& sentence, const std::function<void()>& startAgain);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void childEvent(QChildEvent* event) override;

 private:
  static constexpr int kLayoutVersion = 4;

  Panel* addPanel(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area);
  QWidget* makeCentre();
  void makeMaps();
  void makeCharts();
  void makeRival();
  void makeWords();
  void makeSignals();
  void useSignals();
  void shareSpaceOfSignals();
  void showSignalsOfSecond();
  QString actionsNote() const;
  QString fallsNote(const ChartSpan& span) const;
  void toggleFull(QWidget* panel);
  void keepFocus();
  void shareSpace();
  void followTask();
  void followTextSize();
  QString worldNote() const;

  Session& session_;
  WorldView* world_ = nullptr;
  class PanelHeader* worldHeader_ = nullptr;
  ParameterForm* form_ = nullptr;
  Worlds* worlds_ = nullptr;
  Rival *rival_ = nullptr, *resting_ = nullptr;  // resting_: a hidden second learner; it keeps its life
  std::vector<Panel*> panels_;
  Panel *steps_ = nullptr, *rule_ = nullptr, *list_ = nullptr;  // hidden at first
  SignalsShown* signalsShown_ = nullptr;
  SignalsBar* signalsBar_ = nullptr;
  Panel *signals_ = nullptr, *portrait_ = nullptr, *strides_ = nullptr;  // as well
  std::vector<Panel*> needless_;                  // panels that are hidden because the task has no falls
  QWidget* full_ = nullptr;                       // the panel that has the whole page
  std::vector<std::pair<Panel*, QSize>> before_;  // the panels that were visible before that
  double sizedFor_ = 1.0;                         // the text size that the columns were made for
  Layout layout_ = Layout::Usual;                 // the last that was chosen
  bool laidOut_ = false;
  bool untouched_ = true;  // no one has moved a separator: the columns follow the width of the window
};

}  // namespace surefoot
