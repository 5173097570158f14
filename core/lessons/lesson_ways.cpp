// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/work_pool.h"
#include "core/lessons/lesson_life.h"

namespace surefoot {

Result<std::vector<std::vector<double>>> liveWays(const Registry& registry, const Lesson& lesson,
                                                  const LessonLives& lives, const Configuration& begun,
                                                  const LessonValues& values, int jobs,
                                                  const std::atomic<bool>* interrupted) {
  const auto count = static_cast<std::size_t>(lives.count);
  std::vector<std::vector<double>> results(lives.ways.size(), std::vector<double>(count));
  WorkPool pool(jobs, interrupted);
  const auto live = [&](std::int64_t number) -> Status {
    const std::size_t way = static_cast<std::size_t>(number) / count, life = static_cast<std::size_t>(number) % count;
    auto lived = LessonLife::begin(registry, lesson, begun, static_cast<int>(life), interrupted);
    if (!lived) return lived.error();
    lived->values() = values;
    if (const Status s = lived->act(lives.ways[way].first); !s) return s;
    lived->run(lives.after);
    results[way][life] = lived->valueOf(lives.of);
    return Done{};
  };
  if (const Status s = pool.run(static_cast<std::int64_t>(lives.ways.size() * count), live, {}); !s) return s.error();
  if (pool.stopping()) return Error{"It was stopped."};
  return results;
}

}  // namespace surefoot
