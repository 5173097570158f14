// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/rival.h"

#include <QDialog>
#include <QVBoxLayout>
#include <limits>

#include "core/saved/q_file.h"
#include "ui/language/from_core.h"
#include "ui/live/compare_strip.h"
#include "ui/live/form/parameter_form.h"
#include "ui/live/world/world_view.h"
#include "ui/style/symbol_text.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {

constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::min();

/// A policy other than the first's.
std::string otherPolicy(const std::string& policy) {
  return policy == "softmax" ? "epsilon-greedy" : "softmax";
}

std::map<std::string, double> valuesOf(const Parameters& parameters) {
  std::map<std::string, double> values;
  for (const auto& entry : parameters.all()) values[entry.parameter.key] = entry.value;
  return values;
}

}  // namespace

Rival::Rival(RunningLife& first, QWidget* parent)
    : QWidget(parent),
      first_(first),
      policy_(otherPolicy(first.configuration().names.policy)),
      agent_(first.configuration().names.agent),
      firstHad_(valuesOf(first.configuration().parameters)),
      session_(std::make_unique<Session>(first.registry(), configurationLikeFirst(), false)),
      lineage_(first.lineage()),
      ranBeside_(lineage_),
      keptBeside_(lineage_) {
  connect(&reading_, &Background::failed, this, &Rival::refused);
  world_ = new WorldView(session_->life(), session_->looking(), this);
  world_->setAccessibleName(tr("World of the second"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(world_, 1);
  strip_ = new CompareStrip(*this);
  connect(&first_, &RunningLife::stateChanged, this, &Rival::follow);
  connect(&first_, &RunningLife::configurationChanged, this, &Rival::followParameters);
  connect(&first_, &RunningLife::replaced, this, &Rival::firstReplaced);
  connect(&session_->newLives(), &NewLives::refused, this, [this](const QString& why) {  // the life goes on as it was
    begin_ = began_;
    noted_ = false;
    Q_EMIT changed();
    Q_EMIT refused(why);
  });
  connect(&session_->life(), &RunningLife::replaced, this, &Rival::secondReplaced);
  connect(&session_->editing(), &Editing::needsNewTable, this, &Rival::askForNewTable);
  connect(&session_->life(), &RunningLife::configurationChanged, this, &Rival::changed);
  connect(&session_->history(), &History::lifeKept, this, [this] {
    if (auto kept = session_->history().lastKept()) beside_[keptBeside_] = std::move(kept);
  });
  noteBeginning(0);
  follow();
}

Rival::~Rival() {
  delete strip_;
}

CompareStrip& Rival::strip() {
  return *strip_;
}

Configuration Rival::configurationLikeFirst() {
  Names names = first_.configuration().names;
  names.agent = agent_;
  names.policy = policy_;
  auto like = configurationUnder(first_.registry(), first_.configuration(), names);
  Configuration own = like ? std::move(*like) : first_.configuration();
  for (const auto& [key, value] : own_)
    if (own.parameters.find(key)) static_cast<void>(static_cast<bool>(own.parameters.set(key, value)));
  own.start.reset();
  own.beganWith = {};
  if (begin_.start == Start::File && begin_.file) beginWith(own, begin_.file);
  if (begin_.start == Start::Same && fits(own)) {
    own.start = first_.began().start;
    own.beganWith = first_.began().beganWith;
  }
  return own;
}

/// Whether the second can begin like the first: it has the same tables, and the first's beginning is still known.
bool Rival::fits(const Configuration& own) const {
  const Configuration& began = first_.began();
  if (!began.start || own.names.agent != began.names.agent || own.names.features != began.names.features) return false;
  for (const auto& entry : began.parameters.all()) {
    const Parameters::Entry* mine = own.parameters.find(entry.parameter.key);
    if (entry.parameter.when == When::NewTable && (!mine || mine->value != entry.value)) return false;
  }
  return true;
}

void Rival::startAgain() {
  Configuration own = configurationLikeFirst();
  const bool empty = !own.start;
  const QString began = first_.beginning();
  if (const Status s = session_->newLives().begin(std::move(own)); !s) {
    begin_ = began_;
    return Q_EMIT refused(toText(s.error().message));
  }
  follow();
  if (begin_.start == Start::Same && empty && !began.isEmpty())
    Q_EMIT told(tr("The second cannot have the same start (%1): its tables differ. It begins empty.").arg(began));
}

/// The second begins anew with the first. If undo brings back a life of the first, the second's comes back, too.
void Rival::firstReplaced() {
  if (resting_) {
    startsLate_ = true;
    return;
  }
  const std::uint64_t before = std::exchange(lineage_, first_.lineage());
  const auto beside = beside_.find(lineage_);
  if (before == lineage_ || beside == beside_.end() || !beside->second->aside) {
    noteBeginning(0);
    noted_ = true;  // both begin now, although the second's tables may take a moment
    return startAgain();
  }
  std::shared_ptr<KeptLife> kept = beside->second;
  beside_.erase(beside);
  session_->history().exchange(kept);
  beside_[keptBeside_] = std::move(kept);
  agent_ = session_->life().configuration().names.agent;
  policy_ = session_->life().configuration().names.policy;
  follow();
  Q_EMIT changed();
}

void Rival::secondReplaced() {
  if (const auto until = std::exchange(begin_.until, std::nullopt)) {  // large tables take their time to be made
    if (const Status s = session_->life().goOn(*until); !s) Q_EMIT refused(toText(s.error().message));
  } else if (!noted_) {
    noteBeginning(session_->life().progress().steps);
  }
  noted_ = false;
  keptBeside_ = std::exchange(ranBeside_, lineage_);
  began_ = begin_;
}

void Rival::noteBeginning(std::int64_t own) {
  later_ = std::make_shared<std::atomic<std::int64_t>>(kUnknown);
  first_.visit([to = later_, own](const Life& life) { *to = life.steps() - own; });
}

std::optional<double> Rival::later() const {
  if (!later_ || *later_ == kUnknown) return std::nullopt;
  return static_cast<double>(*later_) * first_.task().stepTime.value_or(1.0);
}

void Rival::follow() {
  if (session_->life().turbo() != first_.turbo()) session_->life().setTurbo(first_.turbo());
  if (session_->life().pace() != first_.pace()) session_->life().setPace(first_.pace());
  const bool runs = first_.running() && !resting_;
  if (session_->life().running() != runs) session_->life().setRunning(runs);
}

void Rival::followParameters() {
  if (resting_) return;
  const auto had = std::exchange(firstHad_, valuesOf(first_.configuration().parameters));
  for (const auto& entry : first_.configuration().parameters.all()) {
    const std::string& key = entry.parameter.key;
    const Parameters::Entry* own = session_->life().configuration().parameters.find(key);
    const auto before = had.find(key);
    const bool was = before != had.end() && own && own->value == before->second;
    if (was && own->value != entry.value && entry.parameter.when != When::NewTable)
      static_cast<void>(static_cast<bool>(session_->editing().setParameter(key, entry.value)));
  }
}

/// Chooses and begins; asks first if the second has learned anything.
void Rival::askToStartAgain(const QString& why, std::function<void()> choose) {
  const auto goOn = [this, choose = std::move(choose)] {
    choose();
    startAgain();
    Q_EMIT changed();
  };
  if (!session_->life().learned()) return goOn();
  Q_EMIT changed();  // nothing changes until the question is answered
  Q_EMIT newTableAsked(tr("%1: the second starts again from the beginning, and what it learned in %2 is given up.")
                           .arg(why, episodesText(session_->life().progress().episodes)),
                       goOn);
}

void Rival::choose(const std::string& agent, const std::string& policy) {
  if (agent == agent_) {
    policy_ = policy;
    session_->editing().setPolicy(policy_);
    Q_EMIT changed();
  } else {
    askToStartAgain(tr("Another learning rule needs a new table"), [this, agent, policy] {
      agent_ = agent;
      policy_ = policy;
    });
  }
}

void Rival::setStart(Start start) {
  askToStartAgain(tr("Another start"), [this, start] { begin_.start = start; });
}

void Rival::startIn(std::shared_ptr<const TensorFile> file, EpisodeInputs until, const std::string& agent,
                    const std::string& policy, std::function<void()> begin) {
  askToStartAgain(tr("What if"),
                  [this, file = std::move(file), until = std::move(until), agent, policy, begin = std::move(begin)] {
                    begin();
                    noteBeginning(0);  // the first's moment, not that in which the second's tables are made
                    agent_ = agent;
                    policy_ = policy;
                    begin_ = {Start::File, file, until};
                  });
}

void Rival::startWith(const QString& path) {
  const auto read = std::make_shared<Result<std::shared_ptr<const TensorFile>>>(Error{"cancelled"});
  reading_.start([read, name = path.toStdString()](const std::atomic<bool>&) { *read = readQFile(name); },
                 [this, read] {
                   if (!*read) return Q_EMIT refused(toText(read->error().message));
                   askToStartAgain(tr("Another start"), [this, file = **read] { begin_ = {Start::File, file}; });
                 });
}

QString Rival::ownParameters() const {
  QStringList list;
  for (const auto& entry : session_->life().configuration().parameters.all()) {
    const Parameters::Entry* firsts = first_.configuration().parameters.find(entry.parameter.key);
    if (firsts && firsts->value != entry.value)
      list << fromCore(entry.parameter.title) + ' ' + valueText(entry.parameter, entry.value);
  }
  constexpr int kMost = 4;
  if (list.size() > kMost) list = list.mid(0, kMost) << QStringLiteral("…");
  return list.join(QStringLiteral(", "));
}

void Rival::showParameters() {
  if (!parameters_) {
    parameters_ = new QDialog(this);
    parameters_->setWindowTitle(tr("Parameters of the second"));
    auto* column = new QVBoxLayout(parameters_);
    column->setContentsMargins(0, 0, 0, 0);
    auto* form = new ParameterForm(session_->life(), session_->editing(), session_->history());
    column->addWidget(form);
    connect(form, &ParameterForm::refused, this, &Rival::refused);
    connect(&session_->life(), &RunningLife::configurationChanged, parameters_, [this] {  // keep differences
      own_.clear();
      for (const auto& entry : session_->life().configuration().parameters.all()) {
        const Parameters::Entry* firsts = first_.configuration().parameters.find(entry.parameter.key);
        if (firsts && firsts->value != entry.value) own_[entry.parameter.key] = entry.value;
      }
    });
  }
  parameters_->show();
  parameters_->raise();
}

void Rival::askForNewTable(const QString& key, double value) {
  const auto* entry = session_->life().configuration().parameters.find(key.toStdString());
  Q_EMIT newTableAsked(tr("%1 = %2 needs a new table: the second starts again from the beginning.")
                           .arg(fromCore(entry->parameter.title), valueText(entry->parameter, value)),
                       [this, key = key.toStdString(), value] {
                         own_[key] = value;
                         startAgain();
                       });
}

void Rival::setResting(bool resting) {
  resting_ = resting;
  if (resting) return session_->life().setRunning(false);
  followParameters();
  follow();
  if (std::exchange(startsLate_, false) && lineage_ != first_.lineage()) firstReplaced();
}

}  // namespace surefoot

#include "moc_rival.cpp"
