// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/plans/plan_chooser.h"

#include <QFrame>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>

#include "core/plans/plan_time.h"
#include "ui/experiment/figures/condition_name.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {

enum Columns { Number, Title, Time };
constexpr int kSource = Qt::UserRole;  // an item's index in the list of sources; headings have none

/// Everything that a search looks through.
QString haystack(const PlanSource& s) {
  QString text = toText(s.name + ' ' + s.title + ' ' + s.answers + ' ') + fromCore(s.group);
  for (const std::string& shown : s.shows) text += ' ' + toText(shown);
  return text.toLower();
}

bool showsExactly(const PlanSource& s, const QString& words) {
  return std::any_of(s.shows.begin(), s.shows.end(), [&](const std::string& n) { return toText(n) == words; });
}

}  // namespace

QString numbersOf(const PlanSource& source) {
  QStringList numbers;
  for (const std::string& shown : source.shows) {
    const QString text = toText(shown);
    if (text.contains(QRegularExpression(QStringLiteral("[0-9]")))) numbers << text;
  }
  QStringList plain;
  for (const QString& n : numbers)
    if (n[0].isDigit()) plain << n;
  if (plain.size() > 1) return plain.front() + QStringLiteral("–") + plain.back();
  return plain.isEmpty() ? numbers.join(QStringLiteral(", ")) : plain.front();
}

PlanChooser::PlanChooser(const QString& name, std::vector<PlanSource> sources, QWidget* parent)
    : QComboBox(parent),
      sources_(std::move(sources)) {
  setAccessibleName(name);
  setToolTip(tr("What to run: plans, the thesis's figures, your own files"));
  setSizeAdjustPolicy(AdjustToContents);
  addItem(tr("Choose a plan"));
}

QSize PlanChooser::minimumSizeHint() const {
  return {12 * QFontMetrics(scaledFont(13)).averageCharWidth(), QComboBox::minimumSizeHint().height()};
}

void PlanChooser::setCurrent(const QString& title) {
  setItemText(0, title);
  setToolTip(tipText(title));
}

void PlanChooser::addOwn(const QString& title, const QString& path) {
  const std::string where = path.toStdString();
  for (PlanSource& s : sources_)
    if (s.path == where) {
      if (s.group == tr("Your own files").toStdString()) s.title = title.toStdString();
      return;
    }
  sources_.push_back({.title = title.toStdString(), .path = where, .group = tr("Your own files").toStdString()});
}

void PlanChooser::makeList() {
  popup_ = new QFrame(this, Qt::Popup);
  popup_->setFrameShape(QFrame::StyledPanel);
  words_ = new QLineEdit;
  words_->setAccessibleName(tr("Search the experiments"));
  words_->setPlaceholderText(tr("Search: a figure's number, a word"));
  words_->setClearButtonEnabled(true);
  words_->installEventFilter(this);
  list_ = new QTreeWidget;
  list_->setAccessibleName(tr("Experiments"));
  list_->setColumnCount(3);
  list_->setHeaderLabels({tr("Figure"), tr("Title"), tr("Takes")});
  list_->headerItem()->setTextAlignment(Time, Qt::AlignRight | Qt::AlignVCenter);
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  answer_ = new QLabel;
  answer_->setTextFormat(Qt::PlainText);
  answer_->setWordWrap(true);
  auto* open = new QPushButton(tr("Open a plan or results …"));
  auto* column = new QVBoxLayout(popup_);
  whenScaled(popup_, [this, column] {
    answer_->setMinimumHeight(2 * QFontMetrics(scaledFont(13)).lineSpacing());
    list_->setIndentation(scaled(12));
    column->setContentsMargins(scaled({8, 8, 8, 8}));
    column->setSpacing(scaled(6));
  });
  column->addWidget(words_);
  column->addWidget(list_, 1);
  column->addWidget(answer_);
  column->addWidget(open, 0, Qt::AlignLeft);
  connect(words_, &QLineEdit::textChanged, this, &PlanChooser::search);
  connect(list_, &QTreeWidget::currentItemChanged, this, &PlanChooser::tell);
  connect(list_, &QTreeWidget::itemClicked, this, &PlanChooser::take);
  connect(list_, &QTreeWidget::itemActivated, this, &PlanChooser::take);
  connect(open, &QPushButton::clicked, this, [this] {
    hidePopup();
    Q_EMIT openAsked();
  });
}

