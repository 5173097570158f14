// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reports/figures.h"

#include <QApplication>

#include "ui/experiment/figures/figure_view.h"
#include "ui/lessons/handout.h"
#include "ui/style/theme.h"

namespace surefoot {

struct FigureDrawer::Application {
  int argc = 1;
  char name[9] = "surefoot";
  char* argv[2] = {name, nullptr};
  QApplication qt{argc, argv};
};

FigureDrawer::FigureDrawer() {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});  // no remarks on the platform
  application_ = std::make_unique<Application>();
  applyAppearance(application_->qt, Appearance::Light);
}
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
