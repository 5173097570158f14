// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/experiment_progress.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/plans/plan_time.h"
#include "ui/experiment/experiment.h"
#include "ui/language/numbers.h"
#include "ui/style/theme.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {
constexpr int kLeast = 170, kMost = 420, kTrack = 240;  // [px]
}

ExperimentProgress::ExperimentProgress(Experiment& experiment, QWidget* parent)
    : Painted(parent),
      experiment_(experiment) {
  whenScaled(this, [this] {
    setFixedHeight(scaled(40));
    setMinimumWidth(scaled(kLeast));
    setMaximumWidth(scaled(kMost));
  });
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Progress"));
  for (auto signal : {&Experiment::progressed, &Experiment::stateChanged, &Experiment::planChanged,
                      &Experiment::resultsChanged, &Experiment::followed})
    connect(&experiment_, signal, this, qOverload<>(&QWidget::update));
}

void ExperimentProgress::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  const int planned = experiment_.livesPlanned();
  if (planned == 0) return;
  const double track = std::min<double>(kTrack, width());
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  p.drawText(
      QRectF(0, 2, track - 40, 20), Qt::AlignVCenter,
      tr("%1 of %2 lives", nullptr, forms(planned)).arg(countNumber(experiment_.livesShown()), countNumber(planned)));
  p.setFont(textFont(13));
  p.drawText(QRectF(0, 2, track, 20), Qt::AlignRight | Qt::AlignVCenter,
             tr("%1 %").arg(static_cast<int>(std::floor(100 * experiment_.share()))));
  p.fillRect(QRectF(0, 27, track, 4), t.track);
  p.fillRect(QRectF(0, 27, track * experiment_.share(), 4), t.ink);
  if (width() < kMost - 10) return;
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  const auto time = [](double s) {
    return s < 99.5 ? tr("%1 s").arg(std::lround(s)) : tr("%1 min").arg(std::lround(s / 60));
  };
  const double elapsed = experiment_.elapsed();
  if (elapsed > 0) p.drawText(QRectF(256, 2, 160, 18), Qt::AlignVCenter, tr("elapsed %1").arg(time(elapsed)));
  QString second;
  if (const auto left = experiment_.left())
    second = tr("about %1 left").arg(time(*left));
  else if (experiment_.isOpening())
    second = tr("it is being opened …");
  else if (experiment_.state() == Experiment::State::Paused)
    second = tr("paused");
  else if (const double minutes = experiment_.minutes();
           minutes > 0 && experiment_.state() != Experiment::State::Complete && !experiment_.following())
    second = tr("takes about %1").arg(localNumbers(roundedTime(minutes)));
  else if (experiment_.state() == Experiment::State::Complete || experiment_.livesDone() >= planned)
    second = tr("complete");
  else if (experiment_.following())
    second = tr("followed, read only");
  p.drawText(QRectF(256, 19, 160, 18), Qt::AlignVCenter, second);
}

}  // namespace surefoot

#include "moc_experiment_progress.cpp"
