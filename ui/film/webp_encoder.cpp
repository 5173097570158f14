// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <cmath>

#include "core/signals/footage.h"
#include "ui/film/film_encoder.h"
#include "ui/film/film_writer.h"

namespace surefoot {

namespace {

class WebpEncoder final : public FilmEncoder {
 public:
  explicit WebpEncoder(const FilmJob& job) : name_(job.name) {
    WebPAnimEncoderOptions options;
    if (!WebPAnimEncoderOptionsInit(&options)) return;
    options.kmax = 0;  // one key frame, the first
    // Of 0 … 9. Measured on the pendulum at 960 × 540: 8 kB and 12 ms a picture; level 1 gives 9.5 kB, levels above 3
    // and `minimize_size` not a byte less in up to three times the time.
    constexpr int kLevel = 3;
    if (!WebPConfigInit(&config_) || !WebPConfigLosslessPreset(&config_, kLevel)) return;
    encoder_.reset(WebPAnimEncoderNew(job.size.width(), job.size.height(), &options));
  }
  bool made() const { return encoder_ != nullptr; }

  Status add(const QImage& picture) override {
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
    WebPPicture frame;
    if (!WebPPictureInit(&frame)) return failed();
    frame.use_argb = 1;
    frame.width = rgb.width();
    frame.height = rgb.height();
    const bool added = WebPPictureImportRGB(&frame, rgb.constBits(), static_cast<int>(rgb.bytesPerLine())) &&
                       WebPAnimEncoderAdd(encoder_.get(), &frame, time(frames_++), &config_);
    WebPPictureFree(&frame);
    return added ? Status(Done{}) : failed();
  }

  Status finish(WholeFile& file) override {
    WebPData data;
    WebPDataInit(&data);
    if (!WebPAnimEncoderAdd(encoder_.get(), nullptr, time(frames_), nullptr) ||
        !WebPAnimEncoderAssemble(encoder_.get(), &data))
      return failed();
    const Status written = file.append({reinterpret_cast<const char*>(data.bytes), data.size});
    WebPDataClear(&data);
    return written;
  }

 private:
  struct Delete {
    void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
  };

  /// When a picture begins [ms].
  static int time(std::int64_t frame) {
    return static_cast<int>(std::lround(1000.0 * static_cast<double>(frame) / kFilmRate));
  }
  Status failed() const {
    return Error{fmt::format("{}: the film cannot be encoded: {}.", name_, WebPAnimEncoderGetError(encoder_.get())),
                 ErrorKind::File};
  }

  std::string name_;
  WebPConfig config_{};
  std::unique_ptr<WebPAnimEncoder, Delete> encoder_;
  std::int64_t frames_ = 0;
};

}  // namespace

Result<std::unique_ptr<FilmEncoder>> makeWebpEncoder(const FilmJob& job) {
  auto encoder = std::make_unique<WebpEncoder>(job);
  if (!encoder->made()) return Error{job.name + ": libwebp makes no film of this size.", ErrorKind::File};
  return std::unique_ptr<FilmEncoder>(std::move(encoder));
}

std::string webpVersion() {
  const int packed = WebPGetEncoderVersion();  // a byte each
  return fmt::format("{}.{}.{}", packed >> 16, packed >> 8 & 0xFF, packed & 0xFF);
}

}  // namespace surefoot
