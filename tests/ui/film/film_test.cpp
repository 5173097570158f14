// SPDX-License-Identifier: GPL-3.0-or-later
// Films are painted as the window paints, and encoded to the last bit.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/ui/film/filmed.h"
#include "tests/ui/pixels_of.h"
#include "ui/film/film_writer.h"

namespace surefoot {

namespace {

const std::atomic<bool> kGoOn{false};

Status written(const Film& film, const std::string& path, const std::atomic<bool>& interrupted = kGoOn) {
  const auto kind = checkFilm("film", path, film.size, film.frames);
  if (!kind) return kind.error();
  auto file = WholeFile::createNew("film", path);
  if (!file) return file.error();
  return writeFilm("film", film, *kind, std::move(*file), interrupted);
}

/// A program "ffmpeg" that is a script.
struct Pretended : Folder {
  explicit Pretended(const std::string& script) : path((file("") + ":" + qgetenv("PATH").toStdString()).c_str()) {
    std::ofstream(file("ffmpeg")) << "#!/bin/sh\n" << script;
    std::filesystem::permissions(file("ffmpeg"), std::filesystem::perms::owner_all);
  }
  Path path;
};

bool isEmpty(const Folder& folder) {
  return std::filesystem::is_empty(folder.file(""));
}

}  // namespace

TEST(Film, AsWebpHasEveryPictureAsItWasPainted) {
  const Folder folder;
  const Film film = filmOfAPendulum();
  ASSERT_EQ(film.frames, 60);
  const Status s = written(film, folder.file("a.webp"));
  ASSERT_TRUE(s) << s.error().message;
  const Decoded decoded = decodedWebp(folder.file("a.webp"));
  EXPECT_EQ(decoded.loops, 0);
  EXPECT_EQ(decoded.ends.front(), 33);
  EXPECT_EQ(decoded.ends.back(), 2000);
  // Each picture is on the screen at its time; those that are equal to the one before are not there twice.
  std::size_t at = 0, different = 1;
  for (std::int64_t frame = 0; frame < 60; ++frame) {
    if (frame > 0) different += film.picture(frame) != film.picture(frame - 1);
    while (at + 1 < decoded.ends.size() && decoded.ends[at] <= (1000 * frame + 500) / 30) ++at;
    EXPECT_EQ(decoded.pictures[at], film.picture(frame)) << frame;
  }
  EXPECT_EQ(decoded.pictures.size(), different);
  EXPECT_GT(different, 30u);
}

TEST(Film, GivesTheSameBytesTwice) {
  const Folder folder;
  for (const char* name : {"a.webp", "b.webp"}) ASSERT_TRUE(written(filmOfAPendulum(), folder.file(name)));
  EXPECT_EQ(contentOf(folder.file("a.webp")), contentOf(folder.file("b.webp")));
}

TEST(Film, ShowsTheSameInEverySizeAndTheFallInItsColour) {
  const Film small = filmOfAPendulum({160, 90}), large = filmOfAPendulum({961, 541}, 3.0);
  EXPECT_EQ(small.picture(0).size(), QSize(160, 90));
  EXPECT_EQ(large.picture(0).size(), QSize(961, 541));
  std::vector<int> coloured;  // points in the colour of a fall; its marks have it always
  for (int i = 0; i < large.frames; ++i) coloured.push_back(pixelsOf(large.picture(i), lightTheme().fall));
  const int marks = *std::min_element(coloured.begin(), coloured.end());
  std::vector<int> falls;  // pictures of each
  bool before = false;
  for (const int points : coloured) {
    const bool now = points > marks + 500;
    if (now && !before) falls.push_back(0);
    if (now) ++falls.back();
    before = now;
  }
  ASSERT_FALSE(falls.empty()) << testing::PrintToString(coloured);
  EXPECT_LE(coloured[0], marks + 500) << "it stands at first";
  if (before) falls.pop_back();  // cut off where the film ends
  ASSERT_FALSE(falls.empty());
  for (const int pictures : falls) EXPECT_GE(pictures, 6) << "0.2 s each, and more where it falls again";
  EXPECT_EQ(*std::min_element(falls.begin(), falls.end()), 6);
}

TEST(Film, PicturesThatAreEqualStay) {
  const Folder folder;
  const Film film{{64, 64}, 90, [](std::int64_t frame) {
                    QImage image(64, 64, QImage::Format_RGB32);
                    image.fill(frame < 30 ? Qt::red : Qt::blue);
                    return image;
                  }};
  ASSERT_TRUE(written(film, folder.file("a.webp")));
  const Decoded decoded = decodedWebp(folder.file("a.webp"));
  ASSERT_EQ(decoded.pictures.size(), 2u);
  EXPECT_EQ(decoded.ends, (std::vector{1000, 3000}));
}

TEST(Film, OfOtherKindsHasAllPicturesAndTheSameBytesTwice) {
  if (ffmpegProgram().empty()) GTEST_SKIP() << "ffmpeg is not installed";
  const Folder folder;
  const Film film = filmOfAPendulum({160, 90}, 1.0);
  for (const FilmKind& kind : filmKinds()) {
    if (!kind.byFfmpeg()) continue;
    const std::string a = folder.file("a" + kind.ending), b = folder.file("b" + kind.ending);
    const Status s = written(film, a);
    ASSERT_TRUE(s) << s.error().message;
    ASSERT_TRUE(written(film, b));
    EXPECT_EQ(contentOf(a), contentOf(b)) << kind.ending;
    const std::string out = folder.file("out");
    ASSERT_EQ(std::system(("ffprobe -v error -count_frames -select_streams v:0 -show_entries "
                           "stream=width,height,nb_read_frames -of csv=p=0 " +
                           a + " >" + out)
                              .c_str()),
              0);
    EXPECT_EQ(contentOf(out), "160,90,30\n") << kind.ending;
  }
}

TEST(Film, SaysWhatFfmpegComplainedAboutAndLeavesNothing) {
  const Folder folder;
  const Film film = filmOfAPendulum({160, 90}, 0.5);
  for (const char* script : {"echo 'the moon is full' >&2; exit 1\n",                            // at once
                             "head -c 50000 >/dev/null; echo 'the moon is full' >&2; exit 1\n",  // in the middle
                             "cat >/dev/null; echo 'the moon is full' >&2; exit 1\n",            // at the end
                             "cat >/dev/null; echo 'the moon is full' >&2; exit 0\n"}) {
    const Pretended ffmpeg(script);
    const Status s = written(film, folder.file("a.mp4"));
    ASSERT_FALSE(s) << script;
    EXPECT_NE(s.error().message.find("the moon is full"), std::string::npos) << s.error().message;
    EXPECT_TRUE(s.error().message.starts_with("film: ")) << s.error().message;
    EXPECT_EQ(s.error().kind, ErrorKind::File);
    EXPECT_TRUE(isEmpty(folder));
  }
}

TEST(Film, ThatIsInterruptedEndsSoonAndLeavesNothing) {
  const Folder folder;
  const Film film = filmOfAPendulum({160, 90}, 0.5);
  const Pretended ffmpeg("cat >/dev/null; exec sleep 60\n");
  for (const char* name : {"a.webp", "a.mp4"}) {
    std::atomic<bool> interrupted{false};
    std::thread hand([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      interrupted = true;
    });
    Film endless = film;
    if (std::string(name) == "a.webp") {
      endless.frames = 1'000'000;
      endless.picture = [&](std::int64_t frame) { return film.picture(frame % film.frames); };
    }
    const auto kind = checkFilm("film", folder.file(name), film.size, 1);
    ASSERT_TRUE(kind) << kind.error().message;
    auto file = WholeFile::createNew("film", folder.file(name));
    const auto start = std::chrono::steady_clock::now();
    const Status s = writeFilm("film", endless, *kind, std::move(*file), interrupted);
    hand.join();
    ASSERT_FALSE(s) << name;
    EXPECT_EQ(s.error().kind, ErrorKind::Interrupted);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
    EXPECT_TRUE(isEmpty(folder)) << name;
  }
}

TEST(Film, IsRefusedBeforeItIsMade) {
  const auto refused = [](const std::string& path, QSize size, std::int64_t frames,
                          const std::vector<std::string>& words) {
    const auto kind = checkFilm("film", path, size, frames);
    ASSERT_FALSE(kind) << path;
    for (const std::string& word : words)
      EXPECT_NE(kind.error().message.find(word), std::string::npos) << kind.error().message;
  };
  refused("walk.avi", {960, 540}, 1, {"walk.avi", ".webp, .gif, .apng, .mp4 or .webm"});
  refused("walk", {960, 540}, 1, {"walk", ".webp"});
  refused("walk.webp", {1, 1}, 1, {"1x1", "64 to 3840"});
  refused("walk.webp", {100'000, 100'000}, 1, {"100000x100000", "3840"});
  refused("walk.webp", {64, 64}, kMostFilmFrames + 1, {"18,001", "18,000", "600 s"});
  refused("walk.mp4", {961, 540}, 1, {"even", "961x540"});
  for (const char* text : {"", "960", "x", "960x", "axb", "960x540x3", "-960x540", "1e3x540.5"})
    EXPECT_FALSE(parseFilmSize("--size", text)) << text;
  EXPECT_EQ(*parseFilmSize("--size", "64x3840"), QSize(64, 3840));
  const Path none("/nonexistent");
  EXPECT_TRUE(checkFilm("film", "walk.webp", {64, 64}, 1));
  for (const char* path : {"walk.gif", "walk.apng", "walk.mp4", "walk.webm"})
    refused(path, {64, 64}, 1, {"ffmpeg", "not installed", ".webp needs none"});
}

}  // namespace surefoot
