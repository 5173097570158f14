// SPDX-License-Identifier: GPL-3.0-or-later
// A film to write, and animated WebP read back by libwebp's own decoder.
#pragma once

#include <gtest/gtest.h>
#include <webp/demux.h>

#include <QImage>
#include <vector>

#include "core/signals/footage.h"
#include "tests/app/program.h"
#include "tests/core/experiment/test_setup.h"
#include "ui/film/world_film.h"
#include "ui/style/theme.h"

namespace surefoot {

struct Decoded {
  std::vector<QImage> pictures;
  std::vector<int> ends;  ///< [ms], of each picture
  int loops = -1;         ///< 0: for ever
};

inline Decoded decodedWebp(const std::string& path) {
  Decoded decoded;
  const std::string bytes = contentOf(path);
  const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
  WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, nullptr);
  if (!decoder) return decoded;
  WebPAnimInfo info;
  WebPAnimDecoderGetInfo(decoder, &info);
  decoded.loops = static_cast<int>(info.loop_count);
  while (WebPAnimDecoderHasMoreFrames(decoder)) {
    std::uint8_t* rgba = nullptr;
    int end = 0;
    if (!WebPAnimDecoderGetNext(decoder, &rgba, &end)) break;
    const QImage picture(rgba, static_cast<int>(info.canvas_width), static_cast<int>(info.canvas_height),
                         QImage::Format_RGBA8888);
    decoded.pictures.push_back(picture.convertToFormat(QImage::Format_RGB32));
    decoded.ends.push_back(end);
  }
  WebPAnimDecoderDelete(decoder);
  return decoded;
}

/// A pendulum that is left alone until it falls, and again.
inline Film filmOfAPendulum(QSize size = {320, 180}, double seconds = 2.0) {
  const Registry registry = fullRegistry();
  auto environment = makeEnvironment(registry, pendulumConfiguration(registry, "trl", {}));
  EXPECT_TRUE(environment);
  Random random(1);
  FootageTaker taker;
  const double step = *(*environment)->task().stepTime;
  const auto middle = static_cast<Action>((*environment)->task().actions.size() / 2);  // no torque
  double time = 0;
  for (bool ended = true; time < seconds; time += step) {
    if (ended) {
      (*environment)->reset(random);
      taker.look(**environment, time, false);
    }
    const Outcome outcome = (*environment)->step(middle);
    ended = outcome.ending != Ending::None;
    taker.look(**environment, time + step, outcome.event == Event::Fall);
  }
  Footage footage = cut(taker.finish(seconds), 0, seconds);  // also where it ends with a fall
  return worldFilm(std::move(*environment), std::move(footage), size, lightTheme());
}

/// The programs that are found, for a while.
class Path {
 public:
  explicit Path(const QByteArray& path) : before_(qgetenv("PATH")) { qputenv("PATH", path); }
  ~Path() { qputenv("PATH", before_); }

 private:
  QByteArray before_;
};

}  // namespace surefoot
