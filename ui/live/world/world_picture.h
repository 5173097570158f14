// SPDX-License-Identifier: GPL-3.0-or-later
// The world as a picture: a scene with floor and metre scale, the trail of the tip, and the read-outs below. It needs
// no widget, so that films are painted by it, too, on any thread. Lengths are pixels at text size 1.
#pragma once

#include <QPainter>
#include <deque>
#include <vector>

#include "core/environment.h"
#include "core/scene.h"

namespace surefoot {

struct Theme;

class WorldPicture {
 public:
  // What is shown.
  Scene scene;
  std::vector<ReadOut> readOuts;
  double camera = 0.0;  ///< x in the middle of the picture [m]
  double zoom = 1.0;
  QPointF pan{};       ///< [px]
  bool plain = false;  ///< without the numbers where they would leave the body little room

  /// A point more in the trail; after a move of more than `jump` [m] it begins anew. `most` is its length in points.
  void follow(Point tip, std::size_t most = kTrail, double jump = kJump);
  void endTrail() { trail_.clear(); }

  /// Finds how many read-outs with units fit in a row, and the scale at which all is visible, also the words.
  /// `caption`: kept free at the top [px]; `beside`: another picture that is to have the same scale and columns.
  void measure(QSize size, double caption = 0.0, WorldPicture* beside = nullptr);
  bool measured() const { return fit_ > 0; }

  // After measure():
  double pixelsPerMetre() const { return scale_ * zoom; }
  /// The thickness of lines grows with the picture and with the texts.
  double strokes() const;
  Point toMetres(QPointF at) const;
  QPointF toPixel(Point at) const;
  /// The point that the picture is magnified about [px].
  QPointF anchor() const { return {size_.width() / 2.0, size_.height() - band_}; }
  /// All but caption and read-outs.
  QRectF room() const;

  /// The whole picture. `flash`: it falls. The painter's pixels are those of measure().
  void paint(QPainter& painter, const Theme& theme, bool flash) const;
  // Its parts, from back to front; the first two are to be kept within room().
  void paintGround(QPainter& painter, const Theme& theme, bool trail) const;
  void paintBody(QPainter& painter, const Theme& theme, bool flash) const;
  void paintReadOuts(QPainter& painter, const Theme& theme) const;

  static constexpr std::size_t kTrail = 14;  ///< points of the window's trail, at 60 a second
  static constexpr double kJump = 0.05;      ///< [m] from one frame of the window to the next

 private:
  double floorLevel() const { return size_.height() - band_ + pan.y(); }
  void paintFloor(QPainter& painter, const Theme& theme) const;
  void paintTrail(QPainter& painter, const Theme& theme) const;

  std::deque<Point> trail_;
  std::size_t mostTrail_ = kTrail;
  QSize size_;
  double caption_ = 0;                // [px]
  int ownColumns_ = 1, columns_ = 1;  // columns of read-outs: with room, and in use
  double readOutsHeight_ = 0;         // [px]
  double band_ = 0;                   // height of all below the floor while the picture is not moved [px]
  double fit_ = 0, scale_ = 0;        // [px/m], before the zoom: of this picture alone, and of both
  bool hasNumbers_ = true;
};

}  // namespace surefoot
