// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program.h"

namespace surefoot {

TEST(List, JsonHasSevenArraysOfNamedObjects) {
  const Finished run = surefoot("list --json");
  ASSERT_EQ(run.code, 0);
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json.size(), 7u);
  for (const char* key : {"environments", "features", "agents", "policies", "presets", "scenarios", "parameters"}) {
    ASSERT_TRUE(json.contains(key)) << key;
    EXPECT_FALSE(json[key].empty()) << key;
    for (const auto& entry : json[key]) EXPECT_TRUE(entry.at("name").is_string());
  }
  for (const auto& parameter : json["parameters"])
    for (const char* key : {"symbol", "unit", "range", "default", "help", "origin"})
      EXPECT_TRUE(parameter.contains(key));
}

TEST(List, TextNamesEveryPolicyAndParameter) {
  const Finished run = surefoot("list");
  EXPECT_EQ(run.code, 0);
  for (const char* word :
       {"epsilon-greedy", "softmax", "trl", "policy.temperature", "environment.damping", "features.pole_angle"})
    EXPECT_NE(run.out.find(word), std::string::npos) << word;
}

}  // namespace surefoot
