// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robot/robot_page.h"

#include <fmt/format.h>

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QRegularExpression>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "core/text/text.h"
#include "ui/controls/hairline.h"
#include "ui/controls/labels.h"
#include "ui/controls/link_button.h"
#include "ui/controls/panel.h"
#include "ui/controls/text_button.h"
#include "ui/robot/random_life.h"
#include "ui/robot/robot_picture.h"
#include "ui/robot/robot_text.h"
#include "ui/robot/state_table.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/ask_for_file.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {

/// "~/robots/hopper.toml".
QString shortPath(const QString& path) {
  const QString home = QDir::homePath() + QLatin1Char('/');
  return path.startsWith(home) ? QStringLiteral("~/") + path.mid(home.size()) : path;
}

constexpr int kCheckAfter = 300, kKeepAfter = 1000;  // [ms] of no typing
constexpr std::chrono::milliseconds kPatience(95);

}  // namespace

/// What a text came to.
struct RobotPage::Checked {
  QString text;
  std::vector<Complaint> complaints;
  std::optional<EnvironmentFile> file;
  EnvironmentInspection inspection;
};

RobotPage::RobotPage(const Registry& registry, const QString& folder, QWidget* parent)
    : QWidget(parent),
      registry_(registry),
      source_(folder) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeBar());
  column->addWidget(new Hairline(Qt::Horizontal));
  auto* body = new QWidget;
  auto* row = new QHBoxLayout(body);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(makeDescription(), 416);
  row->addWidget(new Hairline(Qt::Vertical));
  auto* right = new QVBoxLayout;
  right->setSpacing(0);
  right->addWidget(makeWorld(), 448);
  right->addWidget(new Hairline(Qt::Horizontal));
  right->addWidget(makeLife(), 256);
  row->addLayout(right, 864);
  auto* scroll = new QScrollArea;  // on the smallest screens
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(body);
  column->addWidget(scroll, 1);

  pause_.setSingleShot(true);
  pause_.setInterval(kCheckAfter);
  keeping_.setSingleShot(true);
  keeping_.setInterval(kKeepAfter);
  connect(text_, &QPlainTextEdit::textChanged, this, [this] {
    pause_.start();
    keeping_.start();
    refresh();
  });
  connect(&pause_, &QTimer::timeout, this, &RobotPage::check);
  connect(&keeping_, &QTimer::timeout, this, [this] { source_.keep(text_->toPlainText()); });
  connect(&checking_, &Background::failed, this, &RobotPage::refused);
  connect(text_, &RobotText::lineChanged, picture_, &RobotPicture::setLine);
  connect(picture_, &RobotPicture::lineAsked, this, [this](int line) { text_->goTo({line, 1}); });
  connect(picture_, &RobotPicture::limitMoved, this, &RobotPage::writeLimit);
  connect(picture_, &RobotPicture::keyPressed, this, [this](int key) {
    if (key == Qt::Key_Escape) return trial_.stop();
    trial_.press(key);
  });
  connect(table_, &StateTable::lineAsked, this, [this](int line) { text_->goTo({line, 1}); });
  connect(table_, &StateTable::rangeProposed, this, &RobotPage::writeRange);
  connect(life_, &RandomLife::fallAsked, this, [this](int fall) {
    const auto& seen = checked_->inspection;
    const int step = seen.falls[static_cast<std::size_t>(fall)];
    const auto begin = std::lower_bound(seen.begins.begin(), seen.begins.end(), step);
    trial_.replay(*checked_->file, *std::prev(begin), step);
    refresh();
  });
  connect(&trial_, &RobotTrial::moved, this, [this](const Scene& scene) { picture_->setMoving(scene); });
  connect(&trial_, &RobotTrial::stopped, this, [this] {
    picture_->setMoving(std::nullopt);
    refresh();
  });
  connect(&source_, &RobotSource::changedOnDisk, this, [this](const QString& text) {
    text_->replaceAll(text);
    Q_EMIT told(tr("%1 was saved by another program, and is shown as it is now; undo brings back what was here.")
                    .arg(fileName()));
  });
  refresh();
}

