// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that are scenes, and figures as files.
#include <QBuffer>
#include <QPdfWriter>
#include <algorithm>

#include "core/files/whole_file.h"
#include "ui/figure_view.h"
#include "ui/scene_painter.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

// As large as fits, with both axes to one scale.
void FigureView::paintScene(QPainter& p, const Theme& t) const {
  QRectF bounds;
  const auto include = [&](const Point& point) {
    const QRectF dot(point.x, point.y, 1e-6, 1e-6);
    bounds = bounds.isNull() ? dot : bounds.united(dot);
  };
  for (const Shape& shape : figure_.scene->shapes) {
    if (const auto* line = std::get_if<Polyline>(&shape))
      std::for_each(line->points.begin(), line->points.end(), include);
    if (const auto* polygon = std::get_if<Polygon>(&shape))
      std::for_each(polygon->points.begin(), polygon->points.end(), include);
    if (const auto* disc = std::get_if<Disc>(&shape))
      for (const double sign : {-1.0, 1.0})
        include({disc->centre.x + sign * disc->radius, disc->centre.y + sign * disc->radius});
  }
  const QRectF plot(kLeft, top() + 20, width() - 2 * kLeft, height() - top() - kBottom - 20);
  const double scale = std::min(plot.width() / bounds.width(), plot.height() / bounds.height());
  const QPointF middle = bounds.center();
  const ScenePainter painter(
      p, t, false,
      [&](Point at) { return plot.center() + QPointF((at.x - middle.x()) * scale, -(at.y - middle.y()) * scale); },
      scale);
  p.setFont(textFont(11));
  for (const Shape& shape : figure_.scene->shapes) std::visit(painter, shape);
  paintTitles(p, t, plot);
}

Status FigureView::save(const std::string& path) {
  resize(sizeHint());
  const Theme& t = themeOf(*this);
  QByteArray png, pdf;
  {
    QImage image(size() * 2, QImage::Format_RGB32);
    image.setDevicePixelRatio(2);
    QPainter p(&image);
    paint(p, t);
    p.end();
    QBuffer buffer(&png);
    image.save(&buffer, "PNG");
  }
  {
    QBuffer buffer(&pdf);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    constexpr int kPointsPerInch = 72, kPixelsPerInch = 96;
    writer.setResolution(kPixelsPerInch);
    writer.setPageSize(QPageSize(QSizeF(size()) * kPointsPerInch / kPixelsPerInch, QPageSize::Point));
    writer.setPageMargins({});
    writer.setTitle(toText(figure_.title));
    QPainter p(&writer);
    paint(p, t);
  }
  for (const auto& [ending, bytes] : {std::pair<const char*, const QByteArray&>{".png", png}, {".pdf", pdf}}) {
    if (const Status s =
            writeWhole("figure", path + ending, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
        !s)
      return s;
  }
  return Done{};
}

}  // namespace surefoot
