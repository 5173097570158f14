// SPDX-License-Identifier: GPL-3.0-or-later
// Colour and marker tell one policy from the other, also one that has no line in the table.
#include "ui/style/policy_look.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/ui/window_setup.h"
#include "ui/style/theme.h"

namespace surefoot {

TEST(PolicyLook, TellsEveryPolicyFromTheOthersAndFromAFall) {
  const Registry registry = fullRegistry();
  std::vector<std::string> names;
  for (const auto& entry : registry.policies) names.push_back(entry.name);
  for (const Theme* theme : {&lightTheme(), &darkTheme()}) {
    std::set<QRgb> colours = {theme->fall.rgb(), theme->accent.rgb(), theme->ink.rgb()};
    std::set<Marker> markers;
    for (const std::string& name : names) {
      const PolicyLook look = policyLook(name, *theme);
      EXPECT_TRUE(colours.insert(look.colour.rgb()).second) << name;
      EXPECT_TRUE(markers.insert(look.marker).second) << name;
    }
  }
}

// Names of both lengths, even and odd, that no policy has.
TEST(PolicyLook, ANameWithoutALineLooksLikeNoneThatHasOne) {
  for (const Theme* theme : {&lightTheme(), &darkTheme()})
    for (const char* other : {"no policy has it", "nor does one have this"}) {
      const PolicyLook look = policyLook(other, *theme);
      for (const char* known : {"greedy", "epsilon-greedy", "trl", "softmax"}) {
        EXPECT_NE(look.colour, policyLook(known, *theme).colour) << other << " " << known;
        EXPECT_NE(look.marker, policyLook(known, *theme).marker) << other << " " << known;
      }
      EXPECT_NE(look.colour, theme->fall);
    }
  EXPECT_NE(policyLook("even", lightTheme()).marker, policyLook("odd", lightTheme()).marker);
}

TEST(PolicyLook, ANameWithoutALineKeepsItsLook) {
  EXPECT_EQ(policyLook("mellowmax", lightTheme()).marker, policyLook("mellowmax", darkTheme()).marker);
  EXPECT_EQ(policyLook("", lightTheme()).marker, policyLook("greedy", lightTheme()).marker);
}

}  // namespace surefoot
