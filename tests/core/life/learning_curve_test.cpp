// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/learning_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/basics/random.h"
#include "core/life/fall.h"

namespace surefoot {

namespace {

/// A life with dips that are one episode deep, episodes that grow longer, and falls that grow rare.
std::vector<CurvePoint> wholeLog(std::int64_t episodes) {
  Random random(3);
  std::vector<CurvePoint> log;
  CurvePoint p;
  for (std::int64_t i = 1; i <= episodes; ++i) {
    const auto at = static_cast<double>(i);
    p.episode = i;
    p.lifeSteps += 10 + static_cast<std::int64_t>(random.uniform(0, 50) + std::min(at, 100.0));
    p.falls += random.uniform(0, 1) < 20.0 / (20.0 + at);
    p.averageReward = 200 - 300 * std::exp(-at / 400) + random.uniform(-5, 5);
    if (random.uniform(0, 1) < 5 / at) p.averageReward -= 90;
    log.push_back(p);
  }
  return log;
}

/// What is seen of points on a screen: the least and the greatest of each column of pixels, and where there were falls.
struct Picture {
  std::map<int, std::pair<double, double>> columns;
  std::vector<int> falls;
};

constexpr int kWidth = 400;  // [px]

Picture pictureOf(const std::vector<CurvePoint>& points, double from, double to) {
  Picture picture;
  std::int64_t falls = 0;
  for (const CurvePoint& p : points) {
    const bool fell = p.falls > falls;
    falls = p.falls;
    const auto x = static_cast<double>(p.lifeSteps);
    const int column = static_cast<int>(std::floor((x - from) / (to - from) * kWidth));
    if (column < -1 || column > kWidth) continue;  // those beside the edge count as its neighbours
    const auto [at, isNew] = picture.columns.try_emplace(column, p.averageReward, p.averageReward);
    at->second.first = std::min(at->second.first, p.averageReward);
    at->second.second = std::max(at->second.second, p.averageReward);
    if (fell && (picture.falls.empty() || picture.falls.back() != column)) picture.falls.push_back(column);
  }
  return picture;
}

/// Whatever one shows, the other shows in the same column or in one beside it.
void expectAlike(const Picture& one, const Picture& other) {
  for (const auto& [column, range] : one.columns) {
    if (column < 0 || column >= kWidth) continue;
    double least = kInfinity, greatest = -kInfinity;
    for (int beside = column - 1; beside <= column + 1; ++beside)
      if (const auto at = other.columns.find(beside); at != other.columns.end())
        least = std::min(least, at->second.first), greatest = std::max(greatest, at->second.second);
    ASSERT_LE(least, range.first) << "column " << column;
    ASSERT_GE(greatest, range.second) << "column " << column;
  }
  for (const int column : one.falls) {
    if (column < 0 || column >= kWidth) continue;
    ASSERT_TRUE(std::any_of(other.falls.begin(), other.falls.end(), [&](int c) { return std::abs(c - column) <= 1; }))
        << "the fall in column " << column;
  }
}

std::vector<CurvePoint> kept(const std::vector<CurvePoint>& log, std::int64_t* resolution = nullptr) {
  LearningCurve curve;
  for (const CurvePoint& p : log) curve.add(p);
  std::vector<CurvePoint> points;
  curve.copyTo(points);
  if (resolution) *resolution = curve.resolution();
  return points;
}

}  // namespace

TEST(LearningCurve, ShowsTheSameMinimaMaximaAndFallsAsTheWholeLog) {
  for (const std::int64_t episodes : {500, 40'000, 2'000'000}) {
    const auto log = wholeLog(episodes);
    std::int64_t resolution = 0;
    const auto points = kept(log, &resolution);
    EXPECT_LE(points.size(), LearningCurve::kMostPoints);
    const auto end = static_cast<double>(log.back().lifeSteps);
    // All of it, the first two hours as in "While it learned", a tenth in the middle and at the end.
    for (const auto& [from, to] :
         {std::pair{0.0, end}, {0.0, std::min(end, 144'000.0)}, {0.45 * end, 0.55 * end}, {0.9 * end, end}}) {
      SCOPED_TRACE(std::to_string(episodes) + " episodes, from step " + std::to_string(from));
      ASSERT_GE(static_cast<double>(resolution) * (to - from), kWidth * to) << "no more than it promises";
      const Picture whole = pictureOf(log, from, to), drawn = pictureOf(points, from, to);
      expectAlike(whole, drawn);
      expectAlike(drawn, whole);
    }
  }
}

TEST(LearningCurve, KeepsEveryEpisodeOfTheBeginningAndTheNewest) {
  const auto log = wholeLog(1'000'000);
  const auto points = kept(log);
  EXPECT_GE(points.size(), LearningCurve::kMostPoints / 4);
  for (std::size_t i = 0; i < 2000; ++i) ASSERT_EQ(points[i].episode, log[i].episode);
  EXPECT_EQ(points.back().episode, log.back().episode);
  EXPECT_EQ(points.back().falls, log.back().falls);
  for (std::size_t i = 1; i < points.size(); ++i) ASSERT_GT(points[i].episode, points[i - 1].episode);
}

TEST(LearningCurve, AddingDoesNotAllocate) {
  LearningCurve curve;
  std::vector<CurvePoint> points;
  curve.copyTo(points);
  const auto log = wholeLog(300'000);
  std::size_t most = 0;
  for (const CurvePoint& p : log) {
    curve.add(p);
    if (p.episode % 1000 == 0) curve.copyTo(points), most = std::max(most, points.size());
  }
  EXPECT_LE(most, LearningCurve::kMostPoints) << "as many as there is room for from the start";
}

// A window keeps one wherever a mark is drawn, and all of the newest.
TEST(Falls, AreThinnedOutSoThatEveryMarkKeepsOne) {
  std::vector<Fall> falls;
  std::vector<std::int64_t> all;
  for (std::int64_t i = 1; i <= 60'000; ++i) {
    Fall fall;
    fall.number = i, fall.episode = 3 * i, fall.lifeSteps = 100 * i;
    falls.push_back(fall);
    all.push_back(fall.lifeSteps);
    thinOut(falls);
    ASSERT_LE(falls.size(), kMostFalls);
  }
  EXPECT_EQ(falls.front().number, 1);
  for (std::size_t i = 0; i < kNewestFalls; ++i)
    ASSERT_EQ(falls[falls.size() - 1 - i].number, 60'000 - static_cast<std::int64_t>(i));
  constexpr double kPixels = 500;
  for (const std::int64_t end : {60'000, 600'000, 6'000'000})  // any span from the beginning
    for (const std::int64_t at : all) {
      if (at > end) break;
      const auto after = std::lower_bound(falls.begin(), falls.end(), at,
                                          [](const Fall& f, std::int64_t steps) { return f.lifeSteps < steps; });
      const double right = after == falls.end() ? 1e300 : static_cast<double>(after->lifeSteps - at);
      const double left = after == falls.begin() ? 1e300 : static_cast<double>(at - std::prev(after)->lifeSteps);
      ASSERT_LE(std::min(left, right), 2 * static_cast<double>(end) / kPixels) << "at step " << at;
    }
}

// The rule by hand: a constant average of 160 is above 0.75·200 and does not move; the first episode that counts is
// 330.
TEST(EndOfLearning, IsNotBeforeEpisode330) {
  EndOfLearning end;
  for (int i = 1; i <= 400; ++i) end.add(i, 160, 50 * i, 200);
  EXPECT_EQ(end.episode(), 330);
  EXPECT_EQ(end.lifeSteps(), 50 * 330);
}

TEST(EndOfLearning, AFlatStartDoesNotCount) {
  EndOfLearning end;
  for (int i = 1; i <= 1000; ++i) end.add(i, -100, 50 * i, 200);
  EXPECT_EQ(end.episode(), 0);
}

// A ramp of 0.012 an episode moves by exactly 3 in 250: not below 3. At half of it the rule holds as soon as the
// average is above 150.
TEST(EndOfLearning, ComparesWith250EpisodesBefore) {
  EndOfLearning steep, gentle;
  for (int i = 1; i <= 900; ++i) {
    steep.add(i, 160 + 0.0121 * i, i, 200);
    gentle.add(i, 147 + 0.006 * i, i, 200);
  }
  EXPECT_EQ(steep.episode(), 0);
  EXPECT_EQ(gentle.episode(), 501);
}

}  // namespace surefoot
