// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robot/robot_help.h"

#include <QRegularExpression>

namespace surefoot {

namespace {

/// "body" of "[body.trunk]", "state" of "[[state]]"; "" of any other line.
QString headOf(const QString& line) {
  static const QRegularExpression kHead(QStringLiteral("^\\s*\\[+\\s*([a-z]+)"));
  return kHead.match(line).captured(1);
}

}  // namespace

RobotHelp::RobotHelp(const QString& reference) {
  static const QRegularExpression kKey(QStringLiteral("^- `(\\w+)`: (.*)$")),
      kHead(QStringLiteral("^## \\[*([a-z]+)[.\\]\\w]*(?: and \\[([a-z]+))?"));
  QStringList heads;
  QString* last = nullptr;
  for (const QString& line : reference.split(u'\n')) {
    if (line.startsWith(QStringLiteral("# "))) continue;
    if (line.startsWith(QStringLiteral("## "))) {
      const auto head = kHead.match(line);
      heads = line == QStringLiteral("## The file") ? QStringList{QString()} : QStringList{head.captured(1)};
      if (!head.captured(2).isEmpty()) heads << head.captured(2);
      last = nullptr;
    } else if (const auto key = kKey.match(line); key.hasMatch()) {
      for (const QString& head : std::as_const(heads))
        last = &(keys_[head + u'.' + key.captured(1)] = QStringLiteral("%1: %2").arg(key.captured(1), key.captured(2)));
    } else if (!line.isEmpty() && last) {
      *last += u' ' + line.trimmed();
    } else if (!line.isEmpty()) {
      for (const QString& head : std::as_const(heads)) sections_[head] += (sections_[head].isEmpty() ? "" : " ") + line;
    }
  }
}

QString RobotHelp::of(const QString& section, const QString& key) const {
  return keys_.value(section + u'.' + key, sections_.value(section));
}

RobotTextPlace placeInRobot(const QStringList& linesBefore, const QString& line, int column) {
  static const QRegularExpression kKey(QStringLiteral("(\\w+)\\s*="));
  if (const QString head = headOf(line); !head.isEmpty()) return {head, {}};
  RobotTextPlace place;
  for (auto before = linesBefore.rbegin(); before != linesBefore.rend() && place.section.isEmpty(); ++before)
    place.section = headOf(*before);
  bool inBraces = false;
  for (auto keys = kKey.globalMatch(line); keys.hasNext();) {
    const auto key = keys.next();
    if (key.capturedStart() > column && !place.key.isEmpty()) break;
    place.key = key.captured(1);
    inBraces = line.left(key.capturedStart()).contains(u'{');
  }
  if (inBraces && place.section == QStringLiteral("body")) place.section = QStringLiteral("shape");
  return place;
}

}  // namespace surefoot
