// SPDX-License-Identifier: GPL-3.0-or-later
// The data of the Experiment page: a plan as text, the run that carries it out (or the store of another process that is
// followed), and the newest results.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>

#include "core/laboratory/laboratory_thread.h"
#include "core/recipes/recipe.h"
#include "ui/experiment/experiment_results.h"
#include "ui/experiment/plans/plan_source.h"
#include "ui/support/following.h"

namespace surefoot {

class Experiment final : public QObject {
  Q_OBJECT

 public:
  /// Following: the lives are another process's, and are only looked at.
  enum class State { Ready, Running, Paused, Complete, Following };

  Experiment(const Registry& registry, std::vector<PlanSource> sources, QString folder, QObject* parent = nullptr);
  const Registry& registry() const { return registry_; }
  /// The condition that figures bring to the front; empty: none.
  const std::string& chosen() const { return chosen_; }
  void choose(const std::string& condition);

  const std::vector<PlanSource>& sources() const { return sources_; }
  ~Experiment() override;

  /// Loads a plan, a recipe or a store of results. A running plan is stopped; its lives are kept in its store,
  /// and unfinished lives beside it. Long work goes on after this call: isOpening() until planChanged() or failed()
  /// tells the end.
  Status open(const std::string& path);
  bool isOpening() const { return opening_.busy(); }
  /// Looks at a store that another process writes, or will write: read only, and anew whenever it has grown. What was
  /// shown before is left as by open(). Nothing runs until stopFollowing(), open() or setText().
  void follow(const std::string& path);
  /// The results stay, as if the store had been opened.
  void stopFollowing();
  /// nullptr: nothing is followed.
  const Following* following() const { return following_.get(); }
  /// How the store that is followed stands, in words.
  QString followingText() const;
  /// The expected time of the plan [min]; 0: unknown.
  double minutes() const { return minutes_; }
  /// The plan that a text describes; the experiment keeps its own.
  Result<Plan> parse(const std::string& text) const;
  /// A text in place of the plan's; refused with the line that is wrong. The lives of the old plan are left. The
  /// work may go on after this call, as with open().
  Status setText(const std::string& text);
  const std::string& text() const { return text_; }
  /// The file of the plan or results; a new text has none.
  const std::string& path() const { return path_; }
  const std::string& title() const { return title_; }

  /// Empty until something is opened. The plan of a store of results is made from the store; it has no text.
  const std::optional<Plan>& plan() const { return plan_; }
  const StoredPlan& storedPlan() const { return stored_; }
  const std::vector<FigureSpec>& figures() const { return figures_; }
  /// The results that are shown: table, figures and judgements are made from this view.
  const std::shared_ptr<const LabView>& view() const { return results_.view(); }
  /// The claims of the thesis that the recipe tests, judged by the results so far; empty for other plans.
  const std::vector<Judgement>& judgements() const { return results_.judgements(); }
  /// The verdict of the thesis on a condition's falls; nullptr: the thesis has none.
  const ThesisVerdict* thesisOn(const std::string& condition) const;
  std::string policyOf(const std::string& condition) const { return results_.policyOf(condition); }
  /// Whether all lives of a condition and of its reference are there.
  bool isComplete(const std::string& condition) const { return results_.isComplete(condition); }
  /// The text that stands in place of missing results: it says how to get them.
  QString whyNoResults() const;
  const std::vector<Claim>& claims() const { return results_.claims(); }
  /// Whether a claim is about a change against the reference.
  bool isInPercent(const std::string& claim) const;
  /// Makes one of the figures from the results; this may take a while. Nothing until there are results.
  std::optional<Figure> figure(const FigureSpec& spec) const;
  /// A panel looks at this figure; resultsChanged() tells when it is made.
  void look(std::size_t panel, const FigureSpec& spec) { results_.want(panel, spec); }
  bool isMaking() const { return results_.busy(); }
  /// nullptr: it is not made yet, or cannot be.
  const Figure* figureAt(const FigureSpec& spec) const { return results_.figure(spec.name); }

