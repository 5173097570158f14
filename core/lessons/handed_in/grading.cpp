// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/handed_in/grading.h"
#include "core/environment_library.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "core/lessons/lesson_life.h"
#include "core/lessons/verdict.h"
#include "core/life/lives_version.h"
#include "core/text/printable.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

std::vector<double> numbersIn(const std::string& text) {
  std::istringstream in(text);
  std::vector<double> numbers;
  for (double number = 0; in >> number;) numbers.push_back(number);
  return numbers;
}

class Grader {
 public:
  Grader(const Registry& registry, const Lesson& lesson, const HandIn& handIn, const std::atomic<bool>* interrupted)
      : registry_(registry),
        lesson_(lesson),
        handIn_(handIn),
        interrupted_(interrupted),
        values_(lesson) {}

  Grade grade() {
    grade_.student = handIn_.student;
    grade_.lesson = handIn_.lesson;
    grade_.steps = lesson_.steps.size();
    grade_.finished = handIn_.finished();
    grade_.reached = handIn_.marks.empty() ? 0 : handIn_.reached(lesson_);
    for (const LessonStep& step : lesson_.steps) {
      grade_.questions += step.ask && !std::holds_alternative<WordsQuestion>(*step.ask);
      grade_.tasks += step.done.has_value();
      grade_.predictions += step.predict.has_value();
    }
    checkFile();
    for (const LessonMark& mark : handIn_.marks) take(mark);
    grade_.minutes = seconds_ / 60;
    return grade_;
  }

 private:
  void remark(const std::string& sentence) {
    grade_.trusted = false;
    if (std::find(grade_.remarks.begin(), grade_.remarks.end(), sentence) == grade_.remarks.end())
      grade_.remarks.push_back(sentence);
  }

  void checkFile() {
    if (!handIn_.edited.empty())
      remark(fmt::format("edited: line {} is not as the program wrote it", fmt::join(handIn_.edited, ", ")));
    if (!handIn_.damaged.empty()) remark(fmt::format("damaged: line {}", fmt::join(handIn_.damaged, ", ")));
    if (handIn_.lessonHash != lesson_.hash) remark("the lesson's file is another one now");
    if (handIn_.livesVersion != kLivesVersion) remark("a version of the program lived it whose lives are others");
    if (handIn_.seed != seedOf(lesson_, handIn_.student)) remark("its seed is not this student's");
  }

  /// The keys that the lesson lets one turn, or turns itself.
  const std::set<std::string>& offered() {
    if (!offered_.empty()) return offered_;
    const auto add = [&](const LessonActions& actions) {
      for (const LessonAction& a : actions) {
        if (a.kind == LessonAction::Kind::Set) offered_.insert(a.key);
        if (a.kind == LessonAction::Kind::Scenario) addScenarios();
      }
    };
    for (const LessonStep& step : lesson_.steps) {
      for (const std::string& name : step.show) {
        offered_.insert(name);
        if (name == "scenario") addScenarios();
        if (name == "actions" || name == "rule") offered_.insert("policy.threshold");
        if (name == "parameters")
          for (const auto& entry : lesson_.start.parameters.all()) offered_.insert(entry.parameter.key);
      }
      add(step.begin);
      if (step.predict) add(step.predict->then);
    }
    return offered_;
  }
  /// The student's, and those that the lesson chooses.
  std::set<std::uint64_t> seeds() const {
    std::set<std::uint64_t> all = {handIn_.seed};
    for (const LessonStep& step : lesson_.steps) {
      for (const LessonActions* actions : {&step.begin, step.predict ? &step.predict->then : &step.begin})
        for (const LessonAction& a : *actions)
          if (a.kind == LessonAction::Kind::Seed) all.insert(a.seed);
    }
    return all;
  }
  void addScenarios() {
    for (const AssignmentEntry* scenario : scenariosOf(registry_, lesson_.start.names.environment))
      for (const auto& [key, value] : scenario->values) offered_.insert(key);
  }

  void checkOffered(std::size_t step, const LifeRecord& record) {
    for (const Assignment& a : record.set)
      if (!offered().contains(a.key)) notOffered(step, a.key);
    for (const CommandText& c : record.changes)
      if (c.key != "push" && c.key != "place" && c.key != "policy" && !offered().contains(c.key))
        notOffered(step, c.key);
    if (!seeds().contains(record.seed)) remark(fmt::format("step {}: its seed is not this student's", step + 1));
    if (record.learnedFrom) checkOffered(step, *record.learnedFrom);
  }
  void notOffered(std::size_t step, const std::string& key) {
    remark(fmt::format("step {}: {} was set, which the lesson does not offer", step + 1, printable(shortened(key))));
  }