void PlanChooser::fill() {
  list_->clear();
  std::vector<std::string> groups;
  for (const PlanSource& s : sources_)
    if (std::find(groups.begin(), groups.end(), s.group) == groups.end()) groups.push_back(s.group);
  for (const std::string& group : groups) {
    auto* head = new QTreeWidgetItem(list_, {group.empty() ? tr("Plans") : fromCore(group)});
    head->setFirstColumnSpanned(true);
    head->setFlags(Qt::ItemIsEnabled);
    head->setFont(0, scaledFont(11, 500));
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const PlanSource& s = sources_[i];
      if (s.group != group) continue;
      const QString time = s.minutes > 0 ? tr("about %1").arg(localNumbers(roundedTime(s.minutes))) : QString();
      auto* item = new QTreeWidgetItem(head, {numbersOf(s), toText(s.title), time});
      item->setData(0, kSource, static_cast<int>(i));
      item->setToolTip(Title, tipText(toText(s.title)));
      item->setTextAlignment(Time, Qt::AlignRight | Qt::AlignVCenter);
    }
  }
  list_->expandAll();
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(Number, QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(Title, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(Time, QHeaderView::ResizeToContents);
}

void PlanChooser::search(const QString& words) {
  const QStringList parts = words.toLower().split(' ', Qt::SkipEmptyParts);
  QTreeWidgetItem *first = nullptr, *exact = nullptr;
  for (int g = 0; g < list_->topLevelItemCount(); ++g) {
    QTreeWidgetItem* head = list_->topLevelItem(g);
    bool any = false;
    for (int i = 0; i < head->childCount(); ++i) {
      QTreeWidgetItem* item = head->child(i);
      const PlanSource& s = sources_[static_cast<std::size_t>(item->data(0, kSource).toInt())];
      const QString text = haystack(s);
      const bool fits = std::all_of(parts.begin(), parts.end(), [&](const QString& p) { return text.contains(p); });
      item->setHidden(!fits);
      any = any || fits;
      if (fits && !first) first = item;
      if (fits && !exact && showsExactly(s, words.trimmed())) exact = item;
    }
    head->setHidden(!any);
  }
  list_->setCurrentItem(exact ? exact : first);
  if (!first) answer_->setText(tr("Nothing is called that."));
}

void PlanChooser::tell(QTreeWidgetItem* item) {
  if (!item || !item->data(0, kSource).isValid()) return answer_->clear();
  const PlanSource& s = sources_[static_cast<std::size_t>(item->data(0, kSource).toInt())];
  answer_->setText(s.answers.empty() ? toText(s.path) : toText(s.answers));
}

void PlanChooser::take(QTreeWidgetItem* item) {
  if (!item || !item->data(0, kSource).isValid()) return;
  const QString path = toText(sources_[static_cast<std::size_t>(item->data(0, kSource).toInt())].path);
  hidePopup();
  Q_EMIT planChosen(path);
}

void PlanChooser::showPopup() {
  if (!popup_) makeList();
  fill();
  const QRect room = screen()->availableGeometry();
  const QFontMetrics metrics(scaledFont(13));
  const QSize size = QSize(std::max(width(), 70 * metrics.averageCharWidth()), 28 * metrics.lineSpacing())
                         .boundedTo(room.size() - QSize(16, 16));
  QPoint at = mapToGlobal(QPoint(0, height() + 2));
  at.setX(std::clamp(at.x(), room.left(), std::max(room.left(), room.right() - size.width())));
  at.setY(std::clamp(at.y(), room.top(), std::max(room.top(), room.bottom() - size.height())));
  popup_->setGeometry(QRect(at, size));
  words_->clear();
  search({});
  popup_->show();
  words_->setFocus();
}

void PlanChooser::hidePopup() {
  if (popup_) popup_->hide();
  QComboBox::hidePopup();
}

void PlanChooser::wheelEvent(QWheelEvent* event) {
  event->ignore();
}

// Arrows and Return in the search go to the list.
bool PlanChooser::eventFilter(QObject* object, QEvent* event) {
  if (object != words_ || event->type() != QEvent::KeyPress) return QComboBox::eventFilter(object, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    take(list_->currentItem());
    return true;
  }
  if (key != Qt::Key_Up && key != Qt::Key_Down) return false;
  QTreeWidgetItem* next = list_->currentItem();
  do next = next ? key == Qt::Key_Up ? list_->itemAbove(next) : list_->itemBelow(next) : nullptr;
  while (next && !next->data(0, kSource).isValid());
  if (next) list_->setCurrentItem(next);
  return true;
}

}  // namespace surefoot

#include "moc_plan_chooser.cpp"
