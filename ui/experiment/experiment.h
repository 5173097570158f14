// SPDX-License-Identifier: GPL-3.0-or-later
// What the Experiment page is about: a plan as text, the run that carries it out, and the newest results.
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

namespace surefoot {

class Experiment final : public QObject {
  Q_OBJECT

 public:
  enum class State { Ready, Running, Paused, Complete };

  Experiment(const Registry& registry, std::vector<PlanSource> sources, QString folder, QObject* parent = nullptr);
  const Registry& registry() const { return registry_; }
  /// The condition that figures bring to the front; empty: none.
  const std::string& chosen() const { return chosen_; }
  void choose(const std::string& condition);

  const std::vector<PlanSource>& sources() const { return sources_; }
  ~Experiment() override;

  /// Loads a plan, a recipe or a store of results. What ran is stopped; what it lived is kept in its store, and lives
  /// in hand beside it. What takes long goes on behind this call: isOpening() until planChanged() or failed() tells the
  /// end.
  Status open(const std::string& path);
  bool isOpening() const { return opening_.busy(); }
  /// About how long the plan takes [min]; 0: nobody knows.
  double minutes() const { return minutes_; }
  /// What a text would give, without taking it over.
  Result<Plan> parse(const std::string& text) const;
  /// A text in place of the plan's; refused with the line that is wrong. What was lived under the old one is left. It
  /// may go on behind this call as open() does.
  Status setText(const std::string& text);
  const std::string& text() const { return text_; }
  /// The file of the plan or results; a new text has none.
  const std::string& path() const { return path_; }
  const std::string& title() const { return title_; }

  /// Empty until something is opened. That of a store of results is made from what the store keeps; it has no text.
  const std::optional<Plan>& plan() const { return plan_; }
  const StoredPlan& storedPlan() const { return stored_; }
  const std::vector<FigureSpec>& figures() const { return figures_; }
  /// The results that are shown: table, figures and judgements are of this view.
  const std::shared_ptr<const LabView>& view() const { return results_.view(); }
  /// The claims of the thesis that a recipe bears on, judged on what is there; empty for other plans.
  const std::vector<Judgement>& judgements() const { return results_.judgements(); }
  /// What the thesis says of a condition's falls; nullptr: nothing.
  const ThesisVerdict* thesisOn(const std::string& condition) const;
  std::string policyOf(const std::string& condition) const { return results_.policyOf(condition); }
  /// Whether all lives of a condition and of its reference are there.
  bool isComplete(const std::string& condition) const { return results_.isComplete(condition); }
  /// What stands where results are missing: what brings them.
  QString whyNoResults() const;
  const std::vector<Claim>& claims() const { return results_.claims(); }
  /// Whether a claim is about a change against the reference.
  bool isInPercent(const std::string& claim) const;
  /// Makes one of the figures from the results, which may take a while; nothing until there are any.
  std::optional<Figure> figure(const FigureSpec& spec) const;
  /// A panel looks at this figure; resultsChanged() tells when it is made.
  void look(std::size_t panel, const FigureSpec& spec) { results_.want(panel, spec); }
  bool isMaking() const { return results_.busy(); }
  /// nullptr: it is not made yet, or cannot be.
  const Figure* figureAt(const FigureSpec& spec) const { return results_.figure(spec.name); }

  State state() const { return state_; }
  /// Whether something is missing; run() tells why it cannot be done.
  bool canRun() const { return (plan_ || !whyNot_.empty()) && state_ != State::Complete; }
  /// Whether there is a plan's text to begin again with.
  bool canStartAgain() const { return !text_.empty() && (livesDone_ > 0 || thread_); }
  /// Runs what is missing, or goes on after a pause: into the store that was opened, else into one of its own beside
  /// the program's data.
  /// `otherVersion`: also beside lives of a version that lives others; else these are refused, and needsConsent().
  Status run(bool otherVersion = false);
  bool needsConsent() const { return needsConsent_; }
  /// Lives stand still where they are; run() goes on.
  void pause();
  /// Forgets what was lived; the store stays on the disk, and what is in hand beside it.
  void reset();

  int livesDone() const { return livesDone_; }
  int livesPlanned() const { return surefoot::livesPlanned(stored_); }
  double share() const { return share_; }
  /// Those of lives in hand count, too.
  std::int64_t falls() const { return falls_; }
  /// Of the lives that are stored and shown: what table and figures are made of.
  int livesShown() const { return results_.lives(); }
  std::int64_t fallsShown() const { return results_.falls(); }
  double elapsed() const;  ///< [s], of running
  /// [s]; nothing: cannot be told yet.
  std::optional<double> left() const;
  int livesOf(const std::string& condition) const;
  const std::string& storePath() const { return storePath_; }

 Q_SIGNALS:
  void planChanged();
  void progressed();
  void resultsChanged();
  void chosenChanged();
  void stateChanged();
  void failed(const QString& sentence);
  /// Another plan takes the place of one whose lives are in this store.
  void leftBehind(const QString& store);

 private:
  void tick();
  void take();
  /// Everything that opening something gives; made on any thread.
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
  Result<Opened> prepareStore(const std::string& path, const std::atomic<bool>& interrupted) const;
  Result<Opened> prepareText(const std::string& text, const std::string& path,
                             const std::atomic<bool>& interrupted) const;
  Status begin(Prepare prepare);
  void adopt(Opened opened);
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
  std::vector<Leaving> leaving_;         // stopped, and keeping what they have in hand
  std::string whyNot_;                   // why a store cannot be gone on with
  std::shared_ptr<const LabView> view_;  // the newest; results_ shows it soon
  State state_ = State::Ready;
  bool needsConsent_ = false;
  QTimer timer_;
  QElapsedTimer running_;
  double before_ = 0, share_ = 0;
  double shareBefore_ = 0, shareAtStart_ = 0;  // when the threads began; when they were last let go
  double minutes_ = 0;
  int livesDone_ = 0;
  std::int64_t falls_ = 0;
  Background opening_;  // last: it is waited for first
};

}  // namespace surefoot
