// SPDX-License-Identifier: GPL-3.0-or-later
// The part of History that decides which lives are kept in memory.
#include <QFile>
#include <algorithm>

#include "ui/session/history.h"

namespace surefoot {

namespace {

constexpr int kMostKept = 50;                     // lives
constexpr std::size_t kLeastMemory = 256u << 20;  // [bytes] that must stay free
constexpr std::size_t kBeside = 8u << 20;         // [bytes] for curves and falls, about

/// Whether `one` is dropped before `other`: saved lives first, then the life with fewer steps.
bool goesBefore(const KeptLife& one, const KeptLife& other) {
  if (one.unsaved() != other.unsaved()) return other.unsaved();
  return one.known.progress.steps < other.known.progress.steps;
}

}  // namespace

std::optional<std::size_t> availableMemory() {
  QFile file(QStringLiteral("/proc/meminfo"));
  if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
  for (const QByteArray& line : file.readAll().split('\n')) {
    if (!line.startsWith("MemAvailable:")) continue;
    bool good = false;
    const qulonglong kilobytes = line.simplified().split(' ').value(1).toULongLong(&good);
    if (good) return kilobytes * 1024;
  }
  return std::nullopt;
}

bool History::canKeep() const {
  const auto available = availableMemory();
  return life_.bytes() <= mostKept_ && (!available || *available >= kLeastMemory);
}

void History::endOrAsk(std::function<void()> end) {
  const bool keeps = canKeep();
  const auto least = life_.learned() && keeps ? withoutRoom(life_.bytes()) : nullptr;
  const auto goOn = [this, keeps, end = std::move(end)] {
    keepsBefore_ = keeps || canKeep();  // a yes from before the question stays a yes after the answer
    end();
  };
  if (askBeforeEnding_ && ((life_.unsaved() && !keeps) || (least && least->unsaved())))
    askBeforeEnding_(least, goOn);
  else
    goOn();
}

/// Copies the window's data about the life that runs; the learner's thread adds the life itself later.
std::shared_ptr<KeptLife> History::putAside() const {
  auto kept = std::make_shared<KeptLife>();
  kept->aside = std::make_shared<LifeAside>();
  kept->known = life_.known();
  kept->curve = life_.curves().live().number;
  kept->seen = looking_.seen();
  return kept;
}

/// The kept life to drop before one of `more` bytes is kept as well; nullptr: there is room.
std::shared_ptr<KeptLife> History::withoutRoom(std::size_t more) const {
  std::size_t bytes = more;
  int lives = 1;
  std::shared_ptr<KeptLife> least;
  for (const auto& other : kept_) {
    const auto life = other.lock();
    if (!life || !life->aside) continue;
    bytes += life->known.bytes + kBeside;
    ++lives;
    if (!least || goesBefore(*life, *least)) least = life;
  }
  return bytes > mostKept_ || lives > kMostKept ? least : nullptr;
}

void History::keep(const std::shared_ptr<KeptLife>& kept) {
  std::erase_if(kept_, [](const auto& other) { return other.expired(); });
  while (const auto least = withoutRoom(kept->known.bytes + kBeside)) letGo(*least);
  kept_.push_back(kept);
}

/// When the environment changes, the curves go to the last life of the old environment that undo can bring back.
void History::moveCurves(std::shared_ptr<KeptLife> last) {
  const std::string& here = life_.configuration().names.environment;
  for (auto other = kept_.rbegin(); !last && other != kept_.rend(); ++other)
    if (auto life = other->lock(); life && life->aside && life->known.configuration.names.environment == here)
      last = std::move(life);
  if (last) last->curves = life_.curves();
}

void History::forgetChanges() {
  for (const auto& other : kept_)
    if (const auto life = other.lock(); life && life->aside) letGo(*life);
  undo_.clear();
}

/// The learner's thread frees large tables, so that the window does not wait.
void History::letGo(KeptLife& kept) {
  life_.visit([aside = std::exchange(kept.aside, nullptr)](const Life&) {});
  kept.seen = {};
  kept.curves.reset();
}

std::vector<std::shared_ptr<KeptLife>> History::unsavedBefore() const {
  std::vector<std::shared_ptr<KeptLife>> list;
  for (const auto& other : kept_)
    if (auto life = other.lock(); life && life->unsaved()) list.push_back(std::move(life));
  return list;
}

}  // namespace surefoot
