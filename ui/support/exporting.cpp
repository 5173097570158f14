// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/support/exporting.h"

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "core/files/whole_file.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr int kPixelsPerInch = 96, kPointsPerInch = 72;

QImage rendered(QWidget& view) {
  QImage image(view.size() * 2, QImage::Format_RGB32);
  image.setDevicePixelRatio(2);
  image.fill(themeOf(view).panel);
  view.render(&image);
  return image;
}

QByteArray asPng(QWidget& view) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  rendered(view).save(&buffer, "PNG");
  return bytes;
}

QByteArray asSvg(QWidget& view) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(view.size());
  generator.setViewBox(QRect({0, 0}, view.size()));
  generator.setTitle(view.accessibleName());
  generator.setResolution(kPixelsPerInch);
  view.render(&generator);
  return bytes;
}

QByteArray asPdf(QWidget& view) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setResolution(kPixelsPerInch);
  writer.setPageSize(QPageSize(QSizeF(view.size()) * kPointsPerInch / kPixelsPerInch, QPageSize::Point));
  writer.setPageMargins({});
  writer.setTitle(view.accessibleName());
  view.render(&writer);
  return bytes;
}

}  // namespace

QImage pictureOf(QWidget& view) {
  auto* source = dynamic_cast<CsvSource*>(&view);
  if (source) source->prepareExport(true);
  const QImage picture = rendered(view);
  if (source) source->prepareExport(false);
  return picture;
}

Status exportView(QWidget& view, const std::string& path, const std::string& csv) {
  const auto write = [&](const QByteArray& bytes) {
    return writeWhole("picture", path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
  };
  auto* source = dynamic_cast<CsvSource*>(&view);
  for (const auto& [ending, make] : {std::pair{".png", &asPng}, {".svg", &asSvg}, {".pdf", &asPdf}}) {
    if (!path.ends_with(ending)) continue;
    if (source) source->prepareExport(true);
    const QByteArray picture = make(view);
    if (source) source->prepareExport(false);
    return write(picture);
  }
  if (!path.ends_with(".csv")) return Error{path + ": the ending says the format; it takes .png, .svg, .pdf or .csv."};
  if (!source && csv.empty())
    return Error{path + ": this view has no table; it can be exported as .png, .svg or .pdf."};
  const std::string table = csv.empty() ? source->asCsv() : csv;
  if (table.empty()) return Error{path + ": there is nothing to write yet."};
  return writeWhole("table", path, table);
}

}  // namespace surefoot
