// SPDX-License-Identifier: MIT
#include "robot/mapping/nudges.hpp"

#include <gtest/gtest.h>

namespace sensotwin::robot {
namespace {

TEST(Nudges, MoveTheAimAwayFromTheSideThatTouched) {
  Nudges nudges(0.02);
  EXPECT_FALSE(nudges.any());
  EXPECT_TRUE(nudges.away_from(+1, 0.1));
  EXPECT_LT(nudges.aim_left_m(), 0.02) << "touched on the left: aims more to the right";
  EXPECT_TRUE(nudges.any());
  EXPECT_TRUE(nudges.away_from(-1, 0.2));
  EXPECT_DOUBLE_EQ(nudges.aim_left_m(), 0.02);
}

TEST(Nudges, GoNoFartherAsideThanAllowed) {
  Nudges nudges(0.0, 0.04);
  for (int i = 0; i < 6; ++i) {
    EXPECT_TRUE(nudges.away_from(-1, 0.1 * i));
  }
  EXPECT_DOUBLE_EQ(nudges.aim_left_m(), 0.04);
}

TEST(Nudges, EndAtAHeadOnTouch) {
  Nudges nudges;
  EXPECT_FALSE(nudges.away_from(0, 0.1));
}

TEST(Nudges, EndWhenTheyBringTheRobotNoFarther) {
  Nudges nudges;
  int tries = 0;
  while (nudges.away_from(+1, 0.1) && tries < 100) {
    ++tries;
  }
  EXPECT_EQ(tries, 4) << "the first, which came from somewhere, and three futile ones";
}

TEST(Nudges, EndAfterEightHoweverWellTheyDo) {
  Nudges nudges;
  int tries = 0;
  while (nudges.away_from(+1, 0.05 * tries) && tries < 100) {
    ++tries;
  }
  EXPECT_EQ(tries, 8);
}

}  // namespace
}  // namespace sensotwin::robot
