// SPDX-License-Identifier: GPL-3.0-or-later
// In place of figures.cpp where the program is built without Qt.
#include "app/reports/figures.h"

namespace surefoot {

struct FigureDrawer::Application {};
FigureDrawer::FigureDrawer() = default;
FigureDrawer::~FigureDrawer() = default;

bool FigureDrawer::canDraw() {
  return false;
}

Status FigureDrawer::draw(const Figure&, const std::string&) {
  return Done{};
}

std::string FigureDrawer::handout(const Registry&, const Lesson&, const std::vector<ToldStep>&) {
  return {};
}

}  // namespace surefoot
