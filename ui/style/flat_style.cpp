// SPDX-License-Identifier: GPL-3.0-or-later
// How large things are and where their parts lie; flat_style_fields, _items and _surfaces draw them.
#include "ui/style/flat_style.h"

#include <QDialog>
#include <QLabel>
#include <QStyleFactory>
#include <QStyleOption>
#include <QTableView>

#include "ui/style/scale.h"

namespace surefoot {

namespace {

constexpr int kFieldMargin = 9, kChevron = 18, kShortestHandle = 24;               // [px]
constexpr int kMenuItemMargin = 5, kSeparator = 9, kCellMargin = 10, kField = 26;  // [px]
constexpr int kSpinMargin = 6;
constexpr int kSpinButtons = 22;

/// The buttons stand above each other at the right end, as large as the text is.
QRect spinBoxPart(const QStyleOptionSpinBox& box, QStyle::SubControl part, const QRect& usual) {
  const int buttons = scaled(box.buttonSymbols == QAbstractSpinBox::NoButtons ? kSpinMargin : kSpinButtons);
  const QRect right(box.rect.right() + 1 - buttons, box.rect.top(), buttons, box.rect.height());
  if (part == QStyle::SC_SpinBoxUp) return right.adjusted(0, 0, 0, -right.height() / 2);
  if (part == QStyle::SC_SpinBoxDown) return right.adjusted(0, right.height() / 2, 0, 0);
  if (part != QStyle::SC_SpinBoxEditField) return usual;
  return QRect(usual.left() + scaled(kSpinMargin), usual.top(), right.left() - usual.left() - scaled(kSpinMargin),
               usual.height());
}

/// The handle, or the groove before or after it. There are no buttons at the ends.
QRect scrollBarPart(const QStyleOptionSlider& bar, QStyle::SubControl part) {
  const bool upright = bar.orientation == Qt::Vertical;
  const int length = upright ? bar.rect.height() : bar.rect.width();
  const qint64 all = qint64{bar.maximum} - bar.minimum + bar.pageStep;
  const int share = all > 0 ? static_cast<int>(qint64{bar.pageStep} * length / all) : length;
  const int handle = qMin(length, qMax(share, scaled(kShortestHandle)));
  const int start =
      QStyle::sliderPositionFromValue(bar.minimum, bar.maximum, bar.sliderPosition, length - handle, bar.upsideDown);
  int from = 0, to = length;
  if (part == QStyle::SC_ScrollBarSlider)
    from = start, to = start + handle;
  else if (part == QStyle::SC_ScrollBarSubPage)
    to = start;
  else if (part == QStyle::SC_ScrollBarAddPage)
    from = start + handle;
  else if (part != QStyle::SC_ScrollBarGroove)
    return {};
  const QRect r = upright ? QRect(0, from, bar.rect.width(), to - from) : QRect(from, 0, to - from, bar.rect.height());
  return r.translated(bar.rect.topLeft());
}

bool isFramed(const QStyleOption* option) {
  const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
  return frame && frame->lineWidth > 0;
}

}  // namespace

FlatStyle::FlatStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

int FlatStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
  switch (metric) {
    case PM_MenuBarPanelWidth:
    case PM_MenuBarVMargin:
    case PM_TabBarTabOverlap:
    case PM_TabBarTabShiftVertical:
      return 0;
    case PM_DockWidgetFrameWidth:  // frame of a floating panel: a line, and room to drag it
      return 4;
    case PM_MenuPanelWidth:
      return 1;
    case PM_MenuBarHMargin:
    case PM_MenuBarItemSpacing:
    case PM_MenuHMargin:
    case PM_MenuVMargin:
      return scaled(4);
    case PM_DockWidgetSeparatorExtent:  // shown as one hairline, but wide enough to drag
      return scaled(5);
    case PM_ToolTipLabelFrameWidth:
      return scaled(9);
    case PM_TabBarTabVSpace:
    case PM_ScrollBarExtent:
      return scaled(8);
    case PM_IndicatorWidth:
    case PM_IndicatorHeight:
    case PM_ExclusiveIndicatorWidth:
    case PM_ExclusiveIndicatorHeight:
      return scaled(14);
    case PM_TabBarTabHSpace:
      return scaled(20);
    case PM_ScrollBarSliderMin:
      return scaled(kShortestHandle);
    case PM_FocusFrameHMargin:  // margin of a cell's text, less one pixel
      return qobject_cast<const QTableView*>(widget) ? scaled(kCellMargin) - 1
                                                     : QProxyStyle::pixelMetric(metric, option, widget);
    default:
      return QProxyStyle::pixelMetric(metric, option, widget);
  }
}

int FlatStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                         QStyleHintReturn* data) const {
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons || hint == SH_EtchDisabledText) return 0;
  if (hint == SH_RubberBand_Mask) return 0;  // all of it is drawn
  return QProxyStyle::styleHint(hint, option, widget, data);
}

int FlatStyle::headMargin() const {
  return scaled(kCellMargin) - pixelMetric(PM_HeaderMargin, nullptr, nullptr);
}

QSize FlatStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                  const QWidget* widget) const {
  const QSize usual = QProxyStyle::sizeFromContents(type, option, contents, widget);
  switch (type) {
    case CT_PushButton:
      return contents + scaled({26, 12});
    case CT_ComboBox:
      return {contents.width() + scaled(2 * kFieldMargin + kChevron) + 3,  // Fusion keeps a pixel at both ends
              qMax(contents.height() + 2, scaled(kField))};
    case CT_LineEdit:
      return isFramed(option) ? contents + scaled({2 * kFieldMargin, 8}) : usual;
    case CT_SpinBox:
      return (usual + QSize(scaled(kSpinMargin + kSpinButtons), 0)).expandedTo({0, scaled(kField)});
    case CT_MenuBarItem:
      return contents + scaled({16, 8});
    case CT_MenuItem: {
      const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
      if (!item) return usual;
      if (item->menuItemType == QStyleOptionMenuItem::Separator && item->text.isEmpty())
        return {usual.width(), scaled(kSeparator)};
      const int height = item->fontMetrics.height() + scaled(2 * kMenuItemMargin);
      const int ticks = static_cast<int>(0.79 * height);  // Fusion draws their column so wide, and reserves 21 pixels
      return {usual.width() + qMax(0, ticks - 21), height};
    }
    case CT_HeaderSection:
      return usual + QSize(2 * headMargin(), scaled(8));
    default:
      return usual;
  }
}

QRect FlatStyle::subElementRect(SubElement element, const QStyleOption* option, const QWidget* widget) const {
  if (element == SE_LineEditContents && isFramed(option))
    return option->rect.adjusted(scaled(kFieldMargin), scaled(4), -scaled(kFieldMargin), -scaled(4));
  return QProxyStyle::subElementRect(element, option, widget);
}

QRect FlatStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                                const QWidget* widget) const {
  if (const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option); bar && control == CC_ScrollBar)
    return scrollBarPart(*bar, part);
  if (control == CC_ComboBox && part == SC_ComboBoxEditField)
    return option->rect.adjusted(scaled(kFieldMargin), 3, -scaled(kFieldMargin + kChevron), -3);  // its frame is seen
  if (const auto* box = qstyleoption_cast<const QStyleOptionSpinBox*>(option); box && control == CC_SpinBox)
    return spinBoxPart(*box, part, QProxyStyle::subControlRect(control, option, part, widget));
  if (control == CC_ComboBox && part == SC_ComboBoxArrow)
    return {option->rect.right() - scaled(kField), option->rect.top(), scaled(20), option->rect.height()};
  return QProxyStyle::subControlRect(control, option, part, widget);
}

void FlatStyle::polish(QWidget* widget) {
  QProxyStyle::polish(widget);
  if (qobject_cast<QDialog*>(widget)) widget->setAttribute(Qt::WA_StyledBackground);  // drawPrimitive(PE_Widget)
  // A label shows its text unchanged, even if it looks like HTML; tooltips do this themselves.
  if (auto* label = qobject_cast<QLabel*>(widget); label && label->textFormat() == Qt::AutoText)
    if (!label->inherits("QTipLabel")) label->setTextFormat(Qt::PlainText);
}

}  // namespace surefoot

#include "moc_flat_style.cpp"
