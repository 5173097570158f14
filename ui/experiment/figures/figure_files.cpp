// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that are scenes, and figures as files.
#include <QBuffer>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <algorithm>

#include "core/files/whole_file.h"
#include "ui/experiment/figures/figure_painter.h"
#include "ui/language/from_core.h"
#include "ui/style/scene_painter.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

// As large as fits, with both axes to one scale.
void FigurePainter::paintScene(QPainter& p, const Theme& t, QSizeF size) const {
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
  const double line = QFontMetricsF(textFont(11)).height();
  const QRectF plot(64, top() + 20, size.width() - 2 * 64, size.height() - top() - 20 - 3 * line);
  const double scale = std::min(plot.width() / bounds.width(), plot.height() / bounds.height());
  const QPointF middle = bounds.center();
  const ScenePainter painter(
      p, t, false,
      [&](Point at) { return plot.center() + QPointF((at.x - middle.x()) * scale, -(at.y - middle.y()) * scale); },
      scale);
  p.setFont(textFont(11));
  for (const Shape& shape : figure_.scene->shapes) std::visit(painter, shape);
  p.setPen(t.quiet);
  p.setFont(textFont(11));
  drawSymbol(p, QRectF(plot.left(), plot.bottom() + line, plot.width(), line), Qt::AlignHCenter,
             fromCore(figure_.xTitle));
  paintYTitle(p, t, plot);
}

namespace {

constexpr int kPixelsPerInch = 96, kPointsPerInch = 72;

void asPng(QBuffer& buffer, const FigurePainter& figure, const Theme& t, QSize size) {
  QImage image(size * 2, QImage::Format_RGB32);
  image.setDevicePixelRatio(2);
  QPainter p(&image);
  figure.paint(p, t, size);
  p.end();
  image.save(&buffer, "PNG");
}

void asSvg(QBuffer& buffer, const FigurePainter& figure, const Theme& t, QSize size) {
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(size);
  generator.setViewBox(QRect({0, 0}, size));
  generator.setTitle(fromCore(figure.figure().title));
  generator.setResolution(kPixelsPerInch);
  QPainter p(&generator);
  figure.paint(p, t, size);
}

void asPdf(QBuffer& buffer, const FigurePainter& figure, const Theme& t, QSize size) {
  QPdfWriter writer(&buffer);
  writer.setResolution(kPixelsPerInch);
  writer.setPageSize(QPageSize(QSizeF(size) * kPointsPerInch / kPixelsPerInch, QPageSize::Point));
  writer.setPageMargins({});
  writer.setTitle(fromCore(figure.figure().title));
  QPainter p(&writer);
  figure.paint(p, t, size);
}

}  // namespace

QByteArray figureAsPicture(const Figure& figure, const std::string& chosen, const Theme& theme,
                           const std::string& ending) {
  FigurePainter painter(figure);
  painter.setChosen(chosen);
  const QSize size = painter.fullSize().toSize();
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  (ending == ".png" ? asPng : ending == ".svg" ? asSvg : asPdf)(buffer, painter, theme, size);
  return bytes;
}

Status saveFigure(const Figure& figure, const Theme& theme, const std::string& path) {
  for (const char* ending : {".png", ".svg", ".pdf"}) {
    const QByteArray bytes = figureAsPicture(figure, {}, theme, ending);
    if (const Status s =
            writeWhole("figure", path + ending, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
        !s)
      return s;
  }
  return Done{};
}

}  // namespace surefoot
