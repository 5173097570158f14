// SPDX-License-Identifier: GPL-3.0-or-later
// A film of what was seen: the last minutes of the window or the replay in hand, all of it or a part, painted and
// encoded in the background while the life goes on.
#pragma once

#include <QDialog>
#include <QTimer>
#include <atomic>
#include <memory>
#include <vector>

#include "core/signals/footage.h"
#include "ui/film/film.h"
#include "ui/film/film_kind.h"
#include "ui/live/signals/strip_film.h"
#include "ui/support/background.h"

class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace surefoot {

class Combo;
class Looking;
class RunningLife;
class WholeFile;

class FilmDialog final : public QDialog {
  Q_OBJECT

 public:
  /// What can be filmed is what there is now.
  FilmDialog(const RunningLife& life, const Looking& looking, QWidget* parent);
  bool busy() const { return making_.busy(); }
  /// Begins to make the film as it is chosen; a file that is there is replaced when the film is done.
  void make(const QString& path);
  /// Ends a film that is being made; nothing is left of it.
  void reject() override;

 Q_SIGNALS:
  void made(const QString& sentence);

 private:
  struct Source {
    QString title;
    Footage footage;
    std::shared_ptr<const SignalTable> signals;  // in which the footage has its rows
    double begin = 0.0;                          // where it is filmed from, if nobody says otherwise [s]
  };
  void makePart(QGridLayout* grid);
  void makeLook(QGridLayout* grid);
  void makeWords(QGridLayout* grid);
  QWidget* makeFoot();
  void choose();
  void askForPath();
  void refresh();
  void paint(const Film& film, const FilmKind& kind, WholeFile file, const QString& path);
  void finished(const Status& status, std::int64_t frames, const QString& path);
  Footage chosen() const;
  bool hasSignals() const;
  /// None: nothing is chosen, or nothing was written down.
  StripsBelow below() const;
  QSize size() const;

  const RunningLife& life_;
  std::vector<Source> sources_;
  Combo *source_ = nullptr, *speed_ = nullptr, *colours_ = nullptr;
  QDoubleSpinBox *from_ = nullptr, *to_ = nullptr;
  QSpinBox *width_ = nullptr, *height_ = nullptr;
  QCheckBox* signals_ = nullptr;
  QLabel* words_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton *make_ = nullptr, *cancel_ = nullptr;
  QTimer watch_;
  std::shared_ptr<std::atomic<std::int64_t>> done_;  // pictures of the film that is being made
  Background making_;                                // last member: its destructor runs first and waits
};

}  // namespace surefoot
