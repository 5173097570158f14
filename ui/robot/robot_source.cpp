// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robot/robot_source.h"

#include <QDir>
#include <QFileInfo>

#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

RobotSource::RobotSource(QString folder, QObject* parent) : QObject(parent), folder_(std::move(folder)) {
  constexpr int kPause = 150;  // [ms]: editors save by renaming
  pause_.setSingleShot(true);
  pause_.setInterval(kPause);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, &pause_, qOverload<>(&QTimer::start));
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, &pause_, qOverload<>(&QTimer::start));
  connect(&pause_, &QTimer::timeout, this, &RobotSource::look);
}

Result<QString> RobotSource::open(const QString& path) {
  const auto text = readText(path.toStdString());
  if (!text) return text.error();
  path_ = path;
  saved_ = toText(*text);
  watch();
  return saved_;
}

void RobotSource::begin(const QString& text) {
  path_.clear();
  saved_ = text;
  watch();
}

void RobotSource::watch() {
  if (const QStringList all = watcher_.files() + watcher_.directories(); !all.isEmpty()) watcher_.removePaths(all);
  if (path_.isEmpty()) return;
  watcher_.addPath(path_);
  watcher_.addPath(QFileInfo(path_).absolutePath());
}

void RobotSource::look() {
  if (path_.isEmpty()) return;
  if (!watcher_.files().contains(path_) && QFileInfo::exists(path_)) watcher_.addPath(path_);
  const auto text = readText(path_.toStdString());
  if (!text || toText(*text) == saved_) return;
  const QString before = std::exchange(saved_, toText(*text));
  Q_EMIT changedOnDisk(saved_, before);
}

Status RobotSource::saveTo(const QString& path, const QString& text) {
  if (const Status s = writeWhole("robot", path.toStdString(), text.toStdString()); !s) return s;
  path_ = path;
  saved_ = text;
  watch();
  keep(text);
  return Done{};
}

QString RobotSource::setAside(const QString& text) const {
  if (!isEdited(text) || text.isEmpty() || !QDir().mkpath(folder_)) return {};
  for (int i = 1; i < 1000; ++i) {
    const QString path = QStringLiteral("%1/robot-unsaved-%2.toml").arg(folder_).arg(i);
    if (QFile::exists(path)) continue;
    return writeWhole("robot", path.toStdString(), text.toStdString()) ? path : QString();
  }
  return {};
}

QString RobotSource::draftFile() const {
  return folder_ + QStringLiteral("/robot-draft.toml");
}

// The first line of a draft is a comment that says where it belongs.
void RobotSource::keep(const QString& text) {
  if (!isEdited(text)) {
    QFile::remove(draftFile());
    return;
  }
  QDir().mkpath(folder_);
  const std::string draft = "# surefoot draft of: " + path_.toStdString() + "\n" + text.toStdString();
  static_cast<void>(static_cast<bool>(writeWhole("draft", draftFile().toStdString(), draft)));
}

std::optional<RobotSource::Draft> RobotSource::draft() const {
  const auto text = readText(draftFile().toStdString());
  const QString head = QStringLiteral("# surefoot draft of: ");
  if (!text || !toText(*text).startsWith(head)) return std::nullopt;
  const QString all = toText(*text);
  const auto end = all.indexOf(u'\n');
  return Draft{all.mid(head.size(), end - head.size()), all.mid(end + 1)};
}

}  // namespace surefoot

#include "moc_robot_source.cpp"