QWidget* RobotPage::makeBar() {
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  file_ = new TextButton(QString(), TextButton::Look::Framed);
  files_ = new QMenu(file_);
  connect(file_, &QAbstractButton::clicked, this, [this] {
    fillFiles();
    files_->popup(file_->mapToGlobal(QPoint(0, file_->QWidget::height())));
  });
  state_ = makeText(QString(), 11, 400, true, bar);
  note_ = makeText(QString(), 11, 400, true, bar);
  save_ = new TextButton(tr("Save"), TextButton::Look::Framed);
  try_ = new TextButton(tr("Try"), TextButton::Look::Framed);
  learn_ = new TextButton(tr("Let it learn"), TextButton::Look::Main);
  try_->setStarts(true);
  connect(save_, &QAbstractButton::clicked, this, &RobotPage::save);
  connect(try_, &QAbstractButton::clicked, this, &RobotPage::tryOut);
  connect(learn_, &QAbstractButton::clicked, this, &RobotPage::learn);
  row->addWidget(file_);
  row->addWidget(state_);
  row->addStretch(1);
  row->addWidget(note_);
  for (QWidget* button : {save_, try_, learn_}) row->addWidget(button);
  whenScaled(bar, [this, bar, row] {
    bar->setFixedHeight(scaled(48));
    row->setContentsMargins(scaled({12, 0, 12, 0}));
    row->setSpacing(scaled(8));
    for (TextButton* button : {file_, save_, try_, learn_}) button->setFixedHeight(scaled(32));
  });
  return bar;
}

QWidget* RobotPage::makeDescription() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* head = new PanelHeader(tr("Description"), false, box);
  head->setNote(tr("TOML, checked while you type"));
  errors_ = makeText(QString(), 11, 500, false, box);
  head->addWidget(errors_);
  textHead_ = head;
  text_ = new RobotText;
  lines_ = makeText(QString(), 11, 400, true, box);
  lines_->setWordWrap(false);
  column->addWidget(head);
  column->addWidget(text_, 1);
  column->addWidget(new Hairline(Qt::Horizontal));
  column->addWidget(lines_);
  whenScaled(box, [this] { lines_->setContentsMargins(scaled({12, 6, 12, 6})); });
  return box;
}

QWidget* RobotPage::makeWorld() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  auto* left = new QVBoxLayout;
  left->setSpacing(0);
  worldHead_ = new PanelHeader(tr("World"), false, box);
  worldHead_->setOnPaper(true);
  auto* modes = new QWidget;
  auto* modesRow = new QHBoxLayout(modes);
  modesRow->setContentsMargins(0, 0, 0, 0);
  const auto mode = [&](const QString& text, RobotTrial::Mode which) {
    auto* button = new LinkButton(text, modes);
    connect(button, &QAbstractButton::clicked, this, [this, which] {
      trial_.start(*checked_->file, which);
      picture_->setFocus(Qt::OtherFocusReason);
      refresh();
    });
    modesRow->addWidget(button);
    return button;
  };
  random_ = mode(tr("Random"), RobotTrial::Mode::Random);
  still_ = mode(tr("Motors off"), RobotTrial::Mode::Still);
  handMade_ = mode(tr("Hand-made"), RobotTrial::Mode::HandMade);
  worldHead_->addWidget(modes);
  picture_ = new RobotPicture;
  left->addWidget(worldHead_);
  left->addWidget(picture_, 1);
  row->addLayout(left, 439);
  row->addWidget(new Hairline(Qt::Vertical));
  auto* right = new QVBoxLayout;
  right->setSpacing(0);
  auto* head = new PanelHeader(tr("State"), false, box);
  head->setNote(tr("seen in 4,000 random steps"));
  table_ = new StateTable;
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(table_);
  right->addWidget(head);
  right->addWidget(scroll, 1);
  row->addLayout(right, 424);
  return box;
}

QWidget* RobotPage::makeLife() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* head = new PanelHeader(tr("What a random life looks like"), false, box);
  head->setNote(tr("a click on a mark shows the fall"));
  life_ = new RandomLife;
  column->addWidget(head);
  column->addWidget(life_, 1);
  return box;
}

void RobotPage::fillFiles() {
  files_->clear();
  connect(files_->addAction(tr("Open…")), &QAction::triggered, this, &RobotPage::openWithDialog);
  connect(files_->addAction(tr("Save as…")), &QAction::triggered, this, &RobotPage::saveAs);
  files_->addSeparator();
  files_->addSection(tr("A new robot, like"));
  if (!registry_.files) return;
  for (const std::string& name : registry_.files->shelved())
    connect(files_->addAction(toText(name)), &QAction::triggered, this, [this, name] { beginLike(toText(name)); });
}

