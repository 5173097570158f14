// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/falls_list.h"

#include <fmt/format.h>

#include <QAbstractTableModel>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <algorithm>

#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/style/theme.h"
#include "ui/support/keyboard.h"

namespace surefoot {

namespace {

/// Numbers are read from the right, names from the left; the heads stand over them.
Qt::Alignment alignmentOf(int column) {
  return Qt::AlignVCenter | (column == 4 ? Qt::AlignLeft : Qt::AlignRight);
}

/// The person's actions in the episode, because of which the fall is not the policy's alone.
QString handOf(const Fall& fall) {
  if (fall.inputs.before > 0) return QObject::tr("gone on with");
  return fall.inputs.start.empty() ? QObject::tr("pushed") : QObject::tr("placed");
}

}  // namespace

class FallsModel final : public QAbstractTableModel {
 public:
  FallsModel(RunningLife& life, Looking& looking, QObject* parent)
      : QAbstractTableModel(parent),
        life_(life),
        looking_(looking) {}
  void refresh() {
    beginResetModel();
    numbers_.clear();
    for (auto fall = looking_.falls().rbegin(); fall != looking_.falls().rend(); ++fall)
      numbers_.push_back(fall->number);
    endResetModel();
  }
  /// The number of the fall in a row as the list shows them; 0: there is none.
  std::int64_t numberIn(int row) const {
    return row >= 0 && row < rowCount({}) ? numbers_[static_cast<std::size_t>(row)] : 0;
  }
  /// −1: it is not (any more) in the list.
  int rowOf(std::int64_t number) const {
    const auto at = std::find(numbers_.begin(), numbers_.end(), number);
    return at == numbers_.end() ? -1 : static_cast<int>(at - numbers_.begin());
  }
  int rowCount(const QModelIndex&) const override { return static_cast<int>(numbers_.size()); }
  int columnCount(const QModelIndex&) const override { return 5; }
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    static const char* const kHeads[] = {QT_TRANSLATE_NOOP("QObject", "Fall"), QT_TRANSLATE_NOOP("QObject", "Episode"),
                                         QT_TRANSLATE_NOOP("QObject", "Time min"),
                                         QT_TRANSLATE_NOOP("QObject", "Steps"), QT_TRANSLATE_NOOP("QObject", "Policy")};
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole) return QVariant::fromValue(alignmentOf(section));
    return role == Qt::DisplayRole ? QObject::tr(kHeads[section]) : QVariant();
  }
  QVariant data(const QModelIndex& index, int role) const override {
    if (role == Qt::TextAlignmentRole) return QVariant::fromValue(alignmentOf(index.column()));
    if (role == Qt::ToolTipRole) return QObject::tr("Click to see the last seconds of this fall again");
    const auto fromEnd = static_cast<std::size_t>(index.row()) + 1;
    if (role != Qt::DisplayRole || fromEnd > looking_.falls().size()) return {};
    const Fall& fall = looking_.falls()[looking_.falls().size() - fromEnd];
    const double perStep = life_.task().stepTime.value_or(0.0) / 60.0;
    switch (index.column()) {
      case 0:
        return countNumber(static_cast<double>(fall.number));
      case 1:
        return countNumber(static_cast<double>(fall.episode));
      case 2:
        return perStep > 0 ? fixedNumber(static_cast<double>(fall.lifeSteps) * perStep, 2) : QStringLiteral("–");
      case 3:
        return countNumber(static_cast<double>(fall.inputs.actions.size()));
      default: {
        const auto entry = findEntry(life_.registry().policies, "policy", fall.policy);
        const QString policy = fromCore(entry ? (*entry)->title : fall.policy);
        return fall.byHand() ? QObject::tr("%1, %2 by hand").arg(policy, handOf(fall)) : policy;
      }
    }
  }

 private:
  RunningLife& life_;
  Looking& looking_;
  std::vector<std::int64_t> numbers_;
};

FallsList::FallsList(RunningLife& life, Looking& looking, QWidget* parent)
    : QTableView(parent),
      life_(life),
      looking_(looking),
      model_(new FallsModel(life, looking, this)) {
  setModel(model_);
  connect(&looking_, &Looking::fallsArrived, this, [this] {
    if (isVisible() || looking_.falls().empty()) refresh();
  });
  verticalHeader()->hide();
  whenScaled(this, [this] {
    verticalHeader()->setDefaultSectionSize(scaled(24));
    horizontalHeader()->setFont(scaledFont(11, 500));
  });
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  horizontalHeader()->setHighlightSections(false);
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setShowGrid(false);
  setFrameShape(QFrame::NoFrame);
  setTabKeyNavigation(false);
  setProperty(kRowsOnly, true);  // ← → belong to the replay
  connect(this, &QTableView::clicked, this, &FallsList::replay);
  connect(this, &QTableView::activated, this, &FallsList::replay);
}

void FallsList::showEvent(QShowEvent* event) {
  refresh();
  QTableView::showEvent(event);
}

/// New falls come in above the others: the one that is chosen stays chosen, and whoever has scrolled down sees the same
/// rows as before.
void FallsList::refresh() {
  const std::int64_t chosen = model_->numberIn(currentIndex().row());
  const std::int64_t top = verticalScrollBar()->value() > 0 ? model_->numberIn(rowAt(0)) : 0;
  model_->refresh();
  setAutoScroll(false);  // to choose would scroll
  if (const int row = model_->rowOf(chosen); row >= 0) setCurrentIndex(model_->index(row, 0));
  setAutoScroll(true);
  if (const int row = model_->rowOf(top); row >= 0) scrollTo(model_->index(row, 0), PositionAtTop);
}

std::string FallsList::asCsv() const {
  if (looking_.falls().empty()) return "";
  std::string csv = "fall,episode,minutes,steps,policy,by_hand\n";
  const double perStep = life_.task().stepTime.value_or(0.0) / 60.0;
  for (const Fall& fall : looking_.falls())
    csv += fmt::format("{},{},{},{},{},{}\n", fall.number, fall.episode,
                       perStep > 0 ? fmt::format("{:.9g}", static_cast<double>(fall.lifeSteps) * perStep) : "",
                       fall.inputs.actions.size(), fall.policy,
                       !fall.byHand()              ? ""
                       : fall.inputs.before > 0    ? "gone on"
                       : fall.inputs.start.empty() ? "pushed"
                                                   : "placed");
  return csv;
}

void FallsList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)
    return looking_.lookBack(event->key() == Qt::Key_Left ? -1 : 1);
  QTableView::keyPressEvent(event);
}

void FallsList::replay(const QModelIndex& index) {
  looking_.replayFall(looking_.falls().size() - 1 - static_cast<std::size_t>(index.row()));
}

void FallsList::paintEvent(QPaintEvent* event) {
  QTableView::paintEvent(event);
  if (!looking_.falls().empty()) return;
  const Theme& t = themeOf(*this);
  QPainter p(viewport());
  p.setFont(scaledFont(11));
  p.setPen(t.quiet);
  p.drawText(viewport()->rect(), Qt::AlignCenter,
             life_.snapshot().totals.falls > 0
                 ? tr("The next falls appear here.\nThose before were not recorded in this window.")
                 : tr("Falls appear here. None so far."));
}

}  // namespace surefoot

#include "moc_falls_list.cpp"
