// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/figures/condition_name.h"

#include <QObject>
#include <QRegularExpression>
#include <algorithm>

namespace surefoot {

QString shownName(const std::string& name) {
  // A hyphen behind a letter or a digit joins words or numbers: "tile-coder", "4.4-4.9".
  static const QRegularExpression minus(QStringLiteral("(^|[\\s(\\[,=±])-(?=[0-9.])"));
  return QString::fromStdString(name).replace(minus, QStringLiteral("\\1−"));
}

std::string groupOf(const std::string& name) {
  const auto colon = name.find(": ");
  return colon == std::string::npos ? "" : name.substr(0, colon);
}

QString groupTitle(const std::string& group) {
  static const QRegularExpression before(QStringLiteral("^pre\\(([^,()]+)(?:, *([^,()]+))?\\)(.*)$"));
  const QString shown = shownName(group);
  const auto match = before.match(shown);
  if (!match.hasMatch()) return shown;
  QString title = QObject::tr("pre-learned on scenario %1").arg(match.captured(1));
  if (!match.captured(2).isEmpty()) title += QObject::tr(" to %1").arg(match.captured(2));
  return title + match.captured(3);
}

QString nameInGroup(const std::string& name) {
  const auto colon = name.find(": ");
  return shownName(colon == std::string::npos ? name : name.substr(colon + 2));
}

namespace {

/// "TRL " of "TRL −50"; empty: it does not end with a number.
QString familyOf(const QString& label) {
  static const QRegularExpression number(QStringLiteral("^(.*\\S) (−?[0-9.]+)$"));
  const auto match = number.match(label);
  return match.hasMatch() ? match.captured(1) : QString();
}

}  // namespace

NameGroups groupNames(const std::vector<std::string>& names) {
  NameGroups all;
  std::vector<std::string> groups;
  for (const std::string& name : names)
    if (std::find(groups.begin(), groups.end(), groupOf(name)) == groups.end()) groups.push_back(groupOf(name));
  for (const std::string& group : groups) {
    const std::size_t first = all.order.size();
    for (std::size_t i = 0; i < names.size(); ++i)
      if (groupOf(names[i]) == group) {
        all.order.push_back(i);
        all.labels.push_back(nameInGroup(names[i]));
      }
    if (!group.empty()) all.groups.push_back({groupTitle(group), first, all.order.size() - 1});
    for (std::size_t at = first; at < all.order.size();) {
      const QString family = familyOf(all.labels[at]);
      std::size_t end = at + 1;
      while (!family.isEmpty() && end < all.order.size() && familyOf(all.labels[end]) == family) ++end;
      if (end > at + 1) {
        all.families.push_back({family, at, end - 1});
        for (std::size_t k = at; k < end; ++k) all.labels[k] = all.labels[k].mid(family.size() + 1);
      }
      at = end;
    }
  }
  return all;
}

}  // namespace surefoot