void RobotPage::openWithDialog() {
  askForFile(this, tr("Open a robot"), tr("Robots (*.toml)"), [this](const QString& path) { open(path); });
}

void RobotPage::open(const QString& path) {
  everShown_ = true;
  const auto text = source_.open(QFileInfo(path).absoluteFilePath());
  if (!text) return Q_EMIT refused(toText(text.error().message));
  begin(*text);
}

/// Another robot: nothing of the one before is shown any more.
void RobotPage::begin(const QString& text) {
  trial_.stop();
  checked_.reset();
  showInspection(nullptr);
  text_->replaceAll(text);
  text_->moveCursor(QTextCursor::Start);
  check();
}

void RobotPage::showInspection(const EnvironmentInspection* inspection) {
  picture_->setInspection(inspection);
  table_->setInspection(inspection);
  life_->setInspection(inspection);
}

void RobotPage::beginLike(const QString& name) {
  everShown_ = true;
  if (!registry_.files) return;
  RobotSource shelf{QString()};
  const auto text = shelf.open(toText(registry_.files->shelvedPath(name.toStdString())));
  if (!text) return Q_EMIT refused(toText(text.error().message));
  source_.begin(*text);
  begin(*text);
}

bool RobotPage::isEdited() const {
  return source_.isEdited(text_->toPlainText());
}

QString RobotPage::fileName() const {
  return source_.path().isEmpty() ? tr("a new robot") : QFileInfo(source_.path()).fileName();
}

void RobotPage::focusHome() {
  text_->setFocus(Qt::OtherFocusReason);
}

bool RobotPage::save() {
  if (source_.path().isEmpty()) return saveAs();
  const Status s = source_.saveTo(source_.path(), text_->toPlainText());
  if (!s) Q_EMIT refused(toText(s.error().message));
  refresh();
  return static_cast<bool>(s);
}

bool RobotPage::saveAs() {
  const QString name = checked_ ? toText(checked_->inspection.name) : QStringLiteral("robot");
  askForNewFile(this, tr("Save the robot"), name + QStringLiteral(".toml"), tr("Robots (*.toml)"),
                QStringLiteral(".toml"), [this](const QString& path) {
                  if (const Status s = source_.saveTo(path, text_->toPlainText()); !s)
                    Q_EMIT refused(toText(s.error().message));
                  refresh();
                });
  return !isEdited();
}

void RobotPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (std::exchange(everShown_, true)) return;
  const auto draft = source_.draft();
  if (!draft) return beginLike(QStringLiteral("segway"));
  if (draft->path.isEmpty() || !source_.open(draft->path)) source_.begin(QString());
  text_->replaceAll(draft->text);
  check();
  Q_EMIT told(tr("What was not saved of %1 is here again.").arg(fileName()));
}

void RobotPage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  trial_.stop();
  source_.keep(text_->toPlainText());
}

void RobotPage::check() {
  auto made = std::make_shared<Checked>();
  made->text = text_->toPlainText();
  checking_.start(
      [made, library = registry_.files](const std::atomic<bool>&) {
        made->file = library->read(made->text.toStdString(), made->complaints);
        if (!made->file) return;
        made->file->text = made->text.toStdString();
        made->inspection = made->file->inspect();
      },
      [this, made] { take(made); }, kPatience);
}

void RobotPage::take(const std::shared_ptr<Checked>& checked) {
  wrong_ = !checked->file;
  text_->setComplaints(checked->complaints);
  if (checked->file) {
    trial_.stop();
    checked_ = checked;
    showInspection(&checked_->inspection);
    lines_->setToolTip({});
  }
  refresh();
}

