// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the Robot page, put together.
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QShortcut>
#include <QVBoxLayout>

#include "ui/controls/hairline.h"
#include "ui/controls/labels.h"
#include "ui/controls/link_button.h"
#include "ui/controls/panel.h"
#include "ui/controls/text_button.h"
#include "ui/language/numbers.h"
#include "ui/robot/random_life.h"
#include "ui/robot/robot_checked.h"
#include "ui/robot/robot_picture.h"
#include "ui/robot/robot_text.h"
#include "ui/robot/state_table.h"
#include "ui/style/scale.h"
#include "ui/support/plain_text.h"

namespace surefoot {

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
  allow_ = new TextButton(tr("Allow it to start"), TextButton::Look::Framed);
  save_ = new TextButton(tr("Save"), TextButton::Look::Framed);
  try_ = new TextButton(tr("Try"), TextButton::Look::Framed);
  learn_ = new TextButton(tr("Let it learn"), TextButton::Look::Main);
  try_->setStarts(true);
  connect(allow_, &QAbstractButton::clicked, this, &RobotPage::allow);
  connect(save_, &QAbstractButton::clicked, this, &RobotPage::save);
  connect(try_, &QAbstractButton::clicked, this, &RobotPage::tryOut);
  connect(learn_, &QAbstractButton::clicked, this, &RobotPage::learn);
  row->addWidget(file_);
  row->addWidget(state_);
  row->addStretch(1);
  row->addWidget(note_);
  for (QWidget* button : {allow_, save_, try_, learn_}) row->addWidget(button);
  whenScaled(bar, [this, bar, row] {
    bar->setFixedHeight(scaled(48));
    row->setContentsMargins(scaled({12, 0, 12, 0}));
    row->setSpacing(scaled(8));
    for (TextButton* button : {file_, allow_, save_, try_, learn_}) button->setFixedHeight(scaled(32));
  });
  return bar;
}

QWidget* RobotPage::makeDescription() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* head = new PanelHeader(tr("Description"), false, box);
  errors_ = makeText(QString(), 11, 500, false, box);
  head->addWidget(errors_);
  head->setHelp(QStringLiteral("robot-format"));
  textHead_ = head;
  text_ = new RobotText;
  lines_ = new OneLine(11, box);
  column->addWidget(head);
  column->addWidget(text_, 1);
  column->addWidget(makeFind(box));
  column->addWidget(new Hairline(Qt::Horizontal));
  column->addWidget(lines_);
  whenScaled(box, [this] { lines_->setContentsMargins(scaled({12, 6, 12, 6})); });
  return box;
}

/// Ctrl+F: a line to search the text with; Return goes on, around the end; Escape ends it.
QWidget* RobotPage::makeFind(QWidget* parent) {
  auto* find = new QLineEdit(parent);
  find->setPlaceholderText(tr("Find; Return: the next one, Escape: done"));
  find->setAccessibleName(tr("Find in the description"));
  find->hide();
  const auto next = [this, find] {
    if (text_->find(find->text())) return;
    text_->moveCursor(QTextCursor::Start);
    text_->find(find->text());
  };
  connect(find, &QLineEdit::returnPressed, this, next);
  connect(find, &QLineEdit::textEdited, this, [this, next] {  // from the beginning of what is found already
    QTextCursor from = text_->textCursor();
    from.setPosition(from.selectionStart());
    text_->setTextCursor(from);
    next();
  });
  const auto shortcut = [&](const QKeySequence& key, QWidget* owner, Qt::ShortcutContext where, auto slot) {
    connect(new QShortcut(key, owner, nullptr, nullptr, where), &QShortcut::activated, this, slot);
  };
  shortcut(QKeySequence::Find, this, Qt::WidgetWithChildrenShortcut, [find] {
    find->show();
    find->setFocus(Qt::ShortcutFocusReason);
    find->selectAll();
  });
  shortcut(Qt::Key_Escape, find, Qt::WidgetShortcut, [this, find] {
    find->hide();
    text_->setFocus(Qt::OtherFocusReason);
  });
  whenScaled(find, [find] { find->setFont(scaledFont(13, 400)); });
  return find;
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
  passive_ = mode(tr("Passive"), RobotTrial::Mode::Passive);
  passive_->setToolTip(
      tipText(tr("Left to itself: no motors, dampers, friction and contacts. What moves less and less "
                 "then loses its energy to the size of the substeps.")));
  drop_ = mode(tr("Drop"), RobotTrial::Mode::Dropped);
  drop_->setToolTip(tipText(tr("As it is drawn, from 20 cm above the ground, motors off")));
  handMade_ = mode(tr("Hand-made"), RobotTrial::Mode::HandMade);
  worldHead_->addWidget(modes);
  worldHead_->setHelp(QStringLiteral("page-robot"));
  picture_ = new RobotPicture;
  left->addWidget(worldHead_);
  left->addWidget(picture_, 1);
  row->addLayout(left, 439);
  row->addWidget(new Hairline(Qt::Vertical));
  auto* right = new QVBoxLayout;
  right->setSpacing(0);
  auto* head = new PanelHeader(tr("State"), false, box);
  head->setNote(tr("seen in %1 random steps").arg(countNumber(4000)));
  head->setHelp(QStringLiteral("page-robot"));
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
  head->setHelp(QStringLiteral("page-robot"));
  life_ = new RandomLife;
  column->addWidget(head);
  column->addWidget(life_, 1);
  return box;
}

}  // namespace surefoot
