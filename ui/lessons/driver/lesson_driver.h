// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson while a student takes it: its life, the step in hand, what was said and what came out. Everything that a
// step does to the life goes through the same commands as a person's hand. The window's thread.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <array>
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <set>

#include "core/lessons/handed_in/hand_in.h"
#include "core/lessons/lesson_life.h"
#include "core/lessons/verdict.h"
#include "ui/lessons/driver/lesson_draft.h"
#include "ui/session/session.h"
#include "ui/support/background.h"
#include "ui/support/call_queue.h"

namespace surefoot {

class LessonDriver final : public QObject {
  Q_OBJECT

 public:
  /// `handIn`: what was done before, of a lesson that is gone on with.
  LessonDriver(const Registry& registry, Lesson lesson, HandIn handIn, QObject* parent = nullptr);
  ~LessonDriver() override;

  const Lesson& lesson() const { return lesson_; }
  const HandIn& handIn() const { return handIn_; }
  Session& session() { return *session_; }
  std::size_t number() const { return number_; }
  const LessonStep& step() const { return lesson_.steps[number_]; }

  enum class Phase {
    Preparing,  ///< what happens before the step begins
    Open,       ///< the student's turn
    Running,    ///< a run with an end is shown
    Finished    ///< the lesson is over
  };
  Phase phase() const { return phase_; }
  /// Of the run or the lives in hand, 0 to 1.
  double progress() const { return progress_->load(); }
  /// Text of the step, with its numbers.
  const QString& text() const { return text_; }
  std::optional<double> predicted(std::size_t step) const;
  std::optional<double> observed(std::size_t step) const;
  /// The lives of the present step's ways; empty: not lived yet.
  const std::vector<std::vector<double>>& lives() const { return lives_; }
  /// What the step asks for is done (or there is nothing): one can go on. A choice that was wrong twice is answered.
  bool mayGoOn() const;
  bool taskDone() const { return taskDone_; }
  bool parKept() const { return parKept_; }
  int tries() const { return tries_; }
  double secondsInStep() const { return static_cast<double>(clock_.elapsed()) / 1000; }
  /// Whoever comes back to a step that was answered need not answer it again, but may.
  bool answered() const { return answered_.contains(number_); }
  bool hintTaken() const { return hintTaken_; }

  /// Goes on with a lesson that was left at a step: its life is lived again as it was when one came there.
  void goOn(std::size_t number);
  /// Goes to a step; begins with it when the lesson was just opened.
  void enter(std::size_t number);
  void next();
  void back();
  /// The step begins again, as it was.
  void resetStep();

  void say(double value);
  void choose(std::size_t option, const QString& because);
  void order(const std::vector<std::size_t>& order);
  void number(double value);
  void point(const PointedAt& place);
  void compared(Compared said);
  /// `agrees`: with the model answer, by the student.
  void words(const QString& text, std::optional<bool> agrees);
  /// Runs or pauses; where an attempt at a task is over, another life begins.
  void run();
  void takeHint();
  void noteReplay();
  /// The life goes on through these actions; none of them begins another.
  bool keepsLife(const LessonActions& actions) const;
  /// Episodes and steps of the life when one came to a step; nothing: it is not known.
  std::optional<std::pair<std::int64_t, std::int64_t>> arrivedAt(std::size_t step) const;
  /// The draft at the step in hand; without one, the answer that was given last.
  LessonDraft draft() const;
  void keepDraft(LessonDraft draft);
  const LessonDrafts& drafts() const { return drafts_; }
  void setDrafts(LessonDrafts drafts) { drafts_ = std::move(drafts); }
  static constexpr std::array kComparedNames = {"first", "second", "cannot tell"};  ///< as `Compared` counts

  /// The life as it is now, for the Live page: a copy.
  void copyLife(std::function<void(Configuration began, std::unique_ptr<Life>)> then);

