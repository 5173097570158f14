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
  Table::Active x;
  for (double row = 0; row < 4; ++row)
    for (double column = 0; column < 12; ++column) {
      EXPECT_EQ(table->find(std::vector<double>{column, row}, x), Cover::Inside);
      EXPECT_LT(x.index[0], 48u);
      seen.insert(x.index[0]);
    }
  EXPECT_EQ(seen.size(), 48u);
}

TEST(Table, StatesOutsideUseTheEdgeAndSaySo) {
  const auto table = Table::create(Cliff().task());
  Table::Active inside, outside;
  EXPECT_EQ(table->find(std::vector<double>{11, 3}, inside), Cover::Inside);
  EXPECT_EQ(table->find(std::vector<double>{99, 4}, outside), Cover::Edge);
  EXPECT_EQ(inside.index[0], outside.index[0]);
}

TEST(Table, RefusesStatesThatAreNoWholeNumbers) {
  const auto table = Table::create(MountainCar().task());
  ASSERT_FALSE(table);
  EXPECT_NE(table.error().message.find("position"), std::string::npos);
}

}  // namespace surefoot
