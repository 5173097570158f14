// SPDX-License-Identifier: GPL-3.0-or-later
// Views as files: PNG (twice the size on the screen), SVG, PDF; and CSV of what some of them show.
#pragma once

#include <QWidget>

#include "core/result.h"

namespace surefoot {

/// A view that can say its numbers.
class CsvSource {
 public:
  virtual ~CsvSource() = default;
  /// Empty: there is nothing to say yet.
  virtual std::string asCsv() const = 0;
  /// A picture of the view is about to be made, or has been: alone it may have to say more.
  virtual void prepareExport(bool exporting) { static_cast<void>(exporting); }
};

/// Writes a view in the format that the file's ending names: .png, .svg, .pdf or .csv.
Status exportView(QWidget& view, const std::string& path);

}  // namespace surefoot