 Q_SIGNALS:
  void stepChanged();
  void phaseChanged();
  void textChanged();
  void livesChanged();
  void judged(const LessonVerdict& verdict);
  void taskChanged();  ///< it is done, or its par is kept, too
  void marked(const LessonMark& mark);
  void drafted();
  void refused(const QString& sentence);

 private:
  /// What conditions know; it belongs to the learner's thread.
  struct Knowledge {
    LessonValues values;
    std::shared_ptr<const LifeRecord> before;
  };
  /// The life and all that is known at the beginning of a step.
  struct Beginning {
    std::shared_ptr<const TensorFile> checkpoint;
    Configuration began;
    LessonValues values;
    std::shared_ptr<const LifeRecord> learnedFrom;
    std::shared_ptr<const LifeRecord> record{}, before{};  ///< the life as a record, and the one before it
    int curve = 0;                                         ///< the number of the life's curve
    int changes = 0;                                       ///< to the life until then
    std::int64_t episodes = 0;
    std::vector<RunCurve> earlier{};  ///< the curves beside the life's own
    Parameters parameters{};          ///< as the life had them
  };
  using Then = std::function<void()>;

  void setPhase(Phase phase);
  void keepState(const std::function<void(Beginning)>& then);
  void settle(const Then& then);
  bool meddled() const;
  void arrive(std::size_t number, std::optional<Beginning> from);
  void prepare();
  void place(LifeInHand life, LessonValues values, const Then& then);
  void open();
  void forgetCurves();
  void liveWays();
  void perform(LessonActions actions, std::size_t from, Then then);
  void beginLife(Configuration configuration, const Then& then);
  void transfer(const Then& then);
  void run(const LessonRun& run, const Then& then);
  void observe(const LessonCondition& of, const Then& then);
  void watchTask();
  void noteTask(LessonMark done);
  void noteAttempt(bool wasDone);
  void renderText();
  void mark(LessonMark mark);
  /// Writes the life, and the one before it, into a mark; on the learner's thread.
  using Record = std::function<void(const Life&, const Knowledge&, LessonMark&)>;
  Record recorder() const;
  void judge(const LessonVerdict& verdict, LessonMark mark);
  std::shared_ptr<const LifeRecord> learnedFrom() const;
  LessonValues valuesOfMarks() const;
  /// Calls `look` on the learner's thread, between two steps, and `then` on the window's.
  void visit(std::function<void(const Life&, Knowledge&)> look, Then then = {});
  void know(std::function<void(LessonValues&)> change);

  const Registry& registry_;
  const Lesson lesson_;
  HandIn handIn_;
  CallQueue calls_;
  std::shared_ptr<Knowledge> knowledge_;
  std::unique_ptr<Session> session_;
  Background background_;
  std::shared_ptr<std::atomic<double>> progress_;
  std::map<const TensorFile*, std::shared_ptr<const LifeRecord>> learned_;
  std::map<std::size_t, double> predicted_, observed_;
  LessonDrafts drafts_;
  std::vector<std::vector<double>> lives_;
  std::optional<Beginning> beginning_;           // of the step in hand
  std::map<std::size_t, Beginning> beginnings_;  // of the steps that one came to, as one came there first
  std::optional<Beginning> settled_;             // when the step's own run was over, before the student's hands
  std::size_t number_ = 0;
  Phase phase_ = Phase::Preparing;
  QString text_;
  std::optional<std::vector<RunCurve>> restored_;  // the curves of the state that was gone back to
  std::optional<int> undone_;                      // the curves from this number on are of lives that did not happen
  QElapsedTimer clock_;
  std::uint64_t entered_ = 0;  // counts the steps that were entered: what comes late is of another one
  bool attemptOver_ = false;   // the life in hand was an attempt
  bool charted_ = false;       // a chart showed the life in hand
  int tries_ = 0;
  bool taskDone_ = false, parKept_ = false, hintTaken_ = false;
  std::set<std::size_t> answered_;  // steps: rightly, or as often as one is asked
};

}  // namespace surefoot
