// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration.h"

#include <algorithm>
#include <cmath>

#include "core/basics/types.h"

namespace surefoot {

namespace {

constexpr double kEdges[] = {-kInfinity, 0.001, 0.005, 0.02, 0.05, 0.1, 0.2, 0.5, kInfinity};
constexpr std::size_t kBins = std::size(kEdges) - 1;
constexpr double kTolerance = 0.005;  // half a per cent: no one acts on less
constexpr double k95 = 1.96;          // two-sided 95 % of the normal distribution

}  // namespace

double Calibration::Report::error() const {
  double sum = 0.0;
  for (const Bin& bin : bins) sum += static_cast<double>(bin.count) * std::abs(bin.said - bin.fell);
  return all.count > 0 ? sum / static_cast<double>(all.count) : 0.0;
}

Calibration::Verdict Calibration::Report::verdict() const {
  const double apart = std::abs(all.said - all.fell);
  if (apart > std::max(halfWidth, kTolerance)) return Verdict::Errs;
  const bool clear = apart <= kTolerance || halfWidth <= std::max(all.said, all.fell) / 2;
  return clear ? Verdict::Holds : Verdict::Unclear;
}

void Calibration::end(double came) {
  if (open_ > 0) last_[(next_ + kSteps - 1) % kSteps] = 1;
  for (std::size_t k = 1; k <= open_; ++k, came *= discount_)
    came_[(next_ + kSteps - k) % kSteps] = static_cast<float>(came);
  closed_ = std::min(kSteps, closed_ + open_);
  open_ = 0;
}

void Calibration::abandon() {
  next_ = (next_ + kSteps - open_) % kSteps;
  open_ = 0;
}

Calibration::Report Calibration::report() const {
  Report report{.all = {-kInfinity, kInfinity}, .bins = {}};
  std::vector<Bin> bins(kBins);
  for (std::size_t b = 0; b < kBins; ++b) bins[b].low = kEdges[b], bins[b].high = kEdges[b + 1];
  double apart = 0.0, squares = 0.0;  // Σ (said − came) of an episode, and the sum of its squares over the episodes
  for (std::size_t k = 1; k <= closed_; ++k) {
    const std::size_t i = (next_ + 2 * kSteps - open_ - k) % kSteps;
    const double said = said_[i], came = came_[i];
    if (last_[i] != 0) squares += apart * apart, apart = 0.0;
    apart += said - came;
    const auto edge = std::upper_bound(std::begin(kEdges) + 1, std::end(kEdges) - 1, said);
    for (Bin* bin : {&report.all, &bins[static_cast<std::size_t>(edge - std::begin(kEdges) - 1)]})
      ++bin->count, bin->said += said, bin->fell += came;
  }
  const auto mean = [](Bin& bin) {
    if (bin.count > 0) bin.said /= static_cast<double>(bin.count), bin.fell /= static_cast<double>(bin.count);
  };
  mean(report.all);
  if (report.all.count > 0) report.halfWidth = k95 * std::sqrt(squares + apart * apart) / static_cast<double>(closed_);
  for (Bin& bin : bins) {
    mean(bin);
    if (bin.count > 0) report.bins.push_back(bin);
  }
  return report;
}

void Calibration::transfer(Archive& archive) {
  archive.under("calibration.", [&] {
    std::vector<double> said, came;  // the oldest first
    std::vector<std::uint32_t> last;
    for (std::size_t k = closed_ + open_; k > 0; --k) {
      said.push_back(said_[(next_ + kSteps - k) % kSteps]);
      came.push_back(came_[(next_ + kSteps - k) % kSteps]);
      last.push_back(last_[(next_ + kSteps - k) % kSteps]);
    }
    archive.list("said", said, kSteps);
    archive.list("came", came, kSteps);
    archive.list("last", last, kSteps);
    archive.value("open", open_, 0, static_cast<std::int64_t>(kSteps));
    if (!archive.reading() || !archive.good()) return;
    if (came.size() != said.size() || last.size() != said.size() || open_ > said.size())
      return archive.refuse("said", "does not fit its episodes");
    std::copy(said.begin(), said.end(), said_.begin());
    std::copy(came.begin(), came.end(), came_.begin());
    std::transform(last.begin(), last.end(), last_.begin(), [](std::uint32_t end) { return end != 0; });
    next_ = said.size() % kSteps;
    closed_ = said.size() - open_;
  });
}

}  // namespace surefoot
