// SPDX-License-Identifier: GPL-3.0-or-later
// A second learner beside the first: another policy or learning rule in a world of its own, with the same seed. It
// runs, rests and starts again with the first; a parameter that is changed there is changed here as well.
#pragma once

#include <QWidget>

#include "ui/session.h"

class QComboBox;

namespace surefoot {

class WorldView;

class Rival final : public QWidget {
  Q_OBJECT

 public:
  explicit Rival(Session& first, QWidget* parent = nullptr);
  Session& session() { return *session_; }
  WorldView& world() { return *world_; }

 Q_SIGNALS:
  void refused(const QString& sentence);

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  Configuration configurationLikeFirst() const;
  void startAgain();
  void follow();
  void followParameters();
  void choose();

  Session& first_;
  std::string policy_, agent_;
  std::unique_ptr<Session> session_;
  WorldView* world_ = nullptr;
  QComboBox *agents_, *policies_;
};

}  // namespace surefoot
