// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library/scene_raster.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>

namespace surefoot {

namespace {

constexpr std::uint32_t kPaper = 0xFAFAF8, kGround = 0xC4C8CE;

std::uint32_t colourOf(Ink ink) {
  switch (ink) {
    case Ink::Solid:
    case Ink::Body:
      return 0x1F2328;
    case Ink::Far:
      return 0x8C939D;
    case Ink::Outline:
      return 0xC4C8CE;
    case Ink::Quiet:
      return 0x5F6671;
    case Ink::Hairline:
      return 0xE3E5E8;
    case Ink::Fall:
      break;
  }
  return 0xD55E00;
}

std::uint32_t colourOf(Fill fill) {
  switch (fill) {
    case Fill::Panel:
    case Fill::None:
      return 0xFFFFFF;
    case Fill::Wash:
      return 0xF1F3F5;
    case Fill::Solid:
      return 0x1F2328;
    case Fill::Far:
      return 0x8C939D;
    case Fill::Fall:
      break;
  }
  return 0xF5DECB;
}

class Painter {
 public:
  Painter(cairo_t* cairo, const Scene& scene, int width, int height) : c_(cairo) {
    constexpr double kAir = 0.82, kUsual = 400;  // share of the picture; [px], where lines are as thick as they say
    const double tall = std::max(scene.height, 1e-6);
    scale_ = kAir * height / tall;
    if (scene.width > 0) scale_ = std::min(scale_, kAir * width / scene.width);
    strokes_ = std::max(height / kUsual, 0.5);
    left_ = width / 2.0 - scene.focus.x * scale_;
    floor_ = height * (0.5 + kAir / 2);
    floor_ = std::min(floor_, height / 2.0 + tall * scale_ / 2);
    cairo_set_line_cap(c_, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(c_, CAIRO_LINE_JOIN_ROUND);
    paper(width, height, scene.metres);
  }

  void operator()(const Polyline& line) const {
    path(line.points);
    const double dash[] = {4 * line.width * strokes_, 4 * line.width * strokes_};
    cairo_set_dash(c_, dash, line.dashed ? 2 : 0, 0);
    stroke(line.ink, line.width);
    cairo_set_dash(c_, nullptr, 0, 0);
  }
  void operator()(const Polygon& polygon) const {
    path(polygon.points);
    cairo_close_path(c_);
    fillAndStroke(polygon.fill, polygon.ink, polygon.width);
  }
  void operator()(const Disc& disc) const {
    cairo_new_path(c_);
    cairo_arc(c_, x(disc.centre), y(disc.centre), disc.radius * scale_, 0, 2 * std::numbers::pi);
    fillAndStroke(disc.fill, disc.ink, disc.width);
  }
  void operator()(const Arrow& arrow) const {
    const double side = arrow.length > 0 ? 1 : -1,
                 head = std::clamp(Arrow::kHead * scale_, 8 * strokes_, 12 * strokes_);
    const double tip = x(arrow.from) + arrow.length * scale_ + head * side, at = y(arrow.from);
    colour(colourOf(Ink::Solid));
    cairo_new_path(c_);
    cairo_move_to(c_, x(arrow.from), at);
    cairo_line_to(c_, tip - 0.7 * head * side, at);
    cairo_set_line_width(c_, 0.25 * head);
    cairo_stroke(c_);
    cairo_move_to(c_, tip, at);
    cairo_line_to(c_, tip - head * side, at - 0.46 * head);
    cairo_line_to(c_, tip - head * side, at + 0.46 * head);
    cairo_close_path(c_);
    cairo_fill(c_);
  }
  void operator()(const Label&) const {}  // words are for people, and no font need be there

 private:
  double x(Point p) const { return left_ + p.x * scale_; }
  double y(Point p) const { return floor_ - p.y * scale_; }

  void colour(std::uint32_t rgb) const {
    const auto part = [rgb](int shift) { return ((rgb >> shift) & 0xFF) / 255.0; };
    cairo_set_source_rgb(c_, part(16), part(8), part(0));
  }
  void path(const std::vector<Point>& points) const {
    cairo_new_path(c_);
    for (const Point& p : points) cairo_line_to(c_, x(p), y(p));
  }
  void stroke(Ink ink, double width) const {
    colour(colourOf(ink));
    cairo_set_line_width(c_, width * strokes_);
    if (width > 0)
      cairo_stroke(c_);
    else
      cairo_new_path(c_);
  }
  void fillAndStroke(Fill fill, Ink ink, double width) const {
    colour(colourOf(fill));
    if (fill != Fill::None) cairo_fill_preserve(c_);
    stroke(ink, width);
  }
  /// Nothing yet but the floor, and a mark every metre, which moves as the world goes by.
  void paper(int width, int height, bool floor) const {
    colour(kPaper);
    cairo_paint(c_);
    if (!floor) return;
    colour(kGround);
    cairo_set_line_width(c_, strokes_);
    cairo_move_to(c_, 0, floor_);
    cairo_line_to(c_, width, floor_);
    const double first = std::ceil(-left_ / scale_), last = (width - left_) / scale_;
    if (scale_ > 4 * strokes_)
      for (double metre = first; metre <= last; ++metre) {
        cairo_move_to(c_, left_ + metre * scale_, floor_);
        cairo_line_to(c_, left_ + metre * scale_, std::min<double>(floor_ + 6 * strokes_, height));
      }
    cairo_stroke(c_);
  }

  cairo_t* c_;
  double scale_ = 1, strokes_ = 1, left_ = 0, floor_ = 0;
};

}  // namespace

Status paintInto(const Scene& scene, int width, int height, std::uint8_t* rgb) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), &cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface.get()), &cairo_destroy);
  if (cairo_status(cairo.get()) != CAIRO_STATUS_SUCCESS)
    return Error{"the picture: there is not enough memory for it."};
  const Painter painter(cairo.get(), scene, width, height);
  for (const Shape& shape : scene.shapes) std::visit(painter, shape);
  cairo_surface_flush(surface.get());
  const unsigned char* bytes = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row)
    for (std::size_t column = 0; column < static_cast<std::size_t>(width); ++column) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, bytes + row * stride + 4 * column, sizeof pixel);
      for (const int shift : {16, 8, 0}) *rgb++ = static_cast<std::uint8_t>(pixel >> shift);
    }
  return Done{};
}

}  // namespace surefoot
