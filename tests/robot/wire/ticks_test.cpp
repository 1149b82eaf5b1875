// SPDX-License-Identifier: MIT
#include "robot/wire/ticks.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace sensotwin::robot {
namespace {

TEST(Ticks, CountOnForwardsAcrossTheWrap) {
  EXPECT_EQ(Ticks{2} - Ticks{65534}, 4);
}

TEST(Ticks, CountOnBackwardsAcrossTheWrap) {
  EXPECT_EQ(Ticks{65534} - Ticks{2}, -4);
}

RC_GTEST_PROP(Ticks, GiveBackWhatWasAddedWhileItIsUnderHalfTheRange,
              (std::uint16_t start, std::int16_t step)) {
  RC_ASSERT((Ticks{start} + step) - Ticks{start} == step);
}

}  // namespace
}  // namespace sensotwin::robot