  /// The life of a mark, lived again; nullptr: it has none, or comes out otherwise.
  const Life* lived(const LessonMark& mark, const std::shared_ptr<const LifeRecord>& record) {
    if (!record) {
      remark(fmt::format("step {}: there is no life in it that could be lived again", mark.step + 1));
      return nullptr;
    }
    checkOffered(mark.step, *record);
    // Whatever a file says, it takes no longer than an honest one.
    constexpr std::int64_t kMostSteps = 60'000'000;
    for (const LifeRecord* one = record.get(); one; one = one->learnedFrom.get()) stepsLived_ += one->steps;
    if (stepsLived_ > kMostSteps) {
      remark("more is in it than can be lived again");
      return nullptr;
    }
    if (life_.life && record->hash == lifeHash_ && record->steps == life_.life->steps()) return life_.life.get();
    auto again = relive(registry_, lesson_, *record, interrupted_);
    if (!again) {
      remark(fmt::format("step {}: {}", mark.step + 1, again.error().message));
      return nullptr;
    }
    life_ = std::move(*again);
    lifeHash_ = record->hash;
    return life_.life.get();
  }

  /// What "before." names is that of the life before, lived again.
  void knowBefore(const LessonMark& mark) {
    if (!mark.before) return;
    auto before = relive(registry_, lesson_, *mark.before, interrupted_);
    if (before) return values_.endLife(factsOf(*before->life));
    remark(fmt::format("step {}: the life before: {}", mark.step + 1, before.error().message));
  }

  bool names(const LessonCondition& condition) const {
    return std::any_of(condition.reads.begin(), condition.reads.end(),
                       [&](int place) { return lesson_.quantities[static_cast<std::size_t>(place)].before; });
  }

  void take(const LessonMark& mark) {
    if (mark.step >= lesson_.steps.size()) return remark(fmt::format("there is no step {}", mark.step + 1));
    const LessonStep& step = lesson_.steps[mark.step];
    // A clock that jumped counts for an hour at most, and never backwards.
    constexpr double kLongest = 3600;
    const double now = std::clamp(std::isfinite(mark.seconds) ? mark.seconds : 0.0, 0.0, kLongest);
    if (mark.kind == LessonMark::Kind::Arrived) inStep_ = 0;
    seconds_ += std::max(0.0, now - inStep_);
    inStep_ = std::max(inStep_, now);
    switch (mark.kind) {
      case LessonMark::Kind::Said:
        return values_.predict(mark.step, mark.value);
      case LessonMark::Kind::Observed:
        return observed(mark, step);
      case LessonMark::Kind::Lived:
        for (const LessonLives::Way& way : step.lives ? step.lives->ways : std::vector<LessonLives::Way>())
          if (way.label == mark.text) values_.lived(way.place, mark.values);
        return;
      case LessonMark::Kind::Answered:
        return answered(mark, step);
      case LessonMark::Kind::Done:
        return done(mark, step);
      default:
        return;
    }
  }

  void observed(const LessonMark& mark, const LessonStep& step) {
    const LessonCondition* of = step.predict ? &step.predict->of : step.observe ? &*step.observe : nullptr;
    if (!of) return remark(fmt::format("step {} observes nothing", mark.step + 1));
    const Life* life = lived(mark, mark.life);
    if (!life) return;
    if (names(*of)) knowBefore(mark);
    const double value = values_.of(*of, *life);
    values_.observe(mark.step, value);
    if (std::abs(value - mark.value) > 1e-9 * std::max(1.0, std::abs(value)))
      remark(fmt::format("step {}: it says {:.6g}, and its life came to {:.6g}", mark.step + 1, mark.value, value));
  }

