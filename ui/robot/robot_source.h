// SPDX-License-Identifier: GPL-3.0-or-later
// The file behind the text on the Robot page: reads, saves, sees when another editor saves it, and keeps a draft of
// what is not saved, so that no work is lost.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "core/basics/result.h"

namespace surefoot {

class RobotSource final : public QObject {
  Q_OBJECT

 public:
  /// `folder`: where drafts are kept.
  explicit RobotSource(QString folder, QObject* parent = nullptr);

  /// The text of a file, which is watched from now on.
  Result<QString> open(const QString& path);
  /// A text without a file: a copy of a robot that comes with the program.
  void begin(const QString& text);
  Status saveTo(const QString& path, const QString& text);
  const QString& path() const { return path_; }
  const QString& saved() const { return saved_; }
  bool isEdited(const QString& text) const { return text != saved_; }

  /// Writes an edited text beside the drafts, because another takes its place; its path, or nothing.
  QString setAside(const QString& text) const;
  /// Keeps a draft of an edited text, or takes the draft away.
  void keep(const QString& text);
  struct Draft {
    QString path, text;
  };
  std::optional<Draft> draft() const;

 Q_SIGNALS:
  /// Another program has written `text` into the file, in which `before` was.
  void changedOnDisk(const QString& text, const QString& before);

 private:
  void watch();
  void look();
  QString draftFile() const;

  QString folder_, path_, saved_;
  QFileSystemWatcher watcher_;
  QTimer pause_;
};

}  // namespace surefoot
