// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/open_window.h"

#include <QFileInfo>
#include <QLocalSocket>

namespace surefoot {

namespace {

constexpr int kPatience = 1000;       // [ms]
constexpr qint64 kLongest = 1 << 14;  // [bytes] of a path

/// Empty: the system gives this user no folder for sockets.
QString socketName() {
  const QString folder = qEnvironmentVariable("XDG_RUNTIME_DIR");
  return QFileInfo(folder).isDir() ? folder + QStringLiteral("/surefoot-window") : QString();
}

/// To the window that listens, if one does.
bool connectTo(QLocalSocket& socket) {
  const QString name = socketName();
  if (name.isEmpty()) return false;
  socket.connectToServer(name);
  return socket.waitForConnected(kPatience);
}

}  // namespace

bool handToOpenWindow(const QString& path) {
  QLocalSocket socket;
  if (!connectTo(socket)) return false;
  socket.write(path.toUtf8() + '\n');
  while (socket.bytesToWrite() > 0)
    if (!socket.waitForBytesWritten(kPatience)) return false;
  return socket.waitForReadyRead(kPatience) && socket.readAll().startsWith("taken");
}

OpenWindow::OpenWindow(Open open) : open_(std::move(open)) {
  QLocalSocket other;
  if (socketName().isEmpty() || connectTo(other)) return;
  QLocalServer::removeServer(socketName());  // of a window that crashed
  server_ = std::make_unique<QLocalServer>();
  server_->setSocketOptions(QLocalServer::UserAccessOption);
  if (!server_->listen(socketName())) {
    server_.reset();
    return;
  }
  QObject::connect(server_.get(), &QLocalServer::newConnection, server_.get(), [this] { serve(*server_); });
}

/// A path in UTF-8 and a line end; "taken" goes back before the file is opened, so that nobody waits for that.
void OpenWindow::serve(QLocalServer& server) {
  while (QLocalSocket* socket = server.nextPendingConnection()) {
    QObject::connect(socket, &QLocalSocket::disconnected, socket, &QObject::deleteLater);
    const auto read = [this, socket] {
      if (!socket->canReadLine()) return socket->bytesAvailable() > kLongest ? socket->abort() : void();
      const QString path = QString::fromUtf8(socket->readLine(kLongest)).chopped(1);
      socket->write("taken\n");
      socket->disconnectFromServer();
      open_(path);
    };
    QObject::connect(socket, &QLocalSocket::readyRead, socket, read);
    if (socket->canReadLine()) read();
  }
}

}  // namespace surefoot
