// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/kiosk/kiosk_robot.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/controls/labels.h"
#include "ui/language/numbers.h"
#include "ui/live/world/world_view.h"
#include "ui/style/painted.h"
#include "ui/style/policy_look.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

class Mark final : public Painted<> {
 public:
  Mark(std::string policy, QWidget* parent) : Painted(parent), policy_(std::move(policy)) {
    whenScaled(this, [this] { setFixedSize(scaled(QSize(20, 20))); });
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    ScaledPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    p.translate(10, 10);
    p.scale(1.4, 1.4);
    drawMarker(p, {0, 0}, policyLook(policy_, themeOf(*this)), true);
  }

 private:
  std::string policy_;
};

/// A dashed ring around the tip, with words: it can be touched. It takes no touch itself.
class Invitation final : public Painted<> {
 public:
  explicit Invitation(WorldView& world) : Painted(&world), world_(world) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
  }
  void follow() {
    setGeometry(QRect(QPoint(), world_.QWidget::size()));
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    constexpr double kRing = 24, kAway = 60;
    const Theme& t = themeOf(*this);
    ScaledPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const QPointF tip = world_.tip();
    p.setPen(QPen(t.ink, 1.5, Qt::DashLine));
    p.drawEllipse(tip, kRing, kRing);
    p.setPen(QPen(t.ink, 1));
    p.drawLine(tip + QPointF(kRing, -4), tip + QPointF(kAway, -16));
    p.fillRect(QRectF(tip.x() + kAway + 2, tip.y() - 28, 140, 36), t.paper);  // over the marks of the scale
    p.setFont(textFont(13, 500));
    p.drawText(tip + QPointF(kAway + 6, -14), KioskRobot::tr("Touch the pole"));
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    p.drawText(tip + QPointF(kAway + 6, 2), KioskRobot::tr("both get the same push"));
  }

 private:
  WorldView& world_;
};

}  // namespace

KioskRobot::KioskRobot(const Registry& registry, Configuration configuration, const QString& name, const QString& about,
                       QWidget* parent)
    : QWidget(parent),
      session_(std::make_unique<Session>(registry, configuration, false)),
      start_(std::move(configuration)),
      world_(new WorldView(session_->life(), session_->looking(), this)),
      falls_(new FallLabel(48, 500, this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* head = new QHBoxLayout;
  auto* words = new QVBoxLayout;
  auto* named = new QHBoxLayout;
  named->addWidget(new Mark(start_.names.policy, this));
  named->addWidget(makeText(name, 17, 500, false, this));
  named->addStretch(1);
  words->addLayout(named);
  words->addWidget(makeText(about, 12, 400, true, this));
  words->addStretch(1);
  head->addLayout(words, 1);
  head->addWidget(falls_, 0, Qt::AlignBottom);
  head->addWidget(makeText(tr("falls"), 12, 400, true, this), 0, Qt::AlignBottom);
  whenScaled(this, [head] {
    head->setContentsMargins(scaled({24, 12, 24, 0}));
    head->setSpacing(scaled(8));
  });
  setAutoFillBackground(true);
  column->addLayout(head);
  column->addWidget(world_, 1);
  world_->setAccessibleName(tr("World of %1").arg(name));
  world_->setPlain(true);
  auto* invitation = new Invitation(*world_);
  invitation_ = invitation;
  connect(&session_->looking(), &Looking::frame, invitation, [invitation] {
    if (invitation->isVisible()) invitation->follow();
  });
  for (const auto changed : {&RunningLife::valuesArrived, &RunningLife::replaced, &RunningLife::stateChanged})
    connect(&session_->life(), changed, this, &KioskRobot::refresh);
  refresh();
}

void KioskRobot::invite(bool on) {
  invitation_->setVisible(on);
}

KioskRobot::~KioskRobot() {
  delete world_;  // it knows the session
}

Status KioskRobot::begin(const std::string& key, double value) {
  Configuration anew = start_;
  if (const Status s = anew.parameters.set(key, value); !s) return s;
  const Status begun = session_->newLives().begin(std::move(anew));
  session_->life().setRunning(true);
  return begun;
}

void KioskRobot::refresh() {
  const Theme& t = themeOf(*this);
  falls_->setText(countNumber(static_cast<double>(session_->life().numbers().falls)));
  QPalette own = this->palette();
  if (own.color(QPalette::Window) == t.paper) return;
  own.setColor(QPalette::Window, t.paper);
  setPalette(own);
}

}  // namespace surefoot

#include "moc_kiosk_robot.cpp"
