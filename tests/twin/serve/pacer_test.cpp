// SPDX-License-Identifier: MIT
#include "twin/serve/pacer.hpp"

#include <gtest/gtest.h>

namespace sensotwin::twin {
namespace {

TEST(Pacer, MakesATickEvery15MillisecondsOfRealTime) {
  Pacer pacer(1.0, 100.0);
  EXPECT_DOUBLE_EQ(pacer.wait_s(100.0, false), 0.0);
  pacer.tick(100.0);
  EXPECT_NEAR(pacer.wait_s(100.0, false), 0.015, 1e-12);
  EXPECT_NEAR(pacer.wait_s(100.010, false), 0.005, 1e-12);
  EXPECT_DOUBLE_EQ(pacer.wait_s(100.016, false), 0.0);
}

TEST(Pacer, DividesTheWaitByItsFactor) {
  Pacer pacer(10.0, 0.0);
  pacer.tick(0.0);
  EXPECT_NEAR(pacer.wait_s(0.0, false), 0.0015, 1e-12);
}

TEST(Pacer, CatchesUpAHiccupSoThatNoTimeIsLost) {
  Pacer pacer(1.0, 0.0);
  pacer.tick(0.0);
  pacer.tick(0.040);  // due at 0.015
  EXPECT_DOUBLE_EQ(pacer.wait_s(0.040, false), 0.0);
  pacer.tick(0.040);
  EXPECT_NEAR(pacer.wait_s(0.040, false), 0.005, 1e-12);
  EXPECT_DOUBLE_EQ(pacer.given_up_s(), 0.0);
}

TEST(Pacer, GivesUpALongStandstillInsteadOfRunningAfterIt) {
  Pacer pacer(1.0, 0.0);
  pacer.tick(0.0);
  pacer.tick(5.0);  // due at 0.015
  EXPECT_NEAR(pacer.wait_s(5.0, false), 0.015, 1e-12);
  EXPECT_NEAR(pacer.given_up_s(), 4.985, 1e-12);
}

TEST(Pacer, TellsTheFactorItAchievesWhenTheMachineIsTooSlow) {
  Pacer pacer(100.0, 0.0);
  for (int i = 0; i <= 1000; ++i) {
    pacer.tick(i * 0.001);  // a tick of 15 ms each millisecond
  }
  EXPECT_NEAR(pacer.achieved(), 15.0, 0.1);
}

TEST(Pacer, WithoutAFactorFollowsAClientThatReadsAndKeepsRealTimeForOneThatDoesNot) {
  Pacer pacer(std::nullopt, 0.0);
  pacer.tick(0.0);
  EXPECT_NEAR(pacer.wait_s(0.0, true), 0.015 / Pacer::kFastestFactor, 1e-12);
  EXPECT_NEAR(pacer.wait_s(0.0, false), 0.015, 1e-12);
  EXPECT_DOUBLE_EQ(pacer.wait_s(0.015, false), 0.0);
}

}  // namespace
}  // namespace sensotwin::twin
