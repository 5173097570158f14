// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of RobotPage that several of its files need.
#pragma once

#include <QDir>

#include "ui/robot/robot_page.h"

namespace surefoot {

/// What a text came to.
struct RobotPage::Checked {
  QString text;
  std::vector<Complaint> complaints;
  std::optional<EnvironmentFile> file;
  EnvironmentInspection inspection;
};

/// "~/robots/hopper.toml".
inline QString shortPath(const QString& path) {
  const QString home = QDir::homePath() + QLatin1Char('/');
  return path.startsWith(home) ? QStringLiteral("~/") + path.mid(home.size()) : path;
}

}  // namespace surefoot
