// SPDX-License-Identifier: GPL-3.0-or-later
// A second learner beside the first: another policy, learning rule, start or parameters in a world of its own, with the
// same seed. It runs, rests and starts again with the first, and begins as the first did unless it is told otherwise; a
// parameter that is changed there is changed here as well, as long as it is the same in both.
#pragma once

#include <QPointer>
#include <QWidget>
#include <atomic>
#include <functional>
#include <map>

#include "ui/session/session.h"
#include "ui/support/background.h"

class QDialog;

namespace surefoot {

class CompareStrip;
class WorldView;

class Rival final : public QWidget {
  Q_OBJECT

 public:
  /// The beginning of the second learner's life.
  enum class Start { Same, Empty, File };

  explicit Rival(RunningLife& first, QWidget* parent = nullptr);
  ~Rival() override;
  Session& session() { return *session_; }
  RunningLife& first() { return first_; }
  WorldView& world() { return *world_; }
  /// The strip above both worlds: how both learn and began, and their falls.
  CompareStrip& strip();

  const std::string& policy() const { return policy_; }
  const std::string& agent() const { return agent_; }
  Start start() const { return begin_.start; }
  // Another learning rule or start begins a new life; if the old one has learned anything, the person is asked first.
  void choose(const std::string& agent, const std::string& policy);
  void setStart(Start start);
  /// Starts with this Q-function, learning and acting so, in the middle of an episode as it stood after these inputs.
  /// `begin` is called when nothing is in the way, before it.
  void startIn(std::shared_ptr<const TensorFile> file, EpisodeInputs until, const std::string& agent,
               const std::string& policy, std::function<void()> begin);
  /// Starts with a Q-function from a file.
  void startWith(const QString& path);
  /// To be added to the second's time so that both clocks agree [s, or steps]: how long the first had lived when the
  /// second began. None: it is not known yet.
  std::optional<double> later() const;
  /// Parameters with other values than the first's: "Threshold 66". Empty: none.
  QString ownParameters() const;
  void showParameters();
  /// Out of sight it rests; its life goes on when it is shown again.
  void setResting(bool resting);

 Q_SIGNALS:
  void refused(const QString& sentence);
  void told(const QString& sentence);
  void newTableAsked(const QString& sentence, const std::function<void()>& goOn);
  void changed();  ///< policy, learning rule, start or parameters

 private:
  Configuration configurationLikeFirst();
  bool fits(const Configuration& own) const;
  void firstReplaced();
  void secondReplaced();
  void startAgain();
  void askToStartAgain(const QString& why, std::function<void()> choose);
  void follow();
  void followParameters();
  void noteBeginning(std::int64_t own);
  void askForNewTable(const QString& key, double value);

  RunningLife& first_;
  struct Beginning {
    Start start = Start::Same;
    std::shared_ptr<const TensorFile> file{};
    std::optional<EpisodeInputs> until{};  ///< where the life begins, once it is there
  };
  std::string policy_, agent_;
  Beginning begin_, began_;  // the beginning that is chosen; the beginning of the present life
  std::map<std::string, double> firstHad_, own_;
  std::unique_ptr<Session> session_;
  /// The second's lives, by the lineage of the first's life beside them.
  std::map<std::uint64_t, std::shared_ptr<KeptLife>> beside_;
  std::uint64_t lineage_;                 // lineage of the first's life
  std::uint64_t ranBeside_, keptBeside_;  // the first's lineage beside the second's life now; … before
  bool resting_ = false, startsLate_ = false;
  bool noted_ = false;  ///< when the life to come begins beside the first
  /// Steps of the first when the second began, less the second's own; filled on the first's thread.
  std::shared_ptr<std::atomic<std::int64_t>> later_;
  WorldView* world_ = nullptr;
  QPointer<CompareStrip> strip_;
  QPointer<QDialog> parameters_;
  Background reading_;
};

}  // namespace surefoot
