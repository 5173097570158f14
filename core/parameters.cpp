// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/basics/expects.h"
#include "core/text/number_text.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

std::string allowedValues(const Parameter& p) {
  switch (p.kind) {
    case Kind::Choice:
      return "one of " + joinWords(p.choices, "or");
    case Kind::Integer:
      return fmt::format("a whole number from {} to {}", boundText(p.low), boundText(p.high));
    case Kind::Real:
      break;
  }
  return fmt::format("a number from {} to {}", boundText(p.low), boundText(p.high));
}

std::string formatValue(const Parameter& p, double value) {
  if (p.kind != Kind::Choice) return fmt::format("{}", value);
  const auto index = static_cast<std::size_t>(value);
  return index < p.choices.size() ? p.choices[index] : fmt::format("{}", value);
}

Result<double> checkValue(const Parameter& p, double value) {
  const bool whole = p.kind == Kind::Real || value == std::floor(value);
  if (std::isfinite(value) && whole && value >= p.low && value <= p.high) return value;
  return Error{fmt::format("{}: {} is not allowed; it takes {}.", p.key, value, allowedValues(p))};
}

Result<double> parseValue(const Parameter& p, std::string_view text) {
  if (p.kind == Kind::Choice) {
    const auto found = std::find(p.choices.begin(), p.choices.end(), text);
    if (found != p.choices.end()) return static_cast<double>(found - p.choices.begin());
    return Error{fmt::format("{}: \"{}\" is not allowed; it takes {}.", p.key, shortened(text), allowedValues(p))};
  }
  const NumberText number = readNumberText(text, p.unit);
  if (number.good) return checkValue(p, number.value);
  const std::string why = number.readings.empty() ? "is not allowed" : readingsText(number);
  return Error{fmt::format("{}: \"{}\" {}; it takes {}.", p.key, shortened(text), why, allowedValues(p))};
}

void Fields::real(double& member, Parameter parameter) {
  parameter.kind = Kind::Real;
  add({std::move(parameter), [&member] { return member; }, [&member](double value) { member = value; }});
}

void Fields::integer(int& member, Parameter parameter) {
  parameter.kind = Kind::Integer;
  add({std::move(parameter), [&member] { return static_cast<double>(member); },
       [&member](double value) { member = static_cast<int>(value); }});
}

void Fields::add(Field field) {
  Parameter& parameter = field.parameter;
  parameter.key = prefix_ + parameter.key;
  if (!parameter.needs.empty()) parameter.needs = prefix_ + parameter.needs;
  for (std::string* text : {&parameter.title, &parameter.label}) {
    if (title_.empty() || text->empty()) continue;
    (*text)[0] = static_cast<char>(std::tolower(static_cast<unsigned char>((*text)[0])));
    *text = title_ + " " + *text;
  }
  if (parameter.sliderLow == parameter.sliderHigh) {
    parameter.sliderLow = parameter.low;
    parameter.sliderHigh = parameter.high;
  }
  parameter.fallback = field.get();
  fields_.push_back(std::move(field));
}

void Fields::under(const std::string& prefix, const std::string& title, const std::function<void(Fields&)>& declare) {
  const std::string outerPrefix = std::exchange(prefix_, prefix), outerTitle = std::exchange(title_, title);
  declare(*this);
  prefix_ = outerPrefix;
  title_ = outerTitle;
}

void Fields::setOrder(std::string_view key, int order) {
  for (Field& field : fields_)
    if (field.parameter.key == key) field.parameter.order = order;
}

void Fields::setPlace(std::string_view key, Group group, int order) {
  setOrder(key, order);
  for (Field& field : fields_)
    if (field.parameter.key == key) field.parameter.group = group;
}

void Fields::setNeeds(std::string_view prefix, const std::string& choice) {
  for (Field& field : fields_)
    if (field.parameter.key.starts_with(prefix)) field.parameter.needs = choice;
}

void Parameters::add(const Fields& fields) {
  for (const Fields::Field& field : fields.all())
    if (!find(field.parameter.key)) entries_.push_back({field.parameter, field.get(), field.get()});
}

void Parameters::setUsual() {
  for (Entry& e : entries_) e.usual = e.value;
}

const Parameters::Entry* Parameters::find(std::string_view key) const {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.parameter.key == key; });
  return found == entries_.end() ? nullptr : &*found;
}

Parameters::Entry* Parameters::entry(std::string_view key) {
  return const_cast<Entry*>(static_cast<const Parameters*>(this)->find(key));
}

double Parameters::get(std::string_view key) const {
  const Entry* entry = find(key);
  expects(entry, "a key that a component declares");
  return entry->value;
}

const Parameters::Entry* Parameters::idleBecauseOf(const Parameter& parameter) const {
  const Entry* choice = find(parameter.needs);
  if (!choice) return nullptr;
  const auto& wanted = parameter.needsOne;
  const std::string now = formatValue(choice->parameter, choice->value);
  const bool idle =
      wanted.empty() ? choice->value == 0.0 : std::find(wanted.begin(), wanted.end(), now) == wanted.end();
  return idle ? choice : idleBecauseOf(choice->parameter);
}

Error Parameters::unknown(std::string_view key) const {
  std::vector<std::string> keys;
  for (const Entry& e : entries_) keys.push_back(e.parameter.key);
  const std::string near = nearestWord(key, keys);
  return Error{fmt::format("{}: there is no such parameter{}; `surefoot list` names them all.", shortened(key),
                           near.empty() ? "" : ", did you mean " + near)};
}

Status Parameters::set(std::string_view key, std::string_view text) {
  Entry* found = entry(key);
  if (!found) return unknown(key);
  const Result<double> value = parseValue(found->parameter, text);
  if (!value) return value.error();
  found->value = *value;
  return Done{};
}

Status Parameters::set(std::string_view key, double value) {
  Entry* found = entry(key);
  if (!found) return unknown(key);
  const Result<double> checked = checkValue(found->parameter, value);
  if (!checked) return checked.error();
  found->value = value;
  return Done{};
}

void Parameters::apply(const Fields& fields) const {
  for (const Fields::Field& field : fields.all())
    if (const Entry* entry = find(field.parameter.key)) field.set(entry->value);
}

void Parameters::add(Configurable& component, const std::string& prefix) {
  Fields fields(prefix);
  component.declare(fields);
  add(fields);
}

void Parameters::applyTo(Configurable& component, const std::string& prefix) const {
  Fields fields(prefix);
  component.declare(fields);
  apply(fields);
}

}  // namespace surefoot
