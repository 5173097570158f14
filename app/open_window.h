// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot window --reuse-window FILE`: hands the file to the window that is there. The first window listens on a
// socket in the user's runtime folder, which nobody else can enter; without such a folder none does. Qt's thread.
#pragma once

#include <QLocalServer>
#include <QString>
#include <functional>
#include <memory>

namespace surefoot {

/// Whether a window took the file; an empty path only brings it to the front.
bool handToOpenWindow(const QString& path);

/// Hears what later starts hand over, as long as it lives.
class OpenWindow {
 public:
  using Open = std::function<void(const QString& path)>;
  explicit OpenWindow(Open open);

 private:
  void serve(QLocalServer& server);

  Open open_;
  std::unique_ptr<QLocalServer> server_;  // null: another window listens, or there is no place for a socket
};

}  // namespace surefoot
