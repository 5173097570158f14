// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scrubber.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

#include "ui/link_button.h"
#include "ui/session.h"
#include "ui/slider.h"

namespace surefoot {

Scrubber::Scrubber(Session& session, QWidget* parent) : QWidget(parent), session_(session), slider_(new Slider(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 2, 12, 4);
  slider_->setAccessibleName(tr("Moment"));
  auto* live = new LinkButton(tr("Back to live"), this);
  row->addWidget(slider_, 1);
  row->addWidget(live);
  connect(live, &QToolButton::clicked, &session_, &Session::backToLive);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    const Playback* p = session_.playback();
    if (p) session_.seek(value * (static_cast<double>(p->frames.size()) - 1.0) / Slider::kSteps);
  });
  connect(&session_, &Session::playbackChanged, this, &Scrubber::refresh);
  connect(&session_, &Session::frame, this, [this] {
    if (isVisible()) refresh();
  });
  hide();
}

void Scrubber::refresh() {
  const Playback* p = session_.playback();
  setVisible(p != nullptr);
  if (!p || p->frames.size() < 2) return;
  const QSignalBlocker blocker(slider_);
  slider_->setValue(static_cast<int>(Slider::kSteps * p->position / (static_cast<double>(p->frames.size()) - 1.0)));
}

}  // namespace surefoot
