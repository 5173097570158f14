// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <QProcess>

#include "core/signals/footage.h"
#include "core/text/text.h"
#include "ui/film/film_encoder.h"

namespace surefoot {

namespace {

constexpr int kPatience = 50;                 // [ms] between two looks at `interrupted`
constexpr qint64 kMostWaiting = 16 << 20;     // [bytes] that the process has not taken yet
constexpr qsizetype kMostRemarks = 64 << 10;  // [bytes] of what it says that are kept

class FfmpegEncoder final : public FilmEncoder {
 public:
  FfmpegEncoder(const FilmJob& job, const WholeFile& file) : job_(job) {
    QStringList arguments = {"-hide_banner", "-loglevel", "error",         "-nostdin", "-y",
                             "-f",           "rawvideo",  "-pixel_format", "rgb24",    "-video_size"};
    arguments << QStringLiteral("%1x%2").arg(job.size.width()).arg(job.size.height());
    arguments << "-framerate" << QString::number(kFilmRate) << "-i"
              << "pipe:0"
              << "-an";
    for (const std::string& argument : job.kind.arguments) arguments << QString::fromStdString(argument);
    // Nothing that differs from run to run: no dates, no names of versions.
    arguments << "-fflags"
              << "+bitexact"
              << "-flags:v"
              << "+bitexact"
              << "-map_metadata"
              << "-1";
    arguments << "file:" + QString::fromStdString(file.openName());
    process_.setStandardOutputFile(QProcess::nullDevice());
    // In a group of its own: Ctrl-C at the terminal is ours to answer.
    process_.setChildProcessModifier([] { static_cast<void>(setpgid(0, 0)); });
    process_.start(QString::fromStdString(ffmpegProgram()), arguments, QIODevice::ReadWrite);
  }
  ~FfmpegEncoder() override {
    if (process_.state() == QProcess::NotRunning) return;
    process_.kill();
    process_.waitForFinished();
  }
  bool started() { return process_.waitForStarted(); }

  Status add(const QImage& picture) override {
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
    for (int y = 0; y < rgb.height(); ++y)  // without the bytes that fill a line of the image
      process_.write(reinterpret_cast<const char*>(rgb.constScanLine(y)), qint64{3} * rgb.width());
    while (process_.bytesToWrite() > kMostWaiting && !job_.interrupted)
      if (!wait()) return failed();
    return process_.state() == QProcess::Running ? Status(Done{}) : failed();
  }

  Status finish(WholeFile&) override {
    while (process_.bytesToWrite() > 0 && !job_.interrupted)
      if (!wait()) return failed();
    process_.closeWriteChannel();
    while (process_.state() != QProcess::NotRunning && !job_.interrupted)
      if (!process_.waitForFinished(kPatience)) listen();
    listen();
    if (process_.state() != QProcess::NotRunning) return Done{};  // interrupted: it is killed
    const bool good = process_.exitStatus() == QProcess::NormalExit && process_.exitCode() == 0 && remarks_.isEmpty();
    return good ? Status(Done{}) : failed();
  }

 private:
  /// Until it has taken something, or a moment has passed; false: it has ended.
  bool wait() {
    process_.waitForBytesWritten(kPatience);
    listen();
    return process_.state() == QProcess::Running;
  }
  void listen() {
    remarks_ += process_.readAllStandardError();
    if (remarks_.size() > kMostRemarks) remarks_.truncate(kMostRemarks);
  }
  /// With the first thing that it complained about.
  Status failed() {
    process_.closeWriteChannel();
    process_.waitForFinished();
    listen();
    const std::string said = remarks_.trimmed().split('\n').front().trimmed().toStdString();
    return Error{
        fmt::format("{}: ffmpeg has not made the film{}{}.", job_.name, said.empty() ? "" : ": ", shortened(said)),
        ErrorKind::File};
  }

  FilmJob job_;
  QProcess process_;
  QByteArray remarks_;
};

}  // namespace

Result<std::unique_ptr<FilmEncoder>> makeFfmpegEncoder(const FilmJob& job, const WholeFile& file) {
  auto encoder = std::make_unique<FfmpegEncoder>(job, file);
  if (!encoder->started()) return Error{job.name + ": the program ffmpeg cannot be started.", ErrorKind::File};
  return std::unique_ptr<FilmEncoder>(std::move(encoder));
}

}  // namespace surefoot
