// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters, declared once. A component keeps its settings in a plain struct and lists each member in `declare`:
//
//   struct SoftmaxSettings {
//     double temperature = 1.0;
//     void declare(Fields& f) { f.real(temperature, {.key = "temperature", .low = 1e-6, .high = 1e6, …}); }
//   };
//
// The member initialiser is the default. Values; used by one thread at a time. Command line, form, file, validation and
// manual are all made from the list.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

/// When a change reaches a life that is running.
enum class When { Now, NextEpisode, NewTable };

/// Under which heading a form shows the parameter.
enum class Group { Policy, Risk, Learning, Rewards, Representation, Model };

enum class Kind { Real, Integer, Choice };

/// A slider for the reward of a fall goes from nothing to where a robot becomes too cautious to learn, and bends.
inline constexpr double kHardestFall = -25'600, kBendOfFalls = 25;

/// The declaration of one parameter: everything but the member it is bound to.
struct Parameter {
  std::string key{};     ///< within its component; with the prefix it is the full key, e.g. "policy.temperature"
  std::string title{};   ///< what a form calls it: "Temperature"
  std::string label{};   ///< what stands beside the control, where the title is too long for that; empty: the title
  std::string symbol{};  ///< "τ"; a dot above is U+0307 behind the letter; may be empty
  std::string unit{};    ///< "N m"; empty for a pure number
  double low = 0.0, high = 1.0;              ///< allowed, both ends included
  double sliderLow = 0.0, sliderHigh = 0.0;  ///< the usual range; equal: low … high
  double sliderBend =
      0.0;  ///< the slider is linear for values up to about this and logarithmic beyond; 0: see the form
  When when = When::Now;
  Group group = Group::Learning;
  std::string help{};    ///< one sentence
  std::string origin{};  ///< where the default comes from: thesis, lab file, calibrated, ours
  Kind kind = Kind::Real;
  std::vector<std::string> choices{};  ///< names of the values 0, 1, … of a choice
  int order = 1;                       ///< 1: always in the form; 2: in a larger window; 3: only when asked for
  std::string needs{};  ///< key of a choice, or of a number; while it is its first, or 0, this has no effect
  std::vector<std::string> needsOne{};  ///< the values of that choice with which it has one; empty: all but the first
  double fallback = 0.0;                ///< the default; filled in from the member
};

/// "any number from 0 to 1", "a whole number from 1 to 64", "one of replacing, accumulating".
std::string allowedValues(const Parameter& parameter);

/// The value as a person writes it: "0.05", "16", "replacing".
std::string formatValue(const Parameter& parameter, double value);

/// Reads a value from text; the error names key, text and what is allowed. NaN and infinity are never allowed.
Result<double> parseValue(const Parameter& parameter, std::string_view text);

/// The same check for a value that is a number already.
Result<double> checkValue(const Parameter& parameter, double value);

/// A number from text, nothing before or behind it, finite; independent of the locale.
Result<double> parseNumber(std::string_view name, std::string_view text);

/// A master seed from text: a whole number from 0 to 2⁶⁴ − 1.
Result<std::uint64_t> parseSeed(std::string_view name, std::string_view text);

/// A list of declarations bound to members. Short-lived: it points into the struct that declared itself.
class Fields {
 public:
  explicit Fields(std::string prefix) : prefix_(std::move(prefix)) {}

  /// A declaration and how its member is read and written. Values of a choice are its index.
  struct Field {
    Parameter parameter;
    std::function<double()> get;
    std::function<void(double)> set;
  };

  void real(double& member, Parameter parameter);
  void integer(int& member, Parameter parameter);
  template <class Enum>
  void choice(Enum& member, Parameter parameter) {
    parameter.kind = Kind::Choice;
    parameter.low = 0;
    parameter.high = static_cast<double>(parameter.choices.size() - 1);
    add({std::move(parameter), [&member] { return static_cast<double>(member); },
         [&member](double value) { member = static_cast<Enum>(static_cast<int>(value)); }});
  }

  /// Declares a part under a prefix of its own, e.g. "positive." with titles that begin with "Q⁺".
  void under(const std::string& prefix, const std::string& title, const std::function<void(Fields&)>& declare);
  /// Moves a parameter declared so far to another place in the form (Parameter::order).
  void setOrder(std::string_view key, int order);
  void setPlace(std::string_view key, Group group, int order);
  /// Parameters declared so far with keys that begin with `prefix` have no effect while `choice` has its first value.
  void setNeeds(std::string_view prefix, const std::string& choice);
  const std::vector<Field>& all() const { return fields_; }

 private:
  void add(Field field);

  std::string prefix_, title_;
  std::vector<Field> fields_;
};

/// A component with parameters. `declare` lists them; setting one through the list changes the component.
class Configurable {
 public:
  virtual ~Configurable() = default;
  virtual void declare(Fields& fields) = 0;
};

/// A complete list of declarations with their values: the part of a configuration that is numbers.
class Parameters {
 public:
  struct Entry {
    Parameter parameter;
    double value;
    double usual;  ///< its value under the names alone, which a preset and a scenario may set
  };

  /// Appends what `fields` declares, with the members' values, unless the key is there already.
  void add(const Fields& fields);
  /// The same with everything that a component declares under a prefix.
  void add(Configurable& component, const std::string& prefix);
  const std::vector<Entry>& all() const { return entries_; }
  const Entry* find(std::string_view key) const;
  double get(std::string_view key) const;  ///< asserts that the key is there
  /// The choice because of which a parameter has no effect now; null: it has one.
  const Entry* idleBecauseOf(const Parameter& parameter) const;

  Status set(std::string_view key, std::string_view text);
  Status set(std::string_view key, double value);

  /// The values now are the usual ones.
  void setUsual();

  /// Copies every value into the member of the same key.
  void apply(const Fields& fields) const;
  /// The same with everything that a component declares under a prefix.
  void applyTo(Configurable& component, const std::string& prefix) const;

 private:
  Entry* entry(std::string_view key);
  Error unknown(std::string_view key) const;
  std::vector<Entry> entries_;
};

}  // namespace surefoot
