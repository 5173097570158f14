// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/table.h"

#include <gtest/gtest.h>

#include <set>

#include "core/environments/cliff.h"
#include "core/environments/mountain_car.h"

namespace surefoot {

TEST(Table, GivesEveryStateANumberOfItsOwn) {
  const auto table = Table::create(Cliff().task());
  ASSERT_TRUE(table);
  EXPECT_EQ(table->size(), 48u);
  std::set<Index> seen;
  std::vector<Index> x(1);
  for (double row = 0; row < 4; ++row)
    for (double column = 0; column < 12; ++column) {
      EXPECT_TRUE(table->activeFeatures(std::vector<double>{column, row}, x));
      EXPECT_LT(x[0], 48u);
      seen.insert(x[0]);
    }
  EXPECT_EQ(seen.size(), 48u);
}

TEST(Table, StatesOutsideUseTheEdgeAndSaySo) {
  const auto table = Table::create(Cliff().task());
  std::vector<Index> inside(1), outside(1);
  EXPECT_TRUE(table->activeFeatures(std::vector<double>{11, 3}, inside));
  EXPECT_FALSE(table->activeFeatures(std::vector<double>{99, 4}, outside));
  EXPECT_EQ(inside, outside);
}

TEST(Table, RefusesStatesThatAreNoWholeNumbers) {
  const auto table = Table::create(MountainCar().task());
  ASSERT_FALSE(table);
  EXPECT_NE(table.error().message.find("position"), std::string::npos);
}

}  // namespace surefoot
