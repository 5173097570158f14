// SPDX-License-Identifier: GPL-3.0-or-later
// Figures as pictures, if the program was built with its window.
#pragma once

#include "core/recipes/figure.h"

namespace surefoot {

/// Draws without a display. One for the whole program.
class FigureDrawer {
 public:
  FigureDrawer();
  ~FigureDrawer();
  /// False: this program was built without Qt.
  static bool canDraw();
  /// Writes FOLDER/NAME.png and .pdf.
  Status draw(const Figure& figure, const std::string& folder);

 private:
  struct Application;
  std::unique_ptr<Application> application_;
};

}  // namespace surefoot
