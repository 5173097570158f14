// SPDX-License-Identifier: GPL-3.0-or-later
// Begins new lives. A life with large tables is made in the background while the old one goes on: until it is ready,
// background() is busy; if it fails, `refused` says why.
#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ui/running/running_life.h"
#include "ui/session/history.h"
#include "ui/support/background.h"

namespace surefoot {

class NewLives final : public QObject {
  Q_OBJECT

 public:
  NewLives(RunningLife& life, History& history);

  /// A new life with the present configuration, the same seed and the same start; the old one stays as a faint curve.
  Status restart();
  /// The same with an empty table.
  Status restartEmpty();
  /// The same with another value of a parameter, with an empty table if it needs one.
  Status setParameterAndRestart(const std::string& key, double value);
  /// A new life with another configuration.
  Status begin(Configuration configuration);
  /// A new life in another environment, with its usual parameters.
  Status beginEnvironment(const std::string& name);
  Status setSeed(std::uint64_t seed);
  /// Another learning rule needs another table: a new life begins, with the values of all parameters that both have.
  Status setAgent(const std::string& name);

  using Then = std::function<void(const Status&)>;
  /// Changes a parameter that needs a new table; the learned values are fitted to the new table.
  void carryOver(const std::string& key, double value, Then then);

  /// A life that can begin.
  struct Made {
    Configuration configuration;
    std::unique_ptr<Life> life;
    std::optional<LifeFile> file{};  ///< the file that it was read from
    std::string remark{};            ///< about that file
    StepTaken last{};                ///< that the life made, if it is known
  };
  /// What the window knows of it.
  KnownLife known(const Made& made) const;
  using Make = std::function<Result<Made>(const std::atomic<bool>& interrupted)>;
  /// Makes a life in the background and begins it; `then` is called when it has begun, or could not.
  Status beginWhenMade(Make make, const Then& then = {});
  /// Makes a life of this configuration.
  Make makeOf(Configuration configuration) const;
  Background& background() { return background_; }

 Q_SIGNALS:
  void remarked(const QString& remark);  ///< about the file of a life that has begun
  void refused(const QString& why);      ///< a life that was begun could not be made

 private:
  using Adopt = std::function<Status(Made)>;
  Status whenMade(Make make, Adopt adopt, const Then& then = {});
  Status beginAgain(Configuration configuration);
  Status adopt(Made made);

  RunningLife& life_;
  History& history_;
  Background background_;
  CallQueue calls_;  // of the learner's thread
};

}  // namespace surefoot
