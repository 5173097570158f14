// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/values/deferred_trace.h"

#include <algorithm>
#include <bit>

namespace surefoot {

void DeferredTrace::decay(WeightTable& table, double factor, double cutoff) {
  constexpr double kLeast = 1e-200;                            // a trace below it counts as 0, even without a cut-off
  if (factor < std::max(cutoff, kLeast)) return clear(table);  // no z is above 1
  setProduct(product_ * factor);
  const double least = std::max(cutoff, kLeast) * inverse_;
  while (begin_ != end_ && mark(begin_).e < least) pay(table, mark(begin_++));
  if (product_ < kSmallest || end_ - begin_ > mostMarks_) beginAgain(table);
}

void DeferredTrace::replace(WeightTable& table, std::span<const Index> rows, Index columns, Index column) {
  makeRoom(rows.size());
  const double e = inverse_, sum = table.sum_;
  WeightTable::Weight* const weights = table.weights_.data() + column;
  Mark* const marks = marks_.data();
  const std::size_t mask = marks_.size() - 1;
  std::size_t end = end_;
  for (const Index row : rows) {
    WeightTable::Weight& w = weights[row * columns];
    w.v += sum * (w.e - e);
    w.e = e;
    marks[end++ & mask] = {row * columns + column, e};
  }
  end_ = end;
}

void DeferredTrace::clear(WeightTable& table) {
  for (; begin_ != end_; ++begin_) pay(table, mark(begin_));
  begin_ = end_ = 0;
  table.sum_ = 0.0;
  setProduct(1.0);
}

// Everything is paid; the remaining traces go on with a new P.
void DeferredTrace::beginAgain(WeightTable& table) {
  std::size_t kept = begin_;
  for (std::size_t i = begin_; i != end_; ++i) {
    const Mark m = mark(i);
    if (table.weights_[m.k].e != m.e) continue;  // dead, or a second mark of the same step
    pay(table, m);
    mark(kept++) = {m.k, m.e * product_};
  }
  end_ = kept;
  for (std::size_t i = begin_; i != end_; ++i) table.weights_[mark(i).k].e = mark(i).e;
  mostMarks_ = std::max(kUsualMarks, 2 * (end_ - begin_));
  table.sum_ = 0.0;
  setProduct(1.0);
}

void DeferredTrace::makeRoom(std::size_t more) {
  if (end_ - begin_ + more <= marks_.size()) return;
  std::vector<Mark> larger(std::bit_ceil(2 * (end_ - begin_ + more)));
  for (std::size_t i = begin_; i != end_; ++i) larger[i - begin_] = mark(i);
  end_ -= begin_;
  begin_ = 0;
  marks_ = std::move(larger);
}

void DeferredTrace::transfer(WeightTable& table, Archive& archive) {
  std::vector<Index> weights;
  std::vector<double> e, live, v;
  for (std::size_t i = begin_; i != end_; ++i) {
    const Mark& m = mark(i);
    weights.push_back(m.k);
    e.push_back(m.e);
    live.push_back(table.weights_[m.k].e);
    v.push_back(table.weights_[m.k].v);
  }
  constexpr std::size_t kMost = 1u << 30;
  archive.list("weights", weights, kMost);
  archive.list("e", e, kMost);
  archive.list("live", live, kMost);
  archive.list("v", v, kMost);
  archive.value("sum", table.sum_);
  archive.value("product", product_);
  auto most = static_cast<std::int64_t>(mostMarks_);
  archive.value("most", most, 1, static_cast<std::int64_t>(std::max(kUsualMarks, 2 * table.size())));
  if (!archive.reading() || !archive.good()) return;

  if (e.size() != weights.size() || live.size() != weights.size() || v.size() != weights.size() ||
      std::any_of(weights.begin(), weights.end(), [&](Index k) { return k >= table.size(); }))
    return archive.refuse("weights", "does not fit the table");
  if (!std::is_sorted(e.begin(), e.end()) || (!e.empty() && e.front() <= 0.0))
    return archive.refuse("e", "is not in order");
  if (!(product_ > 0.0 && product_ <= 1.0)) return archive.refuse("product", "is out of range");
  setProduct(product_);
  begin_ = end_ = 0;
  mostMarks_ = static_cast<std::size_t>(most);
  makeRoom(weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    mark(end_++) = {weights[i], e[i]};
    table.weights_[weights[i]] = {v[i], live[i]};
  }
}

}  // namespace surefoot