  State state() const { return state_; }
  /// Whether results are missing; if the plan cannot run, run() says why.
  bool canRun() const { return (plan_ || !whyNot_.empty()) && state_ != State::Complete && state_ != State::Following; }
  /// Whether there is a plan's text to begin again with.
  bool canStartAgain() const { return !text_.empty() && (livesDone_ > 0 || thread_); }
  /// Runs the missing lives, or goes on after a pause: into the store that was opened, else into a new store in the
  /// folder of the program's data.
  /// `otherVersion`: also beside lives of a version that lives others; else these are refused, and so are robots whose
  /// programs nobody has allowed: needs() tells which.
  Status run(bool otherVersion = false);
  enum class Consent { None, OtherVersion, Programs };
  Consent needs() const { return needs_; }
  /// The program that was refused; another one of the plan is refused next.
  void allowProgram();
  /// Lives stand still where they are; run() goes on.
  void pause();
  /// Forgets all lives; the store stays on the disk, and beside it the lives that are not finished.
  void reset();

  int livesDone() const { return livesDone_; }
  int livesPlanned() const { return surefoot::livesPlanned(stored_); }
  double share() const { return share_; }
  /// Falls of unfinished lives count, too.
  std::int64_t falls() const { return falls_; }
  /// The number of lives behind the table and the figures: they are stored and shown.
  int livesShown() const { return results_.lives(); }
  std::int64_t fallsShown() const { return results_.falls(); }
  double elapsed() const;  ///< time of running [s]
  /// The time that is left [s]; nothing: not known yet.
  std::optional<double> left() const;
  int livesOf(const std::string& condition) const;
  const std::string& storePath() const { return storePath_; }

 Q_SIGNALS:
  void planChanged();
  void progressed();
  void resultsChanged();
  void chosenChanged();
  void stateChanged();
  void followed();  ///< once a second, while something is followed
  void failed(const QString& sentence);
  /// Another plan was opened; the lives of the plan before it are in this store.
  void leftBehind(const QString& store);

 private:
  void tick();
  void take();
  /// The result of opening a plan or a store; made on any thread.
  struct Opened {
    std::string text, path;
    std::optional<Plan> plan;
    StoredPlan stored;
    std::vector<FigureSpec> figures;
    std::vector<Claim> claims;
    std::shared_ptr<const LabView> view{};
    double minutes = 0;
    int lives = 0;
    std::int64_t falls = 0;
    std::string whyNot{}, note{};
  };
  using Prepare = std::function<Result<Opened>(const std::atomic<bool>& interrupted)>;
  Result<Opened> prepareStore(const Store& store) const;
  Result<Opened> prepareText(const std::string& text, const std::string& path,
                             const std::atomic<bool>& interrupted) const;
  void addRecipe(Opened& opened, const std::atomic<bool>& interrupted) const;
  Status begin(Prepare prepare);
  void adopt(Opened opened);
  void takePlan(Opened& opened);
  void takeView(Opened& opened);
  void takeFollowed(Opened opened);
  Status openToRun(bool otherVersion);
  void leave();
  std::string placeForResults() const;
  void setState(State state);
  std::vector<FigureSpec> standardFigures(const StoredPlan& plan) const;

  const Registry& registry_;
  std::string chosen_;
  std::vector<PlanSource> sources_;
  QString folder_;
  std::string text_, path_, title_, storePath_;
  std::optional<Plan> plan_;
  StoredPlan stored_;
  std::vector<FigureSpec> figures_;
  ExperimentResults results_;
  std::unique_ptr<LaboratoryThread> thread_;
  struct Leaving {
    std::string store;
    std::unique_ptr<LaboratoryThread> thread;
  };
  std::vector<Leaving> leaving_;         // stopped; they still save their unfinished lives
  std::string whyNot_;                   // why the run of a store cannot continue
  std::shared_ptr<const LabView> view_;  // the newest view; results_ shows it soon
  State state_ = State::Ready;
  Consent needs_ = Consent::None;
  QTimer timer_;
  QElapsedTimer running_;
  double before_ = 0, share_ = 0;
  double shareBefore_ = 0, shareAtStart_ = 0;  // when the threads began; when they were last let go
  double minutes_ = 0;
  int livesDone_ = 0;
  std::int64_t falls_ = 0;
  std::unique_ptr<Following> following_;
  QElapsedTimer sinceFirstLife_;  // that came while it was followed: the time left is reckoned from then on
  int livesAtFirst_ = 0;
  Background opening_;  // last member: its destructor runs first and waits
};

}  // namespace surefoot
