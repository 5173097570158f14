// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reports/figures.h"

#include "app/headless_qt.h"
#include "ui/experiment/figures/figure_view.h"
#include "ui/lessons/handout.h"

namespace surefoot {

struct FigureDrawer::Application : HeadlessQt {};

FigureDrawer::FigureDrawer() : application_(std::make_unique<Application>()) {}
FigureDrawer::~FigureDrawer() = default;

bool FigureDrawer::canDraw() {
  return true;
}

Status FigureDrawer::draw(const Figure& figure, const std::string& folder) {
  return FigureView(figure).save(folder + "/" + figure.name);
}

std::string FigureDrawer::handout(const Registry& registry, const Lesson& lesson, const std::vector<ToldStep>& told) {
  return handoutOf(registry, lesson, told).toStdString();
}

}  // namespace surefoot
