// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "tests/app/program.h"

namespace surefoot {

TEST(Probabilities, OfTrlInFull) {
  const Finished run = surefoot("probabilities --q 1,2,3 --policy trl --set policy.threshold=1.5 --json");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["q"], (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(json["policy"], "trl");
  EXPECT_DOUBLE_EQ(json["probabilities"][0], 0.05 * 0.01);
  EXPECT_DOUBLE_EQ(json["probabilities"][1], 0.05 * 0.99 / 2);
  EXPECT_DOUBLE_EQ(json["probabilities"][2], 0.95 + 0.05 * 0.99 / 2);
}

TEST(Probabilities, TakesNegativeAndExtremeValues) {
  const Finished run = surefoot("probabilities --q -5,-1e6,1e6 --policy softmax --set policy.temperature=0.001 --json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(run.out)["probabilities"], (std::vector<double>{0, 0, 1}));
}

TEST(Probabilities, RefusesABadListInOneSentence) {
  expectRefusal("probabilities", 2, {"--q"});
  expectRefusal("probabilities --q ''", 2, {"--q", "empty"});
  expectRefusal("probabilities --q=", 2, {"--q"});
  expectRefusal("probabilities --q 1,,2", 2, {"value 2"});
  expectRefusal("probabilities --q 1,2,", 2, {"value 3"});
  expectRefusal("probabilities --q 1,nan", 2, {"nan"});
  expectRefusal("probabilities --q inf,1", 2, {"inf"});
  expectRefusal("probabilities --q 1e999,1", 2, {"1e999"});
}

TEST(Probabilities, RefusesMoreActionsThanThereMayBe) {
  std::string q = "1";
  for (int i = 1; i < 10'000; ++i) q += ",1";
  expectRefusal("probabilities --q " + q, 2, {"10000", "4096"});
}

TEST(Probabilities, RefusesCautionThatKnowsNoRisk) {
  expectRefusal("probabilities --q 1,2 --policy trl --set policy.risk=filter", 2,
                {"policy.risk = filter", "risk.learn"});
}

TEST(Probabilities, RefusesAParameterOfAnotherPolicy) {
  expectRefusal("probabilities --q 1,2 --policy softmax --set policy.threshold=1", 2, {"policy.threshold", "trl"});
  expectRefusal("probabilities --q 1,2 --policy softmax --set agent.discount=1", 2, {"agent.discount"});
}

}  // namespace surefoot
