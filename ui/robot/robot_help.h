// SPDX-License-Identifier: GPL-3.0-or-later
// The reference of the robots' format (resources/robots/format.md) by section and key.
#pragma once

#include <QHash>
#include <QString>

namespace surefoot {

class RobotHelp {
 public:
  /// `reference`: the text of that file; empty: nothing is explained.
  explicit RobotHelp(const QString& reference);

  /// What a key means; where there is none of this name, what the section is. `section`: "body"; empty: of the file.
  QString of(const QString& section, const QString& key) const;

 private:
  QHash<QString, QString> keys_, sections_;  // "body.mass", "body"
};

/// Where the caret is: "body" and "mass" in `mass = 2` below [body.trunk]; "shape" and "rod" within a list of shapes.
struct RobotTextPlace {
  QString section, key;
};
RobotTextPlace placeInRobot(const QStringList& linesBefore, const QString& line, int column);

}  // namespace surefoot
