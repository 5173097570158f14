// SPDX-License-Identifier: GPL-3.0-or-later
// The names that an expression of a robot's file may use, by where it stands.
#pragma once

#include "core/expression/vocabulary.h"
#include "physics/robot/spec/names.h"

namespace surefoot {

class RobotWords : public Vocabulary {
 public:
  enum class Where {
    Parameter,  ///< numbers only: nothing is known yet
    Fixed,      ///< parameters and the constants above
    Start,      ///< the same, and chance
    Moving,     ///< everything
  };

  /// `constants`: how many of them stand above. `actuator`: whose `u` is meant; −1: there is none here.
  RobotWords(RobotNames& names, Where where, int constants, int actuator = -1)
      : names_(names),
        where_(where),
        constants_(constants),
        actuator_(actuator) {}

  Result<Quantity> find(std::string_view name, std::optional<std::string_view> argument) const override;
  std::vector<std::string> names() const override;
  bool chance() const override { return where_ == Where::Start; }

 private:
  Result<Quantity> plain(std::string_view name) const;
  Result<Quantity> partOf(std::string_view name, std::string_view part) const;
  Result<Quantity> ofChild(std::string_view part) const;
  Result<Quantity> ofBody(const RobotNames::Name& body, std::string_view part) const;
  Quantity placed(const Probe& probe) const;

  RobotNames& names_;
  Where where_;
  int constants_, actuator_;
};

/// "x, y, angle, …": what can be measured of such a thing.
std::vector<std::string> attributesOf(NameKind kind);

}  // namespace surefoot