void RobotPage::refresh() {
  file_->setText(fileName() + QStringLiteral("  ▾"));
  file_->setAccessibleName(tr("Robot: %1").arg(fileName()));
  file_->updateGeometry();
  state_->setText(isEdited() ? tr("changed, not saved") : source_.path().isEmpty() ? tr("not saved yet") : QString());
  note_->setText(!wrong_    ? QString()
                 : checked_ ? tr("picture and table: as of the last text without an error")
                            : tr("picture and table come when the text has no error"));
  const auto errors = static_cast<int>(text_->complaints().size());
  errors_->setText(errors == 0 ? QString() : errors == 1 ? tr("1 error") : tr("%1 errors").arg(errors));
  QPalette caution = palette();
  caution.setColor(QPalette::WindowText, themeOf(*this).caution);
  errors_->setPalette(caution);
  errors_->adjustSize();
  textHead_->layOutExtra();
  const auto warnings = checked_ ? static_cast<int>(checked_->inspection.warnings.size()) : 0;
  QString foot = errors > 0 ? tr("F8 the next error, Alt+Enter mends it")
                            : tr("%n lines", nullptr, text_->document()->blockCount());
  if (errors == 0 && warnings > 0) {
    const Complaint& first = checked_->inspection.warnings.front();
    foot = tr("line %1: %2").arg(QString::number(first.at.line), toText(first.sentence));
    if (warnings > 1) foot += tr(" (and %1 more)").arg(warnings - 1);
    QStringList all;
    for (const Complaint& w : checked_->inspection.warnings)
      all << tr("line %1: %2").arg(QString::number(w.at.line), toText(w.sentence));
    lines_->setToolTip(tipText(all.join(u'\n')));
  }
  lines_->setText(QFontMetrics(lines_->font()).elidedText(foot, Qt::ElideRight, text_->width() - scaled(24)));
  save_->setEnabled(isEdited() || source_.path().isEmpty());
  for (QAbstractButton* button : std::initializer_list<QAbstractButton*>{try_, random_, still_})
    button->setEnabled(checked_ != nullptr);
  try_->setText(trial_.isRunning() ? tr("Stop") : tr("Try"));
  learn_->setEnabled(checked_ && !wrong_);
  handMade_->setVisible(trial_.handMade());
  worldHead_->setNote(trial_.isRunning() ? trial_.words()
                                         : tr("names and limits under the pointer; a click goes to the line"));
  worldHead_->layOutExtra();
  Q_EMIT statusChanged(
      source_.path().isEmpty() ? tr("a robot that is not saved yet") : shortPath(source_.path()),
      checked_ ? tr("%1 tiles a tiling").arg(toText(countText(checked_->inspection.tiles))) : QString());
}

// Degrees to the nearest whole one, written in radians as people write them: 30 / 180 * pi would be an expression, and
// a number is what can be dragged again.
void RobotPage::writeLimit(const AngleHandle& handle, double angle) {
  if (!handle.number || wrong_ || text_->toPlainText() != checked_->text) return;
  static const QRegularExpression kNumber(QStringLiteral("^[-+0-9.eE_]+"));
  const auto number = kNumber.match(text_->lineFrom(*handle.number));
  if (!number.hasMatch()) return;
  text_->write(*handle.number, static_cast<int>(number.capturedLength()), toText(fmt::format("{:.4g}", angle)));
  text_->goTo(*handle.number);
  pause_.stop();
  check();
}

void RobotPage::writeRange(const SeenState& state) {
  if (wrong_ || text_->toPlainText() != checked_->text) return;
  static const QRegularExpression kRange(QStringLiteral("^\\[[^\\]]*\\]"));
  const auto range = kRange.match(text_->lineFrom(state.rangeAt));
  if (!range.hasMatch()) return;
  text_->write(state.rangeAt, static_cast<int>(range.capturedLength()),
               toText(fmt::format("[{:.4g}, {:.4g}]", state.proposedLow, state.proposedHigh)));
  text_->goTo(state.rangeAt);
  pause_.stop();
  check();
}

void RobotPage::tryOut() {
  if (trial_.isRunning()) return trial_.stop();
  trial_.start(*checked_->file, RobotTrial::Mode::Random);
  picture_->setFocus(Qt::OtherFocusReason);
  refresh();
}

void RobotPage::learn() {
  if (isEdited() && !source_.path().isEmpty() && !save()) return;
  const std::string text = text_->toPlainText().toStdString();
  const auto file = source_.path().isEmpty() ? registry_.files->add(text, fileName().toStdString())
                                             : registry_.files->open(source_.path().toStdString());
  if (!file) return Q_EMIT refused(toText(file.error().message));
  trial_.stop();
  Q_EMIT learnAsked((*file)->entry.name);
}

}  // namespace surefoot

#include "moc_robot_page.cpp"
