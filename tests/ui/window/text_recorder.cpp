// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window/text_recorder.h"

#include <QPaintDevice>
#include <QPaintEngine>
#include <QWidget>

namespace surefoot {

namespace {

class Engine final : public QPaintEngine {
 public:
  Engine() : QPaintEngine(AllFeatures) {}
  bool begin(QPaintDevice*) override { return true; }
  bool end() override { return true; }
  void updateState(const QPaintEngineState& changed) override {
    if (changed.state() & DirtyTransform) transform_ = changed.transform();
  }
  Type type() const override { return User; }
  void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
  void drawPath(const QPainterPath&) override {}
  void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
  void drawTextItem(const QPointF& at, const QTextItem& item) override {
    if (item.text().trimmed().isEmpty()) return;
    const double size = item.font().pixelSize();  // letters reach from 0.72 above the line to 0.2 below it
    const QRectF letters(at.x(), at.y() - 0.72 * size, item.width(), 0.92 * size);
    DrawnText text{item.text(), transform_.mapRect(letters), {}};
    if (painter()->hasClipping()) text.clip = transform_.mapRect(painter()->clipBoundingRect());
    if (!text.clip || text.clip->intersects(text.place)) texts.push_back(text);
  }
  std::vector<DrawnText> texts;

 private:
  QTransform transform_;
};

class Device final : public QPaintDevice {
 public:
  explicit Device(QSize size) : size_(size) {}
  QPaintEngine* paintEngine() const override { return &engine; }
  mutable Engine engine;

 protected:
  int metric(PaintDeviceMetric metric) const override {
    switch (metric) {
      case PdmWidth:
        return size_.width();
      case PdmHeight:
        return size_.height();
      case PdmDevicePixelRatioScaled:
        return static_cast<int>(devicePixelRatioFScale());
      case PdmDevicePixelRatio:
        return 1;
      case PdmDepth:
        return 32;
      default:
        return 96;
    }
  }

 private:
  QSize size_;
};

QString place(const QRectF& r) {
  return QStringLiteral("[%1, %2, %3 × %4]")
      .arg(r.x(), 0, 'f', 0)
      .arg(r.y(), 0, 'f', 0)
      .arg(r.width(), 0, 'f', 0)
      .arg(r.height(), 0, 'f', 0);
}

}  // namespace

std::vector<DrawnText> drawnTexts(QWidget& widget) {
  Device device(widget.size());
  widget.render(&device, {}, {}, QWidget::DrawWindowBackground);
  return device.engine.texts;
}

std::vector<QString> cutOrOverlapping(QWidget& widget, bool scrolls) {
  constexpr double kTouch = 1.5;  // [px] that texts may share: their boxes are a little larger than their letters
  const auto shared = [](const QRectF& a, const QRectF& b) {
    const QRectF both = a & b;
    return both.width() >= kTouch && both.height() >= kTouch;
  };
  const auto holds = [](const QRectF& room, const QRectF& text) {
    return room.adjusted(-kTouch, -kTouch, kTouch, kTouch).contains(text);
  };
  std::vector<QString> wrong;
  const std::vector<DrawnText> texts = drawnTexts(widget);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const QString said = QStringLiteral("\"%1\" at %2").arg(texts[i].text, place(texts[i].place));
    if (!scrolls && !holds(widget.rect(), texts[i].place)) wrong.push_back(said + " leaves it");
    if (!scrolls && texts[i].clip && !holds(*texts[i].clip, texts[i].place)) wrong.push_back(said + " is cut");
    for (const QWidget* child : widget.findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
      if (child->isVisible() && !child->isWindow() && shared(texts[i].place, child->geometry()))
        wrong.push_back(QStringLiteral("%1 lies under a %2 \"%3\"")
                            .arg(said, child->metaObject()->className(), child->accessibleName()));
    for (std::size_t j = 0; j < i; ++j)
      if (texts[i].text != texts[j].text && shared(texts[i].place, texts[j].place))  // the same: a halo
        wrong.push_back(QStringLiteral("%1 lies over \"%2\" at %3").arg(said, texts[j].text, place(texts[j].place)));
  }
  return wrong;
}

}  // namespace surefoot
