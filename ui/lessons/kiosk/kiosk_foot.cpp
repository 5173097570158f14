// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/kiosk/kiosk_foot.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <cmath>
#include <utility>

#include "ui/controls/hairline.h"
#include "ui/controls/labels.h"
#include "ui/lessons/kiosk/share_slider.h"
#include "ui/style/scale.h"

namespace surefoot {

KioskFoot::KioskFoot(double share, std::string word, QWidget* parent)
    : QWidget(parent),
      leaves_(std::move(word)),
      slider_(new ShareSlider(this)),
      share_(makeText({}, 40, 500, false, this)) {
  auto* row = new QHBoxLayout(this);
  row->addLayout(makeKnob(share), 5);
  row->addWidget(new Hairline(Qt::Vertical, this));
  row->addLayout(makeSees(), 3);
  whenScaled(this, [this, row] {
    setFixedHeight(scaled(175));
    row->setContentsMargins(scaled({24, 16, 24, 12}));
    row->setSpacing(scaled(40));
  });
}

QVBoxLayout* KioskFoot::makeKnob(double share) {
  auto* knob = new QVBoxLayout;
  auto* heads = new QHBoxLayout;
  auto* titles = new QVBoxLayout;
  titles->addWidget(makeText(tr("How much they explore"), 16, 500, false, this));
  titles->addWidget(makeText(tr("in 100 steps both try something else than the best"), 12, 400, true, this));
  heads->addLayout(titles, 1);
  heads->addWidget(share_, 0, Qt::AlignBottom);
  heads->addWidget(makeText(tr("of 100"), 12, 400, true, this), 0, Qt::AlignBottom);
  knob->addLayout(heads);
  knob->addWidget(slider_);
  slider_->setShare(share);
  connect(slider_, &ShareSlider::moved, this, &KioskFoot::moved);
  whenScaled(this, [knob, titles] {
    for (QVBoxLayout* column : {knob, titles}) column->setSpacing(scaled(4));
  });
  return knob;
}

QVBoxLayout* KioskFoot::makeSees() {
  auto* column = new QVBoxLayout;
  sees_ = makeText({}, 13, 400, false, this);
  sees_->setWordWrap(true);
  sees_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  facts_ = makeText({}, 11, 400, true, this);
  word_ = new QLineEdit(this);
  word_->setPlaceholderText(tr("the lesson's word"));
  word_->setAccessibleName(tr("The lesson's word"));
  word_->hide();
  connect(word_, &QLineEdit::returnPressed, this, [this] {
    if (word_->text().toStdString() == leaves_) return Q_EMIT left();
    word_->hide();
    slider_->setFocus();
  });
  column->addWidget(makeText(tr("What you see"), 16, 500, false, this));
  column->addWidget(sees_, 1);
  column->addWidget(facts_);
  column->addWidget(word_);
  whenScaled(this, [column] { column->setSpacing(scaled(4)); });
  return column;
}

void KioskFoot::show(const QString& sees, const QString& facts) {
  share_->setText(QString::number(std::lround(100 * slider_->share())));
  if (!sees.isEmpty()) sees_->setText(sees);
  facts_->setText(facts);
}

void KioskFoot::askForWord() {
  word_->clear();
  word_->show();
  word_->setFocus(Qt::ShortcutFocusReason);
}

}  // namespace surefoot

#include "moc_kiosk_foot.cpp"
