// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/suggested_command.h"

#include <fmt/format.h>

#include <cmath>

#include "core/text/shell_text.h"

namespace surefoot {

namespace {

/// The limit of a new life.
std::string usualLength(const RunningLife& life) {
  return life.task().stepTime ? "--minutes 9" : "--episodes 900";
}

/// A limit a little beyond the life's length in the file: the limits of --resume count from its beginning.
std::string somewhatLonger(const RunningLife& life, const LifeProgress& written) {
  const auto& stepTime = life.task().stepTime;
  std::string length;
  if (stepTime)
    length = fmt::format("--minutes {:.0f}", std::ceil(static_cast<double>(written.steps) * *stepTime / 60) + 10);
  if (!stepTime || life.configuration().episodes)
    length += fmt::format("{}--episodes {}", stepTime ? " " : "", written.episodes + 1000);
  return length;
}

}  // namespace

QString suggestedCommand(SavedAs what, const QString& path, const RunningLife& life, const LifeProgress& written) {
  const std::string file = shellQuoted(path.toStdString());
  if (what == SavedAs::PolicyInC)
    return QStringLiteral("gcc -std=c99 -DPOLICY_SELF_TEST %1 && ./a.out").arg(QString::fromStdString(file));
  const std::string command = what == SavedAs::Journal ? "surefoot replay " + file
                              : what == SavedAs::QFunction
                                  ? fmt::format("surefoot train --load {} {}", file, usualLength(life))
                                  : fmt::format("surefoot train --resume {} {}", file, somewhatLonger(life, written));
  return QString::fromStdString(command);
}

}  // namespace surefoot
