// SPDX-License-Identifier: GPL-3.0-or-later
// Views as files: PNG (twice the size on the screen), SVG, PDF; and CSV of what some of them show.
#pragma once

#include <QImage>
#include <QWidget>

#include "core/basics/result.h"

class QMenu;

namespace surefoot {

/// A view that can say its numbers.
class CsvSource {
 public:
  virtual ~CsvSource() = default;
  /// Empty: there is nothing to say yet.
  virtual std::string asCsv() const = 0;
  /// A picture of the view is about to be made, or has been: alone it may have to say more.
  virtual void prepareExport(bool exporting) { static_cast<void>(exporting); }
  /// What its context menu offers before everything that all have (view_menu.h).
  virtual void fillMenu(QMenu& menu) { static_cast<void>(menu); }
};

/// Writes a view in the format that the file's ending names: .png, .svg, .pdf or .csv. The table is the view's own, or
/// the one that is given.
Status exportView(QWidget& view, const std::string& path, const std::string& csv = {});

/// A view as it would be written: twice the size on the screen.
QImage pictureOf(QWidget& view);

}  // namespace surefoot
