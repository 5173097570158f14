// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/view_menu.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>

#include "ui/controls/message_bar.h"
#include "ui/style/painted.h"
#include "ui/style/symbol_text.h"
#include "ui/support/ask_for_file.h"
#include "ui/support/exporting.h"
#include "ui/support/keyboard.h"

namespace surefoot {

namespace {

/// The ring around a view that does not draw one itself.
class FocusRing final : public QWidget {
 public:
  explicit FocusRing(QWidget* view) : QWidget(view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    ScaledPainter p(this);
    drawFocusRing(p, *parentWidget());
  }
};

QWidget* top(QWidget& view) {
  QWidget* widget = &view;
  while (widget->parentWidget()) widget = widget->parentWidget();
  return widget;
}

void tell(QWidget& view, const Status& status, const QString& done) {
  auto* bar = top(view)->findChild<MessageBar*>();
  if (bar) status ? bar->tell(done) : bar->say(toText(status.error().message));
}

}  // namespace

ViewMenu::ViewMenu(QWidget& view, std::function<std::string()> csv)
    : QObject(&view),
      view_(view),
      csv_(std::move(csv)) {
  if (view.focusPolicy() == Qt::NoFocus) {
    view.setFocusPolicy(Qt::TabFocus);
    new FocusRing(&view);
  }
  view.installEventFilter(this);
  if (auto* area = qobject_cast<QAbstractScrollArea*>(&view)) area->viewport()->installEventFilter(this);
}

bool ViewMenu::eventFilter(QObject* watched, QEvent* event) {
  auto* ring = static_cast<FocusRing*>(nullptr);
  for (QObject* child : view_.children())
    if (auto* found = dynamic_cast<FocusRing*>(child)) ring = found;
  switch (event->type()) {
    case QEvent::FocusIn:
    case QEvent::FocusOut:
    case QEvent::Resize:
      if (ring && watched == &view_) {
        ring->setGeometry(view_.rect());
        ring->raise();
        ring->setVisible(event->type() == QEvent::Resize ? ring->isVisible() : event->type() == QEvent::FocusIn);
      }
      return false;
    case QEvent::KeyPress: {
      const auto& key = static_cast<QKeyEvent&>(*event);
      const bool shiftF10 = key.key() == Qt::Key_F10 && key.modifiers() == Qt::ShiftModifier;
      const bool asked = key.key() == Qt::Key_Menu || shiftF10;
      if (asked) open(view_.mapToGlobal(view_.rect().center()));
      return asked;
    }
    case QEvent::ContextMenu: {
      const auto& asked = static_cast<QContextMenuEvent&>(*event);
      if (asked.reason() == QContextMenuEvent::Mouse && (QApplication::mouseButtons() & Qt::RightButton)) return true;
      open(asked.reason() == QContextMenuEvent::Mouse ? asked.globalPos() : view_.mapToGlobal(view_.rect().center()));
      return true;
    }
    default:
      return filterMouse(*event);
  }
}

/// The menu opens when the right button comes up where it went down.
bool ViewMenu::filterMouse(QEvent& event) {
  if (event.type() != QEvent::MouseButtonPress && event.type() != QEvent::MouseButtonRelease) return false;
  const auto& mouse = static_cast<QMouseEvent&>(event);
  if (mouse.button() != Qt::RightButton) return false;
  const QPoint at = mouse.globalPosition().toPoint();
  if (event.type() == QEvent::MouseButtonPress) {
    pressed_ = at;
    return false;
  }
  const bool still = pressed_ && (at - *pressed_).manhattanLength() < QApplication::startDragDistance();
  pressed_.reset();
  if (still) open(at);
  return false;
}

bool ViewMenu::hasNumbers() const {
  return csv_ || dynamic_cast<const CsvSource*>(&view_);
}

std::string ViewMenu::numbers() const {
  if (csv_) return csv_();
  const auto* source = dynamic_cast<const CsvSource*>(&view_);
  return source ? source->asCsv() : "";
}

void ViewMenu::open(const QPoint& at) {
  if (QApplication::activePopupWidget()) return;
  auto* menu = new QMenu(&view_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (auto* source = dynamic_cast<CsvSource*>(&view_)) source->fillMenu(*menu);
  menu->addAction(tr("Copy the picture"), this, &ViewMenu::copyPicture);
  QAction* copy = hasNumbers() ? menu->addAction(tr("Copy the numbers"), this, &ViewMenu::copyNumbers) : nullptr;
  menu->addSeparator();
  for (const char* ending : {"png", "svg", "pdf", "csv"}) {
    if (ending == std::string("csv") && !hasNumbers()) continue;
    const QString name = QLatin1String(ending);
    QAction* action = menu->addAction(tr("Export as %1 …").arg(name.toUpper()), this, [this, name] { exportAs(name); });
    if (name == QLatin1String("csv") && numbers().empty()) action->setEnabled(false), copy->setEnabled(false);
  }
  menu->popup(at);
}

void ViewMenu::copyPicture() {
  QApplication::clipboard()->setImage(pictureOf(view_));
  tell(view_, Done{}, tr("The picture is in the clipboard."));
}

void ViewMenu::copyNumbers() {
  QApplication::clipboard()->setText(toText(numbers()));
  tell(view_, Done{}, tr("The numbers are in the clipboard, as CSV."));
}

void ViewMenu::exportAs(const QString& ending) {
  QString title = view_.accessibleName().isEmpty() ? tr("View") : view_.accessibleName();
  QString name = title.toLower();
  name.replace(' ', '-');
  askForNewFile(top(view_), tr("Export %1").arg(title), name + '.' + ending,
                QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending), ending, [this](const QString& path) {
                  tell(view_, exportView(view_, path.toStdString(), numbers()), tr("%1 is written.").arg(path));
                });
}

}  // namespace surefoot

#include "moc_view_menu.cpp"
