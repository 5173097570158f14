// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/signals/strips.h"

#include <QObject>
#include <QSettings>
#include <QStringList>
#include <algorithm>

#include "core/signals/strides.h"
#include "ui/language/from_core.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

bool isTerm(const Signal& s) {
  return s.group == "reward" && s.key != "reward";
}

QString settingOf(const std::string& environment) {
  const std::string name = environment.substr(0, environment.find('@'));  // of a robot from a file, without its hash
  return QStringLiteral("signals/") + QString::fromStdString(name);
}

StripLook lookOf(const std::vector<std::size_t>& places, const std::vector<Signal>& signals) {
  const auto all = [&](auto&& is) {
    return std::all_of(places.begin(), places.end(), [&](std::size_t at) { return is(signals[at]); });
  };
  if (all([](const Signal& s) { return s.kind == Signal::Kind::OnOff; })) return StripLook::OnOff;
  if (all(isTerm)) return StripLook::Stacked;
  if (all([](const Signal& s) { return s.key == "td_error" || s.key == "reward"; })) return StripLook::Bars;
  if (all([](const Signal& s) { return s.group == "action" || s.unit == "V"; })) return StripLook::Steps;
  if (places.size() == 1 && signals[places[0]].unit == "W") return StripLook::Filled;
  return StripLook::Lines;
}

}  // namespace

StripSignals signalsIn(const Strip& strip, const std::vector<Signal>& signals) {
  StripSignals in;
  for (const std::string& key : strip)
    if (const std::size_t at = signalAt(signals, key); at < signals.size()) in.places.push_back(at);
  in.look = lookOf(in.places, signals);
  return in;
}

const std::vector<double>* columnLike(const SignalTable& of, const SignalTable& like, std::size_t place) {
  return &of == &like ? &of.columns()[place] : of.column(like.signals()[place].key);
}

std::optional<std::size_t> rowAt(const SignalTable& table, double time) {
  if (table.rows() == 0) return std::nullopt;
  const std::vector<double>& times = table.columns()[0];
  const double slack = 0.5 * table.stepTime();
  const auto at = std::lower_bound(times.begin(), times.end(), time - slack);
  if (at == times.end() || *at > time + slack) return std::nullopt;
  return static_cast<std::size_t>(at - times.begin());
}

std::vector<Strip> usualStrips(const std::vector<Signal>& signals) {
  constexpr std::size_t kMostStates = 4, kFewStates = 2, kMostActions = 3;
  std::vector<Strip> strips;
  std::vector<std::string> states, actions, power, energy, feet, contacts, terms;
  for (const Signal& s : signals) {
    if (s.group == "state") states.push_back(s.key);
    if (s.group == "action" && s.key != "action") actions.push_back(s.key);
    if (s.group == "motors" && s.unit == "W") power.push_back(s.key);
    if (s.group == "measures" && s.unit == "J") energy.push_back(s.key);
    if (s.group == "contacts") (footOf(s) == Foot::None ? contacts : feet).push_back(s.key);
    if (isTerm(s) && !s.key.ends_with("_fall")) terms.push_back(s.key);
  }
  if (states.size() > kMostStates) states.resize(kFewStates);
  if (actions.size() > kMostActions) actions.resize(kMostActions);
  for (const auto* group : {&states, &actions})
    for (const std::string& key : *group) strips.push_back({key});
  if (!power.empty()) strips.push_back({power.back()});  // that of all motors stands behind theirs
  if (!energy.empty()) strips.push_back({energy[0]});
  if (!feet.empty())
    strips.push_back(feet);
  else if (!contacts.empty())
    strips.push_back(contacts);
  if (terms.size() > 1)
    strips.push_back(terms);
  else
    strips.push_back({"reward"});
  for (const char* key : {"risk", "td_error", "value"})
    if (signalAt(signals, key) < signals.size()) strips.push_back({key});
  return strips;
}

QString titleOf(const StripSignals& strip, const std::vector<Signal>& signals) {
  if (strip.places.empty()) return {};
  if (strip.places.size() == 1) {
    const Signal& s = signals[strip.places[0]];
    QString title = fromCore(s.title);
    title[0] = title[0].toUpper();
    constexpr int kLong = 16;  // [letters]: there is no room for the symbol, too
    return s.symbol.empty() || title.size() > kLong ? title : title + ' ' + toText(s.symbol);
  }
  if (strip.look == StripLook::Stacked) return QObject::tr("Reward");
  if (strip.look == StripLook::OnOff) {
    const bool feet = std::all_of(strip.places.begin(), strip.places.end(),
                                  [&](std::size_t at) { return footOf(signals[at]) != Foot::None; });
    return feet ? QObject::tr("Feet") : QObject::tr("On and off");
  }
  QStringList titles;
  for (const std::size_t at : strip.places) titles << fromCore(signals[at].title);
  titles[0][0] = titles[0][0].toUpper();
  return titles.join(QStringLiteral(", "));
}

QString unitOf(const StripSignals& strip, const std::vector<Signal>& signals) {
  if (strip.places.empty()) return {};
  const std::string& unit = signals[strip.places[0]].unit;
  for (const std::size_t at : strip.places)
    if (signals[at].unit != unit) return {};
  return toText(unit);
}

QString nameIn(const StripSignals& strip, const Signal& signal) {
  constexpr std::string_view kReward = "reward: ", kTails[] = {" on the floor", " touches"};
  std::string name = signal.title;
  if (strip.look == StripLook::Stacked && name.starts_with(kReward)) name.erase(0, kReward.size());
  if (strip.look == StripLook::OnOff)
    for (const std::string_view tail : kTails)
      if (name.ends_with(tail)) name.resize(name.size() - tail.size());
  return fromCore(name);
}

std::vector<Strip> chosenStrips(const std::string& environment, const std::vector<Signal>& signals) {
  std::vector<Strip> strips = fromSettings(QSettings().value(settingOf(environment)).toString());
  return strips.empty() ? usualStrips(signals) : strips;
}

void keepStrips(const std::string& environment, const std::vector<Strip>& strips) {
  if (strips.empty()) return QSettings().remove(settingOf(environment));
  QSettings().setValue(settingOf(environment), toSettings(strips));
}

QString toSettings(const std::vector<Strip>& strips) {
  QStringList texts;
  for (const Strip& strip : strips) {
    QStringList keys;
    for (const std::string& key : strip) keys << toText(key);
    texts << keys.join('+');
  }
  return texts.join(',');
}

std::vector<Strip> fromSettings(const QString& text) {
  std::vector<Strip> strips;
  for (const QString& part : text.split(',', Qt::SkipEmptyParts)) {
    Strip strip;
    for (const QString& key : part.split('+', Qt::SkipEmptyParts)) strip.push_back(key.toStdString());
    if (!strip.empty()) strips.push_back(std::move(strip));
  }
  return strips;
}

}  // namespace surefoot
