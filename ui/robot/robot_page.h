// SPDX-License-Identifier: GPL-3.0-or-later
// The Robot page: a robot's text, checked while it is typed, beside what it describes. While the text has an error,
// picture and tables are those of the last text without one.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "core/environment_library.h"
#include "ui/robot/robot_source.h"
#include "ui/robot/robot_trial.h"
#include "ui/support/background.h"

class QLabel;
class QMenu;

namespace surefoot {

class LinkButton;
class PanelHeader;
class RandomLife;
class RobotHelp;
class RobotPicture;
class RobotText;
class StateTable;
class TextButton;

class RobotPage final : public QWidget {
  Q_OBJECT

 public:
  /// `folder`: where drafts are kept.
  RobotPage(const Registry& registry, const QString& folder, QWidget* parent = nullptr);

  void open(const QString& path);
  /// A robot that comes with the program, as the beginning of one's own.
  void beginLike(const QString& name);
  /// The robot that the life runs: shown until a person has chosen another one here, or edited it.
  void offer(const EnvironmentFile& robot);
  bool isEdited() const;
  /// What is shown is not yet what the text says.
  bool isChecking() const { return pause_.isActive() || checking_.busy(); }
  QString fileName() const;
  void focusHome();
  void undo();
  void redo();
  /// False: it was not saved.
  bool save();
  bool saveAs();

 Q_SIGNALS:
  void refused(const QString& sentence);
  void told(const QString& sentence);
  /// The robot of this name begins to learn on the Live page.
  void learnAsked(const std::string& environment);
  /// Another text is wanted; what was edited would go (the page keeps it as undo).
  void statusChanged(const QString& left, const QString& right);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void nameAfter(const QString& path);
  struct Checked;

  QWidget* makeBar();
  QWidget* makeDescription();
  QWidget* makeFind(QWidget* parent);
  QWidget* makeWorld();
  QWidget* makeLife();
  void begin(const QString& text);
  void beginWith(const QString& text);
  /// What is not saved is kept in a file before another robot takes its place.
  void setAside();
  void showInspection(const EnvironmentInspection* inspection);
  void fillFiles();
  void openWithDialog();
  void check();
  void take(const std::shared_ptr<Checked>& checked);
  void refresh();
  void writeLimit(const AngleHandle& handle, double angle);
  void writeRange(const SeenState& state);
  void refreshProgram();
  void explain();
  QString valueAtCaret() const;
  void allow();
  void tryOut();
  void learn();

  const Registry& registry_;
  RobotSource source_;
  RobotTrial trial_;
  RobotText* text_;
  RobotPicture* picture_;
  StateTable* table_;
  RandomLife* life_;
  TextButton* file_;
  QMenu* files_;
  QLabel *state_, *note_, *errors_, *lines_;
  TextButton *save_, *try_, *learn_, *allow_;
  LinkButton *random_, *still_, *passive_, *drop_, *handMade_;
  PanelHeader *textHead_ = nullptr, *worldHead_ = nullptr;
  std::shared_ptr<RobotHelp> help_;   // read when it is asked for first
  std::shared_ptr<Checked> checked_;  // the last text without an error
  bool wrong_ = false, everShown_ = false, chosen_ = false;
  std::string offered_;
  QTimer pause_, keeping_;
  Background checking_;  // last member: its destructor runs first and waits
};

}  // namespace surefoot
