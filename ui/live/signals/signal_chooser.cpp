// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/signals/signal_chooser.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include "ui/controls/link_button.h"
#include "ui/language/from_core.h"
#include "ui/live/signals/signals_shown.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {
constexpr int kKey = Qt::UserRole, kWithAbove = Qt::UserRole + 1;
}

SignalChooser::SignalChooser(SignalsShown& shown, QWidget* parent)
    : QFrame(parent, Qt::Popup),
      shown_(shown),
      search_(new QLineEdit),
      list_(new QListWidget) {
  setFrameShape(QFrame::StyledPanel);
  auto* column = new QVBoxLayout(this);
  search_->setPlaceholderText(tr("Search signals"));
  search_->setAccessibleName(tr("Search signals"));
  search_->setClearButtonEnabled(true);
  list_->setAccessibleName(tr("Signals"));
  list_->setDragDropMode(QAbstractItemView::InternalMove);
  list_->setFrameShape(QFrame::NoFrame);
  column->addWidget(search_);
  column->addWidget(list_, 1);
  auto* row = new QHBoxLayout;
  const auto button = [&](const QString& text, const QString& tip, auto&& does) {
    auto* link = new LinkButton(text);
    link->setToolTip(tipText(tip));
    connect(link, &QToolButton::clicked, this, does);
    row->addWidget(link);
  };
  button(tr("Up"), tr("One place up (Ctrl+Up)"), [this] { move(-1); });
  button(tr("Down"), tr("One place down (Ctrl+Down)"), [this] { move(+1); });
  button(tr("With the one above"), tr("In one strip with the signal above, or in a strip of its own (Ctrl+J)"),
         [this] { join(); });
  row->addStretch(1);
  button(tr("Usual ones"), tr("What is shown at first"), [this] {
    shown_.setUsualStrips();
    fill();
  });
  column->addLayout(row);
  whenScaled(this, [this, column, row] {
    column->setContentsMargins(scaled({8, 8, 8, 8}));
    column->setSpacing(scaled(6));
    row->setSpacing(scaled(4));
    for (QWidget* w : std::initializer_list<QWidget*>{search_, list_}) w->setFont(scaledFont(13));
    resize(scaled(QSize{400, 440}));
  });
  connect(search_, &QLineEdit::textChanged, this, &SignalChooser::filter);
  connect(list_, &QListWidget::itemChanged, this, &SignalChooser::take);
  connect(list_->model(), &QAbstractItemModel::rowsMoved, this, &SignalChooser::take);
  connect(list_->model(), &QAbstractItemModel::rowsRemoved, this, &SignalChooser::take);  // a drag inserts and removes
}

void SignalChooser::openAt(const QPoint& below) {
  fill();
  search_->clear();
  QPoint at = below;
  if (const QScreen* on = screen())
    at.setX(std::clamp(at.x(), on->availableGeometry().left(), on->availableGeometry().right() - width())),
        at.setY(std::min(at.y(), on->availableGeometry().bottom() - height()));
  QFrame::move(at);
  show();
  search_->setFocus();
}

QListWidgetItem* SignalChooser::add(const std::string& key, bool chosen, bool withAbove) {
  auto* item = new QListWidgetItem(list_);
  item->setData(kKey, toText(key));
  item->setData(kWithAbove, withAbove);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsDragEnabled);
  item->setCheckState(chosen ? Qt::Checked : Qt::Unchecked);
  name(*item);
  return item;
}

void SignalChooser::name(QListWidgetItem& item) {
  const auto& signals = shown_.table().signals();
  const std::size_t at = signalAt(signals, item.data(kKey).toString().toStdString());
  if (at == signals.size()) return item.setText(item.data(kKey).toString());
  QString text = plainSymbols(fromCore(signals[at].title));
  if (!signals[at].unit.empty()) text += QStringLiteral("  [%1]").arg(toText(signals[at].unit));
  item.setText(item.data(kWithAbove).toBool() ? QStringLiteral("    + ") + text : text);
  item.setToolTip(tipText(tr("%1, of the group %2").arg(item.data(kKey).toString(), fromCore(signals[at].group))));
}

void SignalChooser::fill() {
  filling_ = true;
  list_->clear();
  std::set<std::string> chosen;
  for (const Strip& strip : shown_.strips())
    for (std::size_t i = 0; i < strip.size(); ++i) {
      if (!chosen.insert(strip[i]).second) continue;
      add(strip[i], true, i > 0);
    }
  for (const Signal& s : shown_.table().signals())
    if (!chosen.contains(s.key) && s.group != "time") add(s.key, false, false);
  filling_ = false;
  filter();
}

void SignalChooser::filter() {
  const QString wanted = search_->text().trimmed();
  for (int i = 0; i < list_->count(); ++i) {
    QListWidgetItem* item = list_->item(i);
    item->setHidden(!wanted.isEmpty() && !item->text().contains(wanted, Qt::CaseInsensitive) &&
                    !item->toolTip().contains(wanted, Qt::CaseInsensitive));
  }
}

void SignalChooser::take() {
  if (filling_) return;
  std::vector<Strip> strips;
  for (int i = 0; i < list_->count(); ++i) {
    const QListWidgetItem* item = list_->item(i);
    if (!item || item->checkState() != Qt::Checked) continue;
    const std::string key = item->data(kKey).toString().toStdString();
    item->data(kWithAbove).toBool() && !strips.empty() ? strips.back().push_back(key) : strips.push_back({key});
  }
  shown_.setStrips(std::move(strips));
}

void SignalChooser::move(int way) {
  const int row = list_->currentRow(), to = row + way;
  if (row < 0 || to < 0 || to >= list_->count()) return;
  filling_ = true;
  QListWidgetItem* item = list_->takeItem(row);
  list_->insertItem(to, item);
  list_->setCurrentItem(item);
  filling_ = false;
  take();
}

void SignalChooser::join() {
  QListWidgetItem* item = list_->currentItem();
  if (!item || list_->currentRow() == 0) return;
  filling_ = true;
  item->setData(kWithAbove, !item->data(kWithAbove).toBool());
  item->setCheckState(Qt::Checked);
  name(*item);
  filling_ = false;
  take();
}

void SignalChooser::keyPressEvent(QKeyEvent* event) {
  const bool control = event->modifiers() & Qt::ControlModifier;
  if (control && event->key() == Qt::Key_Up) return move(-1);
  if (control && event->key() == Qt::Key_Down) return move(+1);
  if (control && event->key() == Qt::Key_J) return join();
  if (event->key() == Qt::Key_Down && search_->hasFocus()) return list_->setFocus();
  QFrame::keyPressEvent(event);
}

}  // namespace surefoot

#include "moc_signal_chooser.cpp"
