// SPDX-License-Identifier: GPL-3.0-or-later
// Fusion drawn flat: hairlines and one rounded frame in place of bevels and gradients. Every colour comes from the
// palette's theme, so a change of colours is a change of palette. (With a style sheet Qt matches its selectors for
// every widget anew, which took longer than anything else in the window.)
#pragma once

#include <QProxyStyle>

class QStyleOptionMenuItem;
class QStyleOptionSpinBox;
class QStyleOptionTab;

namespace surefoot {

class FlatStyle final : public QProxyStyle {
  Q_OBJECT

 public:
  FlatStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override;
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override;
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                         const QWidget* widget) const override;
  QRect subElementRect(SubElement element, const QStyleOption* option, const QWidget* widget) const override;
  QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                       const QWidget* widget) const override;

  using QProxyStyle::polish;
  void polish(QWidget* widget) override;

 private:
  /// False: not a surface of this style's own.
  static bool drawSurface(PrimitiveElement element, QPainter& painter, const QStyleOption& option,
                          const QWidget* widget);
  /// The extra margin of a column's head beyond Fusion's, so that its words stand above the words of the cells [px].
  int headMargin() const;
  void drawMenuEntry(ControlElement element, const QStyleOptionMenuItem& item, QPainter& painter,
                     const QWidget* widget) const;
  void drawTab(ControlElement element, const QStyleOptionTab& tab, QPainter& painter, const QWidget* widget) const;
  void drawSpinBox(const QStyleOptionSpinBox& option, QPainter& painter, const QWidget* widget) const;
};

}  // namespace surefoot