  std::optional<bool> isRight(const LessonMark& mark, const LessonQuestion& question) {
    const std::vector<double> numbers = numbersIn(mark.text);
    if (const auto* choice = std::get_if<ChoiceQuestion>(&question))
      return !numbers.empty() && numbers[0] >= 1 && judge(*choice, static_cast<std::size_t>(numbers[0]) - 1).right;
    if (const auto* order = std::get_if<OrderQuestion>(&question)) {
      std::vector<std::size_t> said;
      for (const double n : numbers) said.push_back(n >= 1 ? static_cast<std::size_t>(n) - 1 : order->options.size());
      return judge(*order, said).right;
    }
    if (const auto* number = std::get_if<NumberQuestion>(&question)) {
      const Life* life = lived(mark, mark.life);
      if (!life || numbers.empty()) return std::nullopt;
      return judge(*number, numbers[0], values_.of(number->answer, *life)).right;
    }
    if (const auto* point = std::get_if<PointQuestion>(&question)) {
      const Life* life = lived(mark, mark.life);
      if (!life || numbers.empty()) return std::nullopt;
      const bool map = point->on == PointQuestion::On::Map;
      if (map && numbers.size() != life->environment().task().state.size()) return std::nullopt;
      return values_.accepts(point->accept, *life, map ? PointedAt{numbers, 0} : PointedAt{{}, numbers[0]});
    }
    return compared(mark);
  }

  /// The lives of both ways are lived again as well.
  std::optional<bool> compared(const LessonMark& mark) {
    const LessonStep& step = lesson_.steps[mark.step];
    const Life* life = lived(mark, mark.life);
    if (!life || !step.lives) return std::nullopt;
    const auto ways = liveWays(registry_, lesson_, *step.lives, life_.now(), values_, 1, interrupted_);
    if (!ways || ways->size() != 2) return std::nullopt;
    const Compared said = mark.text == "first"    ? Compared::First
                          : mark.text == "second" ? Compared::Second
                                                  : Compared::CannotTell;
    return judge(compare((*ways)[0], (*ways)[1]), said).right;
  }

  void answered(const LessonMark& mark, const LessonStep& step) {
    if (!step.ask) return remark(fmt::format("step {} asks nothing", mark.step + 1));
    const auto right = isRight(mark, *step.ask);
    if (!right) return;
    if (*right != mark.right)
      remark(fmt::format("step {}: it says {}, and it is {}", mark.step + 1, mark.right ? "right" : "wrong",
                         *right ? "right" : "wrong"));
    const bool first = tried_.insert(mark.step).second;
    if (*right && first) ++grade_.rightAtOnce;
    if (*right && right_.insert(mark.step).second) ++grade_.rightAtLast;
  }

  void done(const LessonMark& mark, const LessonStep& step) {
    if (!step.done) return remark(fmt::format("step {} has no task", mark.step + 1));
    const Life* life = lived(mark, mark.life);
    if (!life) return;
    if (names(*step.done) || (step.par && names(*step.par))) knowBefore(mark);
    if (!values_.holds(*step.done, *life))
      return remark(fmt::format("step {}: its life does not do the task", mark.step + 1));
    if (done_.insert(mark.step).second) ++grade_.tasksDone;
    if (step.par && values_.holds(*step.par, *life) && kept_.insert(mark.step).second) ++grade_.pars;
  }

  const Registry& registry_;
  const Lesson& lesson_;
  const HandIn& handIn_;
  const std::atomic<bool>* interrupted_;
  LessonValues values_;
  Grade grade_;
  LifeInHand life_;
  std::uint64_t lifeHash_ = 0;
  std::set<std::string> offered_;
  std::set<std::size_t> tried_, right_, done_, kept_;
  double seconds_ = 0, inStep_ = 0;
  std::int64_t stepsLived_ = 0;
};

}  // namespace

Grade gradeOf(const Registry& registry, const Lesson& lesson, const HandIn& handIn,
              const std::atomic<bool>* interrupted) {
  return Grader(registry, lesson, handIn, interrupted).grade();
}

std::string gradesHead() {
  return "student,lesson,finished,steps_reached,steps,questions,right_at_once,right_at_last,tasks,tasks_done,pars,"
         "minutes,lived_again,remarks\n";
}

std::string asCsv(const Grade& g) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{:.1f},{},{}\n", csvCell(g.student), csvCell(g.lesson),
                     g.finished ? "yes" : "no", g.reached, g.steps, g.questions, g.rightAtOnce, g.rightAtLast, g.tasks,
                     g.tasksDone, g.pars, g.minutes, g.trusted ? "yes" : "no",
                     csvCell(fmt::format("{}", fmt::join(g.remarks, "; "))));
}

}  // namespace surefoot
