// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/lesson.h"

#include "core/life/episode_log.h"

namespace surefoot {

namespace {

struct KindOfQuestion {
  std::string operator()(const NumberQuestion&) const { return "work out"; }
  std::string operator()(const ChoiceQuestion& q) const {
    if (q.mistake) return "find the mistake";
    return q.because ? "choose, because" : "choose";
  }
  std::string operator()(const OrderQuestion&) const { return "order"; }
  std::string operator()(const PointQuestion&) const { return "point"; }
  std::string operator()(const WordsQuestion&) const { return "own words"; }
  std::string operator()(const CompareQuestion&) const { return "compare"; }
};

}  // namespace

std::string kindOf(const LessonStep& step) {
  if (step.predict) return "predict";
  if (step.ask) return std::visit(KindOfQuestion{}, *step.ask);
  if (step.done) return step.par ? "puzzle" : "task";
  if (step.lives || (step.run && step.run->ends())) return "watch";
  return "try";
}

std::string questionOf(const LessonStep& step) {
  if (step.predict) return step.predict->question;
  if (step.ask) return std::visit([](const auto& q) { return q.question; }, *step.ask);
  return step.task;
}

std::uint64_t seedOf(const Lesson& lesson, const std::string& student) {
  constexpr std::uint64_t kMost = 999'999;
  if (!lesson.seedOfStudent) return lesson.start.seed;
  Hash64 hash;
  hash.add(std::string_view(student));
  return 1 + hash.value() % kMost;
}

}  // namespace surefoot
