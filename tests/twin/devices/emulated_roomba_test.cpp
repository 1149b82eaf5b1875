// SPDX-License-Identifier: MIT
// Modes, commands, safety and the line.
#include "twin/devices/emulated_roomba.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "robot/base/random.hpp"
#include "tests/robot/drivers/roomba_transcripts.hpp"
#include "tests/twin/devices/roomba_bench.hpp"

namespace sensotwin::twin {
namespace {

using robot::Bytes;
using robot::oi::Mode;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
namespace script = robot::transcripts;
using script::operator+;

// The same transcripts as in tests/robot/drivers.
TEST_F(RoombaBoard, AnswersTheDriversTranscripts) {
  EXPECT_EQ(say(script::kStartInSafeMode.to_robot), script::kStartInSafeMode.from_robot);
  EXPECT_EQ(say(script::kTurnLeft.to_robot), script::kTurnLeft.from_robot);
  EXPECT_DOUBLE_EQ(out_.wheel_left_mps, -0.2);
  EXPECT_DOUBLE_EQ(out_.wheel_right_mps, 0.2);
  EXPECT_EQ(say(script::kStop.to_robot), script::kStop.from_robot);
  in_.wheel_drop_left = true;
  EXPECT_EQ(say(), script::kWheelDrop.from_robot);
  EXPECT_EQ(say(script::kWheelDrop.to_robot), script::kWheelDrop.from_robot);
  in_.wheel_drop_left = false;
  EXPECT_EQ(say(script::kStartInFullMode.to_robot), script::kStartInFullMode.from_robot);
  EXPECT_EQ(say(script::kShutDown.to_robot), script::kShutDown.from_robot);
}

TEST_F(RoombaBoard, IsDeafToAllButStartAndResetWhileOffAndStillConsumesDataBytes) {
  EXPECT_THAT(say({131, 142, 35, 148, 1, 35, 139, 4, 128, 255}), IsEmpty());
  EXPECT_EQ(roomba_.mode(), Mode::kOff);
  say({128});
  EXPECT_EQ(roomba_.mode(), Mode::kPassive);
}

TEST_F(RoombaBoard, ChangesModeBeforeTheNextByteIsParsed) {
  EXPECT_THAT(say({128, 131, 142, 35}), ElementsAre(2));
}

TEST_F(RoombaBoard, FollowsTheModeTableFromEveryMode) {
  struct Case {
    std::uint8_t opcode;
    Mode becomes;
  };
  for (const Mode from : {Mode::kPassive, Mode::kSafe, Mode::kFull}) {
    for (const Case& c :
         {Case{128, Mode::kPassive}, Case{130, Mode::kSafe}, Case{131, Mode::kSafe}, Case{132, Mode::kFull},
          Case{134, Mode::kPassive}, Case{135, Mode::kPassive}, Case{136, Mode::kPassive},
          Case{143, Mode::kPassive}, Case{173, Mode::kOff}, Case{7, Mode::kOff}}) {
      roomba_ = EmulatedRoomba{};
      reaches(from);
      say({c.opcode});
      EXPECT_EQ(roomba_.mode(), c.becomes) << int{c.opcode} << " from " << static_cast<int>(from);
    }
  }
}

TEST_F(RoombaBoard, DrivesInSafeAndFullModeOnlyButConsumesTheBytesInPassive) {
  reaches(Mode::kPassive);
  EXPECT_THAT(say({145, 0, 128, 0, 131, 142, 35}), ElementsAre(1));
  EXPECT_EQ(out_.wheel_left_mps, 0.0);
  reaches(Mode::kFull);
  say({145, 0, 128, 0, 131});
  EXPECT_DOUBLE_EQ(out_.wheel_right_mps, 0.128);
  EXPECT_DOUBLE_EQ(out_.wheel_left_mps, 0.131);
}

TEST_F(RoombaBoard, DrivesArcsOfTheManual) {
  reaches(Mode::kFull);
  say({137, 255, 56, 1, 244});
  EXPECT_NEAR(out_.wheel_left_mps, -0.2 * (1 - 0.235), 1e-12);
  EXPECT_NEAR(out_.wheel_right_mps, -0.2 * (1 + 0.235), 1e-12);
}

TEST_F(RoombaBoard, ClampsSpeedsToWhatItsWheelsCan) {
  reaches(Mode::kFull);
  say({145, 127, 255, 128, 1});
  EXPECT_DOUBLE_EQ(out_.wheel_right_mps, 0.5);
  EXPECT_DOUBLE_EQ(out_.wheel_left_mps, -0.5);
}

TEST_F(RoombaBoard, RunsItsWheelsInStepsButReportsTheRequest) {
  roomba_ = EmulatedRoomba{};
  reaches(Mode::kFull);
  EXPECT_THAT(say({145, 0, 200, 0, 10, 149, 2, 41, 42}), ElementsAre(0, 200, 0, 10));
  EXPECT_NEAR(out_.wheel_right_mps, 7 * 0.0285, 1e-12);
  EXPECT_EQ(out_.wheel_left_mps, 0.0);
}

TEST_F(RoombaBoard, StopsWheelsAndBrushesOnStart) {
  reaches(Mode::kFull);
  say({137, 0, 200, 128, 0, 138, 7, 128});
  EXPECT_EQ(out_.wheel_left_mps, 0.0);
  EXPECT_EQ(out_.main_brush, 0.0);
  EXPECT_EQ(out_.vacuum, 0.0);
}

TEST_F(RoombaBoard, RunsBrushesAsToldByBitsAndByDutyCycle) {
  reaches(Mode::kSafe);
  say({138, 13});  // the manual's example: main inward, side clockwise
  EXPECT_EQ(out_.main_brush, 1.0);
  EXPECT_EQ(out_.side_brush, -1.0);
  say({144, 201, 32, 64});
  EXPECT_DOUBLE_EQ(out_.main_brush, -55 / 128.0);
  EXPECT_DOUBLE_EQ(out_.side_brush, 0.25);
  EXPECT_DOUBLE_EQ(out_.vacuum, 0.5);
}

TEST_F(RoombaBoard, LeavesSafeModeOverACliffWhenMovingTowardsIt) {
  struct Case {
    Bytes drive;
    Mode left_in;
  };
  for (const Case& c : {Case{{137, 0, 200, 128, 0}, Mode::kPassive},   // forward
                        Case{{137, 255, 56, 128, 0}, Mode::kSafe},     // straight back
                        Case{{137, 255, 56, 0, 100}, Mode::kPassive},  // back, radius 100 mm
                        Case{{137, 255, 56, 0, 200}, Mode::kSafe},     // back, radius 200 mm
                        Case{{145, 0, 0, 0, 0}, Mode::kSafe}}) {       // standing
    roomba_ = EmulatedRoomba{};
    in_ = at_rest();
    reaches(Mode::kSafe);
    say(c.drive);
    in_.cliff[1] = true;
    say();
    EXPECT_EQ(roomba_.mode(), c.left_in) << int{c.drive[1]} << ' ' << int{c.drive[4]};
    EXPECT_EQ(out_.wheel_left_mps == 0.0, c.left_in == Mode::kPassive || c.drive[2] == 0);
  }
}

TEST_F(RoombaBoard, LeavesSafeModeOnAWheelDropAndOnACharger) {
  for (bool world::RoombaInputs::*hazard :
       {&world::RoombaInputs::wheel_drop_left, &world::RoombaInputs::wheel_drop_right,
        &world::RoombaInputs::on_home_base, &world::RoombaInputs::internal_charger}) {
    in_ = at_rest();
    reaches(Mode::kSafe);
    in_.*hazard = true;
    say();
    EXPECT_EQ(roomba_.mode(), Mode::kPassive);
    say({131});
    EXPECT_EQ(roomba_.mode(), Mode::kPassive) << "safe mode entered with the condition present";
  }
}

TEST_F(RoombaBoard, StaysInSafeModeOnABump) {
  reaches(Mode::kSafe);
  say({145, 0, 200, 0, 200});
  in_.bump_left = in_.bump_right = true;
  say();
  EXPECT_EQ(roomba_.mode(), Mode::kSafe);
  EXPECT_DOUBLE_EQ(out_.wheel_left_mps, 0.2);
}

TEST_F(RoombaBoard, IgnoresAllHazardsInFullMode) {
  reaches(Mode::kFull);
  say({145, 0, 200, 0, 200});
  in_.cliff.fill(true);
  in_.wheel_drop_left = true;
  in_.on_home_base = true;
  say();
  EXPECT_EQ(roomba_.mode(), Mode::kFull);
  EXPECT_DOUBLE_EQ(out_.wheel_left_mps, 0.2);
  EXPECT_FALSE(out_.charging_allowed);
}

TEST_F(RoombaBoard, AnswersAQueryListInTheOrderAskedWithoutIds) {
  say({128});
  in_.bump_left = true;
  in_.virtual_wall = true;
  say();
  EXPECT_THAT(say({149, 3, 22, 7, 13}), ElementsAre(0x3E, 0x80, 2, 1));
}

TEST_F(RoombaBoard, AnswersNothingToUnknownPackets) {
  say({128});
  EXPECT_THAT(say({142, 102, 142, 59, 149, 1, 255}), IsEmpty());
}

TEST_F(RoombaBoard, StreamsEveryTickUntilPausedAndGoesOnWithTheSameList) {
  EXPECT_THAT(say({128, 148, 2, 7, 13}), ElementsAre(19, 4, 7, 0, 13, 0, 213));
  EXPECT_THAT(say(), SizeIs(7));
  EXPECT_THAT(say({150, 0}), IsEmpty());
  EXPECT_THAT(say(), IsEmpty());
  EXPECT_THAT(say({150, 1}), SizeIs(7));
  EXPECT_THAT(say({131}), SizeIs(7));
  EXPECT_THAT(say({148, 0}), IsEmpty());
  EXPECT_THAT(say({150, 1}), IsEmpty());
}

TEST_F(RoombaBoard, ForgetsTheStreamOnStop) {
  say({128, 148, 1, 7});
  EXPECT_THAT(say({173}), IsEmpty());
  EXPECT_THAT(say({128}), IsEmpty());
}

TEST_F(RoombaBoard, PutsAnAnswerBetweenFramesNeverInsideOne) {
  say({128, 148, 1, 100});
  const Bytes heard = say({142, 35});
  ASSERT_THAT(heard, SizeIs(85));
  EXPECT_EQ(heard[0], 1);
  EXPECT_EQ(heard[1], 19);
}

// Page 22: at 115200 baud 172 bytes in 15 ms; "if more data is requested, the stream will eventually become
// corrupted".
TEST_F(RoombaBoard, SendsAtMost172BytesInATickAndLosesWhatWasAskedTooMuch) {
  say({128, 148, 3, 100, 100, 100});
  for (int i = 0; i < 20; ++i) {
    EXPECT_LE(say().size(), 172u);
  }
  EXPECT_GT(roomba_.bytes_overrun(), 0u);
}

TEST_F(RoombaBoard, SlowsDownWithTheBaudRate) {
  say({128, 129, 7});  // 19200: 28 bytes a tick
  EXPECT_EQ(roomba_.baud(), 19200);
  EXPECT_THAT(say({142, 100}), SizeIs(28));
  EXPECT_THAT(say(), SizeIs(28));
  EXPECT_THAT(say(), SizeIs(24));
}

TEST_F(RoombaBoard, PlaysASongForItsLengthAndReportsIt) {
  reaches(Mode::kFull);
  say({140, 2, 2, 69, 16, 72, 16, 141, 2});  // half a second
  EXPECT_THAT(say({149, 2, 36, 37}), ElementsAre(2, 1));
  for (int i = 0; i < 32; ++i) {
    say();
  }
  EXPECT_THAT(say({142, 37}), ElementsAre(0));
}

TEST_F(RoombaBoard, DoesNotHangOnASongOfNoNotes) {
  reaches(Mode::kFull);
  EXPECT_THAT(say({140, 0, 0, 141, 0, 142, 35}), ElementsAre(3));
  EXPECT_FALSE(roomba_.song_playing());
}

TEST_F(RoombaBoard, ShowsLampsAndDigitsAndTurnsThemOffOnSafe) {
  reaches(Mode::kSafe);
  say({139, 4, 0, 128, 164, 65, 66, 67, 68});
  EXPECT_EQ(roomba_.panel().leds, (robot::oi::Leds{4, 0, 128}));
  EXPECT_THAT(roomba_.panel().digits.characters, ElementsAre('A', 'B', 'C', 'D'));
  say({131});
  EXPECT_EQ(roomba_.panel().leds, robot::oi::Leds{});
}

TEST_F(RoombaBoard, HoldsAPushedButtonForASixthOfASecond) {
  say({128});
  int pushed = 0;
  Bytes heard = say({165, 4, 142, 18});
  while (heard == Bytes{4} && pushed < 100) {
    ++pushed;
    heard = say({142, 18});
  }
  EXPECT_NEAR(pushed * robot::to_s(robot::kTick), 1.0 / 6.0, 0.016);
}

TEST_F(RoombaBoard, SaysItsFirmwareAfterResetAndForgetsWhatItWasTold) {
  say({128, 148, 1, 7});
  const Bytes heard = say({7});
  const std::string text(heard.begin(), heard.end());
  EXPECT_THAT(text, HasSubstr("r3_robot/tags/release-3.7.7"));
  EXPECT_EQ(roomba_.mode(), Mode::kOff);
  EXPECT_THAT(say({142, 35}), IsEmpty());
}

TEST_F(RoombaBoard, SleepsAfterFiveMinutesOfSilenceInPassiveModeUntilItsBrcIsPulsed) {
  say({128, 148, 1, 7});
  for (int i = 0; i < 19'990; ++i) {
    say();
  }
  EXPECT_FALSE(roomba_.asleep());
  for (int i = 0; i < 20; ++i) {
    say();
  }
  EXPECT_TRUE(roomba_.asleep());
  EXPECT_THAT(say({128, 142, 35}), IsEmpty());
  roomba_.pulse_brc();
  EXPECT_THAT(say({128, 142, 35}), ElementsAre(1));
}

TEST_F(RoombaBoard, NeverSleepsInSafeMode) {
  reaches(Mode::kSafe);
  for (int i = 0; i < 25'000; ++i) {
    say();
  }
  EXPECT_FALSE(roomba_.asleep());
}

TEST_F(RoombaBoard, SleepsWhenPoweredDown) {
  reaches(Mode::kFull);
  say({145, 0, 200, 0, 200, 133});
  EXPECT_TRUE(roomba_.asleep());
  EXPECT_EQ(out_.wheel_left_mps, 0.0);
}

TEST_F(RoombaBoard, IsDeadWithoutPowerAndOffWhenItComesBack) {
  reaches(Mode::kFull);
  say({145, 0, 200, 0, 200, 148, 1, 7});
  in_.power = false;
  EXPECT_THAT(say({142, 35}), IsEmpty());
  EXPECT_EQ(out_.wheel_left_mps, 0.0);
  in_.power = true;
  say();
  EXPECT_EQ(roomba_.mode(), Mode::kOff);
  EXPECT_THAT(say({128, 142, 35}), ElementsAre(1));
}

TEST_F(RoombaBoard, SurvivesAMillionRandomBytes) {
  robot::RandomStream random = robot::RandomStream{4}.fork("client");
  std::size_t heard = 0;
  for (const world::RoombaKind kind : {world::RoombaKind::kCreate2, world::RoombaKind::kRoomba400}) {
    EmulatedRoomba roomba{{.body = {.kind = kind}}};
    Bytes bytes(50);
    for (int i = 0; i < 10'000; ++i) {
      for (std::uint8_t& byte : bytes) {
        byte = static_cast<std::uint8_t>(random.chance(0.5) ? 128 + random.below(46) : random.below(256));
      }
      roomba.pulse_brc();
      roomba.receive(bytes);
      const world::RoombaOutputs out = roomba.tick(in_);
      ASSERT_LE(std::abs(out.wheel_left_mps), 0.5);
      ASSERT_LE(std::abs(out.main_brush), 1.0);
      heard += hear(roomba).size();
    }
  }
  EXPECT_GT(heard, 10'000u);
}

}  // namespace
}  // namespace sensotwin::twin
