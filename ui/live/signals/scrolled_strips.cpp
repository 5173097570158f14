// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/signals/scrolled_strips.h"

#include <QScrollBar>

#include "ui/live/signals/signals_shown.h"
#include "ui/live/signals/strip_charts.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr int kAxis = static_cast<int>(StripPainter::kTimes) + 1;  // [px], with its line

/// The time axis of strip charts, over the lower end of what is seen of them; the mouse reaches the charts below it.
class TimeAxis final : public Painted<> {
 public:
  TimeAxis(const StripCharts& charts, QWidget* parent) : Painted(parent), charts_(charts) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Theme& t = themeOf(*this);
    ScaledPainter p(this);
    p.fillRect(rect(), t.panel);
    if (!charts_.showsStrips()) return;
    const StripPicture what = charts_.picture();
    p.translate(0, kAxis - charts_.height());
    StripPainter(t, what, charts_.rect()).paintTimes(p);
  }

 private:
  const StripCharts& charts_;
};

}  // namespace

ScrolledStrips::ScrolledStrips(SignalsShown& shown, QWidget* parent)
    : QScrollArea(parent),
      charts_(new StripCharts(shown)),
      axis_(new TimeAxis(*charts_, viewport())) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);
  setWidget(charts_);
  whenScaled(this, [this] { placeAxis(); });
  connect(verticalScrollBar(), &QScrollBar::rangeChanged, this, &ScrolledStrips::placeAxis);
  for (const auto changed : {&SignalsShown::changed, &SignalsShown::moment})
    connect(&shown, changed, axis_, qOverload<>(&QWidget::update));
}

void ScrolledStrips::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  placeAxis();
}

/// Where nothing is scrolled the charts' own is in sight.
void ScrolledStrips::placeAxis() {
  const int height = scaled(kAxis);
  axis_->setGeometry(0, viewport()->height() - height, viewport()->width(), height);
  axis_->setVisible(verticalScrollBar()->maximum() > 0);
  axis_->raise();
}

}  // namespace surefoot

#include "moc_scrolled_strips.cpp"
