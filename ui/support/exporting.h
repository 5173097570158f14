// SPDX-License-Identifier: GPL-3.0-or-later
// Views as files: PNG (twice the size on the screen), SVG, PDF; and CSV of the numbers that some of them show.
#pragma once

#include <QImage>
#include <QWidget>

#include "core/basics/result.h"

class QMenu;

namespace surefoot {

/// A view that can give its numbers.
class CsvSource {
 public:
  virtual ~CsvSource() = default;
  /// The numbers as CSV; empty: there are none yet.
  virtual std::string asCsv() const = 0;
  /// A picture of the view is about to be made (true), or was made (false); the view may add a title, for example.
  virtual void prepareExport(bool exporting) { static_cast<void>(exporting); }
  /// Adds the view's own entries at the top of its context menu (view_menu.h).
  virtual void fillMenu(QMenu& menu) { static_cast<void>(menu); }
};

/// Writes a view in the format that the file's ending names: .png, .svg, .pdf or .csv. The table is the view's own, or
/// the one that is given.
Status exportView(QWidget& view, const std::string& path, const std::string& csv = {});

/// A view as it would be written: twice the size on the screen.
QImage pictureOf(QWidget& view);

}  // namespace surefoot
