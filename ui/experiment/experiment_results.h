// SPDX-License-Identifier: GPL-3.0-or-later
// Results as the page shows them: the newest view of a store, its judgements, and the figures in the panels,
// all made from one and the same view on a thread of their own. Belongs to the window's thread.
#pragma once

#include <QObject>
#include <map>
#include <memory>

#include "core/laboratory/laboratory_thread.h"
#include "core/recipes/figure.h"
#include "core/recipes/thesis_verdicts.h"
#include "ui/support/background.h"

namespace surefoot {

class ExperimentResults final : public QObject {
  Q_OBJECT

 public:
  explicit ExperimentResults(const Registry& registry, QObject* parent = nullptr);

  /// Another plan: nothing is shown, and work on older results is dropped.
  void begin(std::vector<Claim> claims, const StoredPlan& plan);
  /// A newer view; changed() tells when it is shown. Views that come faster than they can be shown are left out.
  void show(std::shared_ptr<const LabView> view);
  /// The figure that is looked at in this place.
  void want(std::size_t place, const FigureSpec& spec);
  bool busy() const { return making_.busy(); }

  const std::shared_ptr<const LabView>& view() const { return shown_.view; }
  /// The number of lives that are over, and their falls.
  int lives() const { return shown_.lives; }
  std::int64_t falls() const { return shown_.falls; }
  const std::vector<Judgement>& judgements() const { return shown_.judgements; }
  const std::map<std::string, ThesisVerdict>& thesis() const { return shown_.thesis; }
  /// nullptr: it is not made yet, or there is none.
  const Figure* figure(const std::string& name) const;
  const std::vector<Claim>& claims() const { return claims_; }
  /// The policy of a condition, by name; empty: there is no such condition.
  std::string policyOf(const std::string& condition) const;
  /// Whether all lives of a condition and of its reference are shown.
  bool isComplete(const std::string& condition) const;

 Q_SIGNALS:
  void changed();
  void failed(const QString& sentence);

 private:
  struct Shown {
    std::shared_ptr<const LabView> view;
    int lives = 0;
    std::int64_t falls = 0;
    std::vector<Judgement> judgements;
    std::map<std::string, ThesisVerdict> thesis;
    std::map<std::string, std::shared_ptr<const Figure>> figures;
  };
  void make();
  static void judge(const Registry& registry, const std::vector<Claim>& claims, std::uint64_t seed, Shown& shown,
                    const std::atomic<bool>& interrupted);

  const Registry& registry_;
  std::vector<Claim> claims_;
  std::uint64_t seed_ = 1;
  std::shared_ptr<const LabView> newest_;
  std::map<std::size_t, FigureSpec> wanted_;
  std::map<std::string, std::string> policies_;
  bool stale_ = false;      // something new came while the last results were made
  bool cancelled_ = false;  // the results that are being made will not be shown
  QString trouble_;         // the error that was told last; newer results of the same plan have it, too
  Shown shown_;
  Background making_;  // last member: its destructor runs first and waits
};

/// One figure with the thesis's marks; nothing if it cannot be drawn yet. Any thread.
std::shared_ptr<const Figure> figureOf(const Registry& registry, const FigureSpec& spec, const LabView& view,
                                       const std::vector<Claim>& claims);

}  // namespace surefoot
