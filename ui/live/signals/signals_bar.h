// SPDX-License-Identifier: GPL-3.0-or-later
// What can be done with the signals, in the header of their panel: choose them, live a roll-out, put a second
// Q-function beside the first, export. If there is no room, one menu holds all of it.
#pragma once

#include <QWidget>

#include "core/files/tensor_file.h"
#include "ui/controls/panel.h"
#include "ui/support/background.h"

class QMenu;

namespace surefoot {

class LinkButton;
class Looking;
class RunningLife;
class SignalChooser;
class SignalsShown;

class SignalsBar final : public QWidget, public Folding {
  Q_OBJECT

 public:
  SignalsBar(RunningLife& life, Looking& looking, SignalsShown& shown, QWidget* parent = nullptr);
  void fold(int room) override;
  /// "11 of 34, every step"
  QString note() const;
  QString whatHappened() const;
  /// What the greedy policy does in 25 s, from a new start.
  void rollOut();
  void askForSecond();
  /// The second Q-function of a file; if nothing is shown that it could stand beside, a roll-out is (or is not).
  void setSecond(const QString& path, bool rollsOut = true);

 Q_SIGNALS:
  void refused(const QString& sentence);
  void exportAsked(const QString& ending);
  void filmAsked();

 private:
  void fillSecond(QMenu& menu);
  void fillExport(QMenu& menu);
  void fillAll(QMenu& menu);
  void refresh();
  void compareWithNow();
  struct Second {
    QString name, path{};
    bool rollsOut = true;
  };
  void compareWith(const std::shared_ptr<const TensorFile>& file, const Second& second);
  void choose();

  RunningLife& life_;
  Looking& looking_;
  SignalsShown& shown_;
  SignalChooser* chooser_;
  LinkButton *signals_, *rollOut_, *second_, *film_, *export_, *all_;
  Background reading_, making_;
};

}  // namespace surefoot
