// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/support/following.h"

#include <QFileInfo>
#include <algorithm>

#include "core/files/file_stamp.h"

namespace surefoot {

namespace {
constexpr int kEvery = 1000;        // [ms]
constexpr int kShareOfReading = 3;  // after a reading there is a rest, so many times as long
constexpr int kTryAgain = 10'000;   // [ms] what could not be read is tried again without having changed
}  // namespace

struct Following::Seen {
  std::string stamp;
  std::int64_t modified = 0;
  bool there = false, written = false;
  std::optional<Result<Take>> read;
  qint64 took = 0;  // [ms]
};

Following::Following(std::string path, Look look, QObject* parent)
    : QObject(parent),
      path_(std::move(path)),
      look_(std::move(look)) {
  connect(&looking_, &Background::failed, this, [this](const QString& sentence) {
    refused_ = sentence;
    rest_.start();
    restFor_ = kTryAgain;
  });
  connect(&timer_, &QTimer::timeout, this, &Following::tick);
  timer_.start(kEvery);
  QTimer::singleShot(0, this, &Following::tick);
}

void Following::end(std::unique_ptr<Following> following, QObject* keeper) {
  if (!following) return;
  Following* last = following.release();
  last->setParent(keeper);
  last->timer_.stop();
  last->looking_.cancel();
  if (last->looking_.busy())
    connect(&last->looking_, &Background::busyChanged, last, &QObject::deleteLater);
  else
    last->deleteLater();  // it may be the one who calls
}

QString Following::name() const {
  return QFileInfo(QString::fromStdString(path_)).fileName();
}

QString Following::trouble() const {
  const QString before = isShown() ? tr(" What it held before is shown.") : QString();
  if (!there_) return isShown() ? tr("It is gone.") + before : tr("It is not there yet; this page waits for it.");
  return refused_.isEmpty() ? QString() : refused_ + before;
}

QString Following::lastChange() const {
  const bool today = modified_.date() == QDate::currentDate();
  return modified_.toString(today ? QStringLiteral("HH:mm:ss") : QStringLiteral("yyyy-MM-dd HH:mm"));
}

void Following::tick() {
  if (looking_.busy()) return;
  const bool rested = !rest_.isValid() || rest_.elapsed() >= restFor_;
  const bool again = !refused_.isEmpty() && rest_.isValid() && rest_.elapsed() >= kTryAgain;
  auto seen = std::make_shared<Seen>();
  looking_.start(
      [seen, path = path_, look = look_, before = read_, rested, again](const std::atomic<bool>& interrupted) {
        seen->written = look.isWritten && look.isWritten();  // asked first: a writer that is gone has written all
        const FileStamp file = stampOf(path);
        seen->there = file.bytes > 0;
        seen->stamp = file.identity, seen->modified = file.modified;
        for (const std::string& ending : look.beside) {
          const FileStamp other = stampOf(path + ending);
          seen->stamp += ' ' + other.identity;
          seen->modified = std::max(seen->modified, other.modified);
        }
        if (!seen->there || !rested || (seen->stamp == before && !again)) return;
        QElapsedTimer clock;
        clock.start();
        seen->read = look.read(interrupted);
        seen->took = clock.elapsed();
      },
      [this, seen] { take(*seen); });
}

void Following::take(Seen& seen) {
  there_ = seen.there;
  written_ = seen.written;
  if (seen.read) {
    read_ = seen.stamp;
    rest_.start();
    restFor_ = kShareOfReading * seen.took;
    if (*seen.read) {
      refused_.clear();
      modified_ = QDateTime::fromSecsSinceEpoch(seen.modified);
      (**seen.read)();
    } else {
      refused_ = QString::fromStdString(seen.read->error().message);
      if (const QString prefix = QString::fromStdString(path_) + ": "; refused_.startsWith(prefix)) {
        refused_.remove(0, prefix.size());
        refused_[0] = refused_[0].toUpper();
      }
    }
  }
  Q_EMIT looked();
}

}  // namespace surefoot

#include "moc_following.cpp"
