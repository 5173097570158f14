// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/running/beginning.h"

#include <QObject>
#include <filesystem>

#include "core/basics/typed_json.h"

namespace surefoot {

std::string beginningOf(const Configuration& began) {
  if (!began.start && began.beganWith.is_null()) return "";
  const Json& with = began.beganWith;
  if (with.is_object() && with.contains("learned") && with["learned"].is_object() &&
      with["learned"].value("carried_over", Json(false)) == true)
    return QObject::tr("carried over").toStdString();
  const std::string file = began.start ? began.start->name : textIn(with, "file");
  if (const std::string name = std::filesystem::path(file).filename().string(); !name.empty())
    return QObject::tr("with %1").arg(QString::fromStdString(name)).toStdString();
  std::string scenario;
  if (began.start && began.start->about.contains("configuration"))
    scenario = textIn(began.start->about["configuration"], "scenario");
  if (scenario.empty()) return QObject::tr("pre-learned").toStdString();
  return QObject::tr("pre-learned (scenario %1)").arg(QString::fromStdString(scenario)).toStdString();
}

}  // namespace surefoot
