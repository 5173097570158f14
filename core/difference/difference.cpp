// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/difference/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/basics/typed_json.h"
#include "core/difference/lock_step.h"
#include "core/difference/log_difference.h"
#include "core/difference/record.h"
#include "core/difference/told.h"
#include "core/experiment/configuration.h"
#include "core/files/read_file.h"

namespace surefoot {

const char* nameOf(RecordKind kind) {
  return kind == RecordKind::Journal ? "journal" : kind == RecordKind::Checkpoint ? "checkpoint" : "log";
}

namespace {

/// The life of a record, up to so many steps.
Result<std::unique_ptr<Life>> lifeOf(const Registry& registry, const LifeRecordFile& record, std::int64_t steps) {
  auto life = makeLife(registry, record.life.configuration, record.life.life, false, steps);
  if (life || life.error().kind != ErrorKind::Usage) return life;
  return fileError(record.path, life.error().message);  // a command or a parameter that cannot be
}

/// An element of a tensor as a number, or its bytes where they are none.
std::string elementText(const Tensor& t, std::size_t i) {
  const auto read = [&]<class T>(T value) {
    std::memcpy(&value, t.bytes.data() + i * sizeof value, sizeof value);
    return fmt::format("{}", value);
  };
  switch (t.type) {
    case ElementType::F64:
      return read(0.0);
    case ElementType::I64:
      return read(std::int64_t{});
    case ElementType::U64:
      return read(std::uint64_t{});
    case ElementType::U32:
      return read(std::uint32_t{});
    case ElementType::U16:
      return read(std::uint16_t{});
    case ElementType::U8:
      break;
  }
  return fmt::format("{}", static_cast<unsigned char>(t.bytes[i]));
}

/// The first number that two checkpoints hold otherwise.
std::optional<TwoValues> firstOtherNumber(const TensorFile& a, const TensorFile& b) {
  for (const Tensor& t : a.tensors) {
    const Tensor* other = b.find(t.name);
    if (!other) return TwoValues{t.name, "there", "nothing"};
    if (t.bytes == other->bytes) continue;
    if (t.type != other->type || t.bytes.size() != other->bytes.size())
      return TwoValues{t.name, fmt::format("{} numbers", t.count()), fmt::format("{} numbers", other->count())};
    const auto at = std::mismatch(t.bytes.begin(), t.bytes.end(), other->bytes.begin()).first - t.bytes.begin();
    const std::size_t i = static_cast<std::size_t>(at) / sizeOf(t.type);
    return TwoValues{fmt::format("{}[{}]", t.name, i), elementText(t, i), elementText(*other, i)};
  }
  for (const Tensor& t : b.tensors)
    if (!a.find(t.name)) return TwoValues{t.name, "nothing", "there"};
  return std::nullopt;
}

Parting partedBy(TwoValues values, std::int64_t step) {
  Parting parting;
  static_cast<TwoValues&>(parting) = std::move(values);
  parting.step = step;
  return parting;
}

/// What the files themselves hold of the end: where they were left, and what was learned until then.
std::optional<Parting> partingAtTheEnd(const LifeRecordFile& a, const LifeRecordFile& b) {
  const Journal &x = a.life, &y = b.life;
  const std::int64_t steps = std::min(x.steps, y.steps);
  if (x.steps != y.steps)
    return partedBy({"steps of the life", fmt::format("{}", x.steps), fmt::format("{}", y.steps)}, steps);
  if (a.checkpoint && b.checkpoint)
    if (auto other = firstOtherNumber(*a.checkpoint, *b.checkpoint)) return partedBy(std::move(*other), steps);
  if (x.hash != y.hash)
    return partedBy({"hash at the end", fmt::format("{:016x}", x.hash), fmt::format("{:016x}", y.hash)}, steps);
  return std::nullopt;
}

/// Lives both again, side by side, as far as the shorter one goes.
Status liveBoth(const Registry& registry, const LifeRecordFile& a, const LifeRecordFile& b, RecordDifference& found,
                const std::atomic<bool>* interrupted) {
  const std::int64_t steps = std::min(a.life.steps, b.life.steps);
  for (const LifeRecordFile* record : {&a, &b})
    if (!record->notLivable.empty()) {
      found.note = "it was not lived again: " + record->notLivable;
      return Done{};
    }
  const auto first = lifeOf(registry, a, steps), second = lifeOf(registry, b, steps);
  if (!first) return first.error();
  if (!second) return second.error();
  auto parting = partingOf(**first, **second, steps, interrupted);
  if (!parting) return parting.error();
  found.same = *parting ? (*parting)->step.value_or(0) : steps;
  found.parting = std::move(*parting);
  for (const auto& [record, life] : {std::pair{&a, first->get()}, std::pair{&b, second->get()}})
    if (life->steps() == record->life.steps && life->hash() != record->life.hash)
      found.note =
          record->path + ": lived again it is another life than it says, as one of another version of Surefoot is.";
  return Done{};
}

}  // namespace

Result<RecordDifference> differenceOf(const Registry& registry, const std::string& first, const std::string& second,
                                      const std::atomic<bool>* interrupted) {
  const auto kind = kindOf(first), other = kindOf(second);
  if (!kind) return kind.error();
  if (!other) return other.error();
  if (*kind != *other)
    return fileError(first, fmt::format("it is a {}, and {} is a {}; only two of a kind can be compared.",
                                        nameOf(*kind), second, nameOf(*other)));
  if (*kind == RecordKind::Log) return logDifference(first, second, interrupted);
  const auto a = readRecord(registry, first, *kind), b = readRecord(registry, second, *kind);
  if (!a) return a.error();
  if (!b) return b.error();
  RecordDifference found{.kind = *kind};
  found.told = toldOtherwise(a->life, b->life);
  found.same = std::min(a->life.steps, b->life.steps);
  if (!found.told.empty())
    if (const Status s = liveBoth(registry, *a, *b, found, interrupted); !s) return s.error();
  if (!found.parting) found.parting = partingAtTheEnd(*a, *b);
  return found;
}

}  // namespace surefoot
