// SPDX-License-Identifier: MIT
// The mainboard of a Roomba 400: SCI.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/robot/drivers/roomba_transcripts.hpp"
#include "tests/twin/devices/roomba_bench.hpp"

namespace sensotwin::twin {
namespace {

using robot::Bytes;
using robot::oi::Mode;
using ::testing::IsEmpty;
using ::testing::SizeIs;
namespace script = robot::transcripts;

class Roomba400Board : public RoombaBoard {
 protected:
  void SetUp() override {
    roomba_ = EmulatedRoomba{
        {.body = {.kind = world::RoombaKind::kRoomba400, .wheel_base_m = 0.258}, .speed_step_mps = 0.0}};
  }
};

TEST_F(Roomba400Board, AnswersTheDriversTranscripts) {
  EXPECT_EQ(say(script::kSciStart.to_robot), script::kSciStart.from_robot);
  EXPECT_EQ(roomba_.mode(), Mode::kSafe);
  EXPECT_EQ(say(script::kSciPoll.to_robot), script::kSciPoll.from_robot);
  say(script::kSciStraight.to_robot);
  EXPECT_DOUBLE_EQ(out_.wheel_left_mps, 0.2);
  EXPECT_DOUBLE_EQ(out_.wheel_right_mps, 0.2);
}

TEST_F(Roomba400Board, LeavesPassiveByControlOnlyAndReachesFullOverSafe) {
  say({128, 131});
  EXPECT_EQ(roomba_.mode(), Mode::kPassive);
  say({132});
  EXPECT_EQ(roomba_.mode(), Mode::kPassive);
  say({130});
  EXPECT_EQ(roomba_.mode(), Mode::kSafe);
  say({132});
  EXPECT_EQ(roomba_.mode(), Mode::kFull);
  say({131});
  EXPECT_EQ(roomba_.mode(), Mode::kSafe);
}

TEST_F(Roomba400Board, KnowsNeitherSinglePacketsNorStreamsNorDriveDirect) {
  EXPECT_THAT(say({128, 130, 142, 35, 148, 1, 7}), IsEmpty());
  say({145, 0, 100, 0, 100});
  EXPECT_EQ(out_.wheel_left_mps, 0.0);
}

TEST_F(Roomba400Board, TellsAngleAsHalfTheDifferenceOfItsWheelsInMillimetres) {
  FreeWheels wheels;
  say({128, 130, 137, 0, 100, 0, 1});  // counter-clockwise at 100 mm/s
  int angle_mm = 0;
  for (int i = 0; i < 67; ++i) {  // one second
    wheels.roll(out_, in_);
    const Bytes heard = say({142, 2});
    ASSERT_THAT(heard, SizeIs(6));
    angle_mm += robot::s16_from_be(heard[4], heard[5]);
  }
  EXPECT_NEAR(angle_mm, 100, 2);
}

}  // namespace
}  // namespace sensotwin::twin
