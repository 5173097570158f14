// SPDX-License-Identifier: GPL-3.0-or-later
// How an experiment comes to its plan: read and tried out on a thread of its own, then taken over at once.
#include <algorithm>
#include <thread>

#include "core/files/read_file.h"
#include "core/plans/plan_time.h"
#include "ui/experiment/experiment.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

constexpr std::chrono::milliseconds kOpeningPatience(80);  // open() waits this long before it returns

bool isStore(const std::string& path) {
  const auto head = readHead(path, 15);
  return head && *head == "SQLite format 3";
}

}  // namespace

Result<Experiment::Opened> Experiment::prepareText(const std::string& text, const std::string& path,
                                                   const std::atomic<bool>& interrupted) const {
  PlanChanges nothing;
  nothing.interrupted = &interrupted;
  auto recipe = parseRecipe(registry_, text, path.empty() ? "plan" : path, nothing);
  if (!recipe) return recipe.error();
  auto stored = planToStore(registry_, recipe->plan);
  if (!stored) return stored.error();
  Opened opened{.text = text, .path = path, .plan = {}, .stored = {}, .figures = {}, .claims = {}};
  opened.figures = standardFigures(*stored);
  for (FigureSpec& standard : opened.figures)  // results and files are told apart by these names
    while (std::any_of(recipe->figures.begin(), recipe->figures.end(),
                       [&](const FigureSpec& own) { return own.name == standard.name; }))
      standard.name += "-standard";
  opened.figures.insert(opened.figures.end(), recipe->figures.begin(), recipe->figures.end());
  opened.claims = std::move(recipe->claims);
  opened.plan = std::move(recipe->plan);
  opened.stored = std::move(*stored);
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (const auto file = parsePlanFile(text, path)) opened.minutes = minutesFor(registry_, *file, threads);
  return opened;
}

Result<Experiment::Opened> Experiment::prepareStore(const Store& store) const {
  auto view = viewOf(registry_, store);
  if (!view) return view.error();
  const auto lives = store.lives();
  if (!lives) return lives.error();
  Opened opened{
      .text = {}, .path = store.path(), .plan = {}, .stored = view->findings.plan, .figures = {}, .claims = {}};
  if (auto plan = planFromStore(registry_, store))
    opened.plan = std::move(*plan);
  else
    opened.whyNot = plan.error().message;
  opened.figures = standardFigures(opened.stored);
  opened.lives = static_cast<int>(lives->size());
  for (const StoredLife& life : *lives) opened.falls += life.falls;
  opened.note = store.note();
  opened.view = std::make_shared<const LabView>(std::move(*view));
  return opened;
}

Status Experiment::open(const std::string& path) {
  return begin([this, path](const std::atomic<bool>& interrupted) -> Result<Opened> {
    if (isStore(path)) {
      const auto store = Store::open(path, &interrupted);
      return store ? prepareStore(*store) : store.error();
    }
    const auto text = readText(path);
    if (!text) return text.error();
    return prepareText(*text, path, interrupted);
  });
}

Status Experiment::setText(const std::string& text) {
  return begin([this, text, path = path_](const std::atomic<bool>& interrupted) {
    return prepareText(text, path, interrupted);
  });
}

Status Experiment::begin(Prepare prepare) {
  struct Asked {
    std::optional<Result<Opened>> made;
    Status status = Done{};
    bool waiting = true;  // the caller
  };
  auto asked = std::make_shared<Asked>();
  opening_.start([asked, prepare = std::move(prepare)](
                     const std::atomic<bool>& interrupted) { asked->made.emplace(prepare(interrupted)); },
                 [this, asked] {
                   if (*asked->made)
                     adopt(std::move(**asked->made));
                   else if (asked->waiting)
                     asked->status = asked->made->error();
                   else
                     Q_EMIT failed(toText(asked->made->error().message));
                 },
                 kOpeningPatience);
  asked->waiting = false;
  return asked->status;
}

void Experiment::adopt(Opened opened) {
  reset();
  takePlan(opened);
  if (opened.view) {
    takeView(opened);
    setState(livesDone_ >= livesPlanned() ? State::Complete : State::Paused);
  }
  Q_EMIT planChanged();
  if (view_)
    results_.show(view_);
  else
    Q_EMIT resultsChanged();
  Q_EMIT progressed();
  if (!opened.note.empty()) Q_EMIT failed(toText(opened.note));
}

void Experiment::takePlan(Opened& opened) {
  text_ = std::move(opened.text);
  path_ = std::move(opened.path);
  title_ = opened.stored.title;
  plan_ = std::move(opened.plan);
  stored_ = std::move(opened.stored);
  figures_ = std::move(opened.figures);
  minutes_ = opened.minutes;
  whyNot_ = std::move(opened.whyNot);
  results_.begin(std::move(opened.claims), stored_);
}

void Experiment::takeView(Opened& opened) {
  view_ = std::move(opened.view);
  storePath_ = path_;
  livesDone_ = opened.lives;
  falls_ = opened.falls;
  share_ = livesPlanned() > 0 ? static_cast<double>(livesDone_) / livesPlanned() : 0;
}

}  // namespace surefoot
