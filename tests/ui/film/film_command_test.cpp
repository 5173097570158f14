// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot rollout --film`, without a display.
#include "tests/ui/film/filmed.h"
#include "ui/film/film_kind.h"

namespace surefoot {

namespace {

/// A folder with the Q-function of a short life.
struct Learner : Folder {
  explicit Learner(const std::string& arguments = "--episodes 100") {
    run("train " + arguments + " --save " + file("q.safetensors"));
  }
  std::string rollout(const std::string& arguments) const {
    return "rollout " + file("q.safetensors") + " " + arguments;
  }
};

}  // namespace

TEST(FilmCommand, FilmsWithoutADisplayAndChangesNoNumber) {
  const Learner learner;
  const std::string a = learner.file("a.webp"), b = learner.file("b.webp");
  const auto plain = run(learner.rollout("--seconds 2 --seed 3"));
  EXPECT_EQ(run(learner.rollout("--seconds 2 --seed 3 --size 192x108 --film " + a)), plain);
  EXPECT_EQ(run(learner.rollout("--seconds 2 --seed 3 --size 192x108 --film " + b)), plain);
  EXPECT_EQ(contentOf(a), contentOf(b));
  const Decoded decoded = decodedWebp(a);
  ASSERT_FALSE(decoded.pictures.empty());
  EXPECT_EQ(decoded.pictures[0].size(), QSize(192, 108));
  EXPECT_NEAR(decoded.ends.back(), 2000, 200) << "and a fall at the end is seen";
  EXPECT_EQ(decoded.pictures[0].pixelColor(0, 0), lightTheme().paper);
  run(learner.rollout("--seconds 0.5 --size 64x64 --appearance dark --film " + learner.file("dark.webp")));
  EXPECT_EQ(decodedWebp(learner.file("dark.webp")).pictures.at(0).pixelColor(0, 0), darkTheme().paper);
}

TEST(FilmCommand, StripsOfSignalsStandBelow) {
  const Learner learner;
  const std::string with = learner.file("with.webp"), without = learner.file("without.webp");
  run(learner.rollout("--seconds 1 --size 480x270 --strips pole_angle,reward_goal+reward_time --film " + with));
  run(learner.rollout("--seconds 1 --size 480x270 --film " + without));
  const Decoded a = decodedWebp(with), b = decodedWebp(without);
  ASSERT_FALSE(a.pictures.empty());
  EXPECT_EQ(a.pictures[0].size(), QSize(480, 270));
  EXPECT_EQ(a.pictures[0].pixelColor(2, 268), lightTheme().panel) << "the strips' ground";
  EXPECT_NE(b.pictures[0].pixelColor(2, 268), lightTheme().panel);
  EXPECT_NE(a.pictures.front(), a.pictures.back()) << "the cursor goes along";
  run(learner.rollout("--seconds 1 --size 480x270 --strips usual --film " + learner.file("usual.webp")));
  const std::string film = "--seconds 1 --film " + learner.file("no.webp") + " ";
  expectRefusal(learner.rollout(film + "--strips pole_angel"), 2, {"--strips", "pole_angel"});
  expectRefusal(learner.rollout(film + "--strips ,"), 2, {"--strips", "pole_angle"});
  expectRefusal(learner.rollout("--strips reward"), 2, {"--strips", "--film"});
}

TEST(FilmCommand, FilmsTasksWithoutAClockAtTwentyStepsASecond) {
  const Learner learner("--environment cliff --features table --episodes 300");
  const std::string film = learner.file("a.webp");
  const auto result = run(learner.rollout("--episodes 1 --size 128x72 --film " + film));
  const Decoded decoded = decodedWebp(film);
  ASSERT_FALSE(decoded.ends.empty());
  EXPECT_NEAR(decoded.ends.back(), 50 * result["steps"].get<double>(), 34);
}

TEST(FilmCommand, RefusesBeforeAnythingIsLived) {
  const Learner learner;
  const std::string film = "--seconds 1 --film " + learner.file("a.webp") + " ", there = learner.file("there.webp");
  expectRefusal(learner.rollout("--film " + learner.file("a.avi")), 2, {"--film", ".webp, .gif, .apng, .mp4 or .webm"});
  expectRefusal(learner.rollout(film + "--size 1x1"), 2, {"--size", "1x1", "64 to 3840"});
  expectRefusal(learner.rollout(film + "--size 100000x100000"), 2, {"--size", "3840"});
  expectRefusal(learner.rollout(film + "--size 960"), 2, {"--size", "960x540"});
  expectRefusal(learner.rollout(film + "--appearance pink"), 2, {"--appearance", "pink", "light or dark"});
  expectRefusal(learner.rollout("--size 960x540"), 2, {"--size", "--film"});
  expectRefusal(learner.rollout("--appearance dark"), 2, {"--appearance", "--film"});
  expectRefusal(learner.rollout("--seconds 601 --film " + there), 2, {"--film", "18,000", "600 s"});
  expectRefusal(learner.rollout("--seconds 0.001 --film " + there), 2, {"--film", "no step"});
  expectRefusal(learner.rollout("--film /nowhere/a.webp"), 3, {"--film", "/nowhere"});
  expectRefusal(learner.rollout("--size 65x65 --film " + learner.file("a.mp4")), 2, {"even", "65x65"});
  std::ofstream(there) << "mine";
  expectRefusal(learner.rollout("--seconds 1 --film " + there), 3, {"there.webp", "exists already"});
  EXPECT_EQ(contentOf(there), "mine");
  EXPECT_FALSE(std::filesystem::exists(learner.file("a.webp")));
  const std::string q = learner.rollout("--seconds 1 --film " + learner.file("a.gif"));
  const std::string command =
      std::string("PATH=/nonexistent ") + SUREFOOT_PROGRAM + " " + q + " 2>" + learner.file("e");
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 3);
  const std::string said = contentOf(learner.file("e"));
  EXPECT_NE(said.find("ffmpeg"), std::string::npos) << said;
  EXPECT_NE(said.find(".webp needs none"), std::string::npos) << said;
}

TEST(FilmCommand, LeavesNothingOnAFullDiskOrWhenItIsInterrupted) {
  const Learner learner;
  const auto shell = [&](const std::string& command) {
    return WEXITSTATUS(std::system(("env -u DISPLAY -u QT_QPA_PLATFORM sh -c '" + command + "' >" +
                                    learner.file("out") + " 2>" + learner.file("err"))
                                       .c_str()));
  };
  for (const char* name : {"a.webp", "a.webm", "a.apng"}) {
    if (std::string(name) != "a.webp" && ffmpegProgram().empty()) continue;
    const std::string film = learner.file(name);
    EXPECT_EQ(shell("ulimit -f 2; exec " + std::string(SUREFOOT_PROGRAM) + " " +
                    learner.rollout("--seconds 4 --size 640x360 --film " + film)),
              3)
        << name << contentOf(learner.file("err"));
    EXPECT_TRUE(contentOf(learner.file("err")).starts_with("surefoot: --film: ")) << contentOf(learner.file("err"));
    EXPECT_FALSE(std::filesystem::exists(film)) << name;
    EXPECT_EQ(
        shell(std::string(SUREFOOT_PROGRAM) + " " + learner.rollout("--seconds 500 --size 1920x1080 --film " + film) +
              " & p=$!; sleep 2; kill -TERM $p; wait $p"),
        130)
        << name << contentOf(learner.file("err"));
    EXPECT_FALSE(std::filesystem::exists(film)) << name;
  }
  for (const auto& entry : std::filesystem::directory_iterator(learner.file("")))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".surefoot")) << entry.path();
}

}  // namespace surefoot
