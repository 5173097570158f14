// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/kiosk/kiosk_window.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/lessons/lesson_life.h"
#include "ui/controls/hairline.h"
#include "ui/controls/labels.h"
#include "ui/controls/text_button.h"
#include "ui/language/numbers.h"
#include "ui/lessons/kiosk/kiosk_robot.h"
#include "ui/lessons/kiosk/share_slider.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/announce.h"

namespace surefoot {

namespace {

constexpr int kSettle = 1000;          // [ms] after the knob was moved, both begin anew
constexpr int kQuiet = 16;             // [s] without a touch: the countdown shows itself
constexpr int kInvite = 20;            // [s] without a touch: the ring comes back
constexpr int kAnnounceEvery = 10;     // [s]
constexpr double kPush = 0.12;         // [N s]
constexpr std::int64_t kMeasure = 60;  // episodes in which the share of a temperature is measured

Configuration under(const Configuration& start, const char* policy) {
  Configuration c = start;
  c.names.policy = policy;
  return c;
}

}  // namespace

Result<Configuration> kioskStart(const Registry& registry, const Lesson& lesson) {
  auto lived = LessonLife::begin(registry, lesson, lesson.start.seed);
  if (!lived) return lived.error();
  if (const Status s = lived->act(lesson.steps.at(0).begin); !s) return s.error();
  return lived->configuration();
}

KioskWindow::KioskWindow(const Registry& registry, const Lesson& lesson, const Configuration& start, int resetAfter,
                         QWidget* parent)
    : QWidget(parent),
      registry_(registry),
      kiosk_(*lesson.kiosk),
      start_(start),
      resetAfter_(resetAfter),
      foot_(new KioskFoot(kiosk_.share, kiosk_.word, this)) {
  setWindowTitle(toText(kiosk_.question));
  first_ = new KioskRobot(registry, under(start, "epsilon-greedy"), tr("ε-greedy"), tr("tries anything"), this);
  second_ = new KioskRobot(registry, under(start, "softmax"), tr("Softmax"), tr("tries what is nearly as good"), this);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeHead());
  column->addWidget(new Hairline(Qt::Horizontal, this));
  auto* robots = new QHBoxLayout;
  robots->setSpacing(0);
  robots->addWidget(first_, 1);
  robots->addWidget(new Hairline(Qt::Vertical, this));
  robots->addWidget(second_, 1);
  column->addLayout(robots, 1);
  column->addWidget(new Hairline(Qt::Horizontal, this));
  column->addWidget(foot_);
  connect(foot_, &KioskFoot::left, this, [this] { close(); });
  connect(foot_, &KioskFoot::moved, this, [this] {
    refresh();
    settling_.start(kSettle);
  });
  // A push on either pole is given to both, or the comparison would not be fair.
  const auto share = [this](Looking& from, Looking& to) {
    connect(&from, &Looking::held, this, [this, &to](std::optional<double> target) {
      if (std::exchange(holding_, true)) return;
      to.hold(target);
      holding_ = false;
    });
  };
  share(first_->session().looking(), second_->session().looking());
  share(second_->session().looking(), first_->session().looking());
  settling_.setSingleShot(true);
  connect(&settling_, &QTimer::timeout, this, &KioskWindow::beginBoth);
  connect(&ticking_, &QTimer::timeout, this, &KioskWindow::tick);
  ticking_.start(250);
  untouched_.start();
  announced_.start();
  qApp->installEventFilter(this);
  measureShares();
}

KioskWindow::~KioskWindow() {
  qApp->removeEventFilter(this);
  measuring_.cancel();
}

QWidget* KioskWindow::makeHead() {
  auto* head = new QWidget(this);
  auto* row = new QHBoxLayout(head);
  auto* question = makeText(toText(kiosk_.question), 24, 500, false, head);
  row->addWidget(question);
  row->addWidget(makeText(toText(kiosk_.note), 13, 400, true, head), 1);
  again_ = new QWidget(head);
  auto* again = new QHBoxLayout(again_);
  again->setContentsMargins(0, 0, 0, 0);
  countdown_ = makeText({}, 11, 400, true, again_);
  auto* button = new TextButton(tr("Start again"), TextButton::Look::Framed, again_);
  connect(button, &QAbstractButton::clicked, this, &KioskWindow::beginAgain);
  again->addWidget(countdown_);
  again->addWidget(button);
  row->addWidget(again_);
  whenScaled(head, [head, row] {
    head->setFixedHeight(scaled(75));
    row->setContentsMargins(scaled({24, 0, 24, 0}));
    row->setSpacing(scaled(16));
  });
  return head;
}

