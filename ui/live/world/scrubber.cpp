// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/world/scrubber.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>

#include "ui/controls/link_button.h"
#include "ui/controls/slider.h"
#include "ui/running/looking.h"
#include "ui/style/scale.h"
#include "ui/support/plain_text.h"

namespace surefoot {

Scrubber::Scrubber(Looking& looking, QWidget* parent)
    : QWidget(parent),
      looking_(looking),
      play_(new LinkButton(tr("Play"), this)),
      goOn_(new LinkButton(tr("Go on from here"), this)),
      live_(new LinkButton(tr("Back to live"), this)),
      slider_(new Slider(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  slider_->setAccessibleName(tr("Moment"));
  whenScaled(this, [this, row] {
    row->setSpacing(scaled(4));
    slider_->setMinimumWidth(scaled(24));
  });
  row->addWidget(play_);
  row->addWidget(slider_, 1);
  row->addWidget(goOn_);
  row->addWidget(live_);
  goOn_->setToolTip(tipText(tr("The learner's world is put into this moment, and it goes on learning there")));
  connect(goOn_, &QToolButton::clicked, this, &Scrubber::goOnAsked);
  connect(play_, &QToolButton::clicked, this, [this] {
    if (const Playback* p = looking_.playback()) looking_.play(p->rate == 0);
  });
  connect(live_, &QToolButton::clicked, &looking_, &Looking::backToLive);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    const Playback* p = looking_.playback();
    if (p) looking_.seek(value * (static_cast<double>(p->frames.size()) - 1.0) / Slider::kSteps);
  });
  connect(&looking_, &Looking::playbackChanged, this, &Scrubber::place);
  connect(&looking_, &Looking::frame, this, [this] {
    if (looking_.playback()) refresh();
  });
  place();
}

void Scrubber::fold(int room) {
  const int link = goOn_->sizeHint().width() + scaled(4), least = scaled(290);
  goOn_->setVisible(looking_.playback() && room >= least + link);
  const int usual = goOn_->isHidden() ? least : least + link;
  setFixedWidth(looking_.playback() ? std::clamp(usual, 0, std::max(0, room)) : 0);
}

void Scrubber::place() {
  for (QWidget* part : std::initializer_list<QWidget*>{play_, slider_, live_}) part->setVisible(looking_.playback());
  if (auto* header = qobject_cast<PanelHeader*>(parentWidget())) header->layOutExtra(), header->update();
  refresh();
}

void Scrubber::refresh() {
  const Playback* p = looking_.playback();
  if (!p || p->frames.size() < 2) return;
  const QString does = p->rate > 0 ? tr("Stop") : tr("Play");
  if (play_->text() != does) play_->setText(does), play_->setAccessibleName(does);
  const QSignalBlocker blocker(slider_);
  slider_->setValue(static_cast<int>(Slider::kSteps * p->position / (static_cast<double>(p->frames.size()) - 1.0)));
}

}  // namespace surefoot

#include "moc_scrubber.cpp"
