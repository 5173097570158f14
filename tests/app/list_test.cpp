// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program.h"

namespace surefoot {

TEST(List, JsonHasNineArraysOfNamedObjects) {
  const Finished run = surefoot("list --json");
  ASSERT_EQ(run.code, 0);
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json.size(), 9u);
  for (const char* key :
       {"environments", "robots", "features", "agents", "policies", "presets", "scenarios", "figures", "parameters"}) {
    ASSERT_TRUE(json.contains(key)) << key;
    EXPECT_FALSE(json[key].empty()) << key;
    for (const auto& entry : json[key]) EXPECT_TRUE(entry.at("name").is_string());
  }
  for (const auto& parameter : json["parameters"])
    for (const char* key : {"symbol", "unit", "range", "default", "help", "origin"})
      EXPECT_TRUE(parameter.contains(key));
}

// What every control of the window says, too: a sentence and a formula for each parameter, and what each name means.
TEST(List, EverythingHasASentenceAndAFormula) {
  const auto json = nlohmann::json::parse(surefoot("list --json").out);
  for (const auto& parameter : json["parameters"])
    for (const char* key : {"help", "formula", "origin", "title"})
      EXPECT_GT(parameter[key].get<std::string>().size(), 2u) << parameter["name"] << " has no " << key;
  for (const char* kind : {"policies", "agents", "features", "environments"})
    for (const auto& entry : json[kind]) {
      ASSERT_TRUE(entry.contains("meaning")) << entry["name"];
      EXPECT_GT(entry["source"].get<std::string>().size(), 2u) << entry["name"];
      EXPECT_TRUE(entry["meaning"].get<std::string>().ends_with('.')) << entry["name"];
    }
  for (const char* kind : {"policies", "agents", "features"})
    for (const auto& entry : json[kind])
      EXPECT_EQ(entry["formula"].get<std::string>().empty(), entry["name"] == "scripted") << entry["name"];
  const std::string text = surefoot("list").out;
  for (const char* words : {"π(a) = exp(Q(s, a)/τ) / Σ_b exp(Q(s, b)/τ)", "thesis, section 4.1", "Q = Q⁺ + Q⁻",
                            "\u22121,000,000 … 1,000,000"})
    EXPECT_NE(text.find(words), std::string::npos) << words;
  EXPECT_EQ(text.find("1e-06 …"), std::string::npos) << "ranges are for people";
}

TEST(List, TextNamesEveryPolicyAndParameter) {
  const Finished run = surefoot("list");
  EXPECT_EQ(run.code, 0);
  for (const char* word :
       {"epsilon-greedy", "softmax", "trl", "policy.temperature", "environment.damping", "features.pole_angle"})
    EXPECT_NE(run.out.find(word), std::string::npos) << word;
}

}  // namespace surefoot
