// SPDX-License-Identifier: GPL-3.0-or-later
// Figures as pictures, if the program was built with its window.
#pragma once

#include "core/lessons/lesson_check.h"
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
  /// A lesson as a PDF to write on; with `told` (lesson_check.h) it has the answers.
  std::string handout(const Registry& registry, const Lesson& lesson, const std::vector<ToldStep>& told);

 private:
  struct Application;
  std::unique_ptr<Application> application_;
};

}  // namespace surefoot