/// Once, before anything is shown: how often Softmax explores at each temperature, for a robot that begins as these do.
void KioskWindow::measureShares() {
  auto shares = std::make_shared<std::vector<ShareOfTemperature>>();
  measuring_.start(
      [shares, &registry = registry_, start = start_](const std::atomic<bool>& interrupted) {
        *shares = sharesOfSoftmax(registry, start, kMeasure, &interrupted);
      },
      [this, shares] {
        shares_ = std::move(*shares);
        beginBoth();
      });
  refresh();
}

void KioskWindow::beginBoth() {
  constexpr double kColdest = 1e-3;
  const double share = slider().share();
  epsilon_ = epsilonFor(share, first_->session().life().task().actions.size());
  temperature_ = std::max(kColdest, temperatureFor(share, shares_));
  const auto tell = [this](const Status& s) {
    if (!s) foot_->show({}, toText(s.error().message));
  };
  tell(first_->begin("policy.epsilon", epsilon_));
  tell(second_->begin("policy.temperature", temperature_));
  refresh();
}

void KioskWindow::beginAgain() {
  slider().setShare(kiosk_.share);
  settling_.stop();
  beginBoth();
  untouched_.restart();
  wasTouched_ = false;
}

void KioskWindow::push() {
  for (KioskRobot* robot : {first_, second_}) robot->session().life().push(kPush);
}

std::optional<int> KioskWindow::secondsLeft() const {
  const int idle = static_cast<int>(untouched_.elapsed() / 1000);
  return idle < kQuiet && resetAfter_ > kQuiet ? std::nullopt : std::optional(std::max(0, resetAfter_ - idle));
}

void KioskWindow::touched() {
  untouched_.restart();
  wasTouched_ = true;
  tick();
}

bool KioskWindow::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::TouchBegin:
    case QEvent::KeyPress:
    case QEvent::Wheel:
      touched();
      break;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

void KioskWindow::keyPressEvent(QKeyEvent* event) {
  const bool leaves = event->key() == Qt::Key_K && event->modifiers() == (Qt::ControlModifier | Qt::ShiftModifier);
  if (leaves) return foot_->askForWord();
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
      return slider().move(event->key() == Qt::Key_Left ? -1 : 1);
    case Qt::Key_Space:
      return push();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return beginAgain();
    default:
      return;
  }
}

void KioskWindow::tick() {
  const auto left = secondsLeft();
  const bool asIs = slider().share() == kiosk_.share && first_->session().life().numbers().episodes < kiosk_.episodes;
  again_->setVisible(left.has_value() || !asIs);
  countdown_->setText(left ? tr("by itself in %1 s").arg(*left) : QString());
  if (left && *left == 0) beginAgain();
  first_->invite(!wasTouched_ || untouched_.elapsed() > 1000 * kInvite);
  refresh();
  if (announced_.elapsed() > 1000 * kAnnounceEvery) tellFalls();
}

void KioskWindow::tellFalls() {
  announced_.restart();
  announce(*this, tr("ε-greedy %1 falls, Softmax %2 falls")
                      .arg(first_->session().life().numbers().falls)
                      .arg(second_->session().life().numbers().falls));
}

void KioskWindow::refresh() {
  const Numbers &a = first_->session().life().numbers(), &b = second_->session().life().numbers();
  const std::int64_t both = std::min(a.episodes, b.episodes);
  const QString explain = toText(kiosk_.explain);
  if (shares_.empty()) return foot_->show(explain, tr("It is being made ready …"));
  const QString facts =
      tr("ε = %1 against τ = %2, %3 episodes each")
          .arg(fixedNumber(epsilon_, 3), fixedNumber(temperature_, 2), countNumber(static_cast<double>(both)));
  const QString counted = tr("After %1 episodes: %2 falls against %3.").arg(both).arg(a.falls).arg(b.falls);
  foot_->show(slider().share() == 0    ? tr("Now neither tries anything: both always take what they think is best.")
              : both < kiosk_.episodes ? explain
                                       : counted + '\n' + explain,
              facts);
}

/// All texts follow the size of the screen: ×1.6 on one of 1920 × 1080.
void KioskWindow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const double fits = std::min(width() / 1200.0, height() / 675.0);
  const double size = std::clamp(std::floor(10 * fits) / 10, kSmallestText, kLargestText);
  if (size != textSize())
    QMetaObject::invokeMethod(
        this, [size] { applyTextSize(size); }, Qt::QueuedConnection);
}

}  // namespace surefoot

#include "moc_kiosk_window.cpp"
