// SPDX-License-Identifier: MIT
// Packets, odometry and errata.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robot/wire/oi_packets.hpp"
#include "robot/wire/ticks.hpp"
#include "tests/twin/devices/roomba_bench.hpp"
#include "twin/devices/emulated_roomba.hpp"

namespace sensotwin::twin {
namespace {

using robot::Bytes;
using robot::oi::PacketId;
using ::testing::ElementsAre;

class RoombaSensors : public ::testing::Test {
 protected:
  explicit RoombaSensors(const EmulatedRoombaConfig& config = {.speed_step_mps = 0.0}) : roomba_(config) {
    start();
  }
  void start() {
    roomba_.receive(Bytes{128, 132});
    out_ = roomba_.tick(in_);
  }
  void restart(const EmulatedRoombaConfig& config) {
    roomba_ = EmulatedRoomba{config};
    start();
  }
  [[nodiscard]] Bytes ask(std::uint8_t id) {
    roomba_.receive(Bytes{142, id});
    return hear(roomba_);
  }
  [[nodiscard]] int ask_16(PacketId id) {
    const Bytes heard = ask(static_cast<std::uint8_t>(id));
    return heard.size() == 2 ? robot::s16_from_be(heard[0], heard[1]) : -99'999;
  }
  void drive(std::int16_t left_mm_s, std::int16_t right_mm_s, double seconds) {
    roomba_.receive(robot::oi::encode(robot::oi::DriveDirect{right_mm_s, left_mm_s}));
    for (int i = 0; i < seconds / robot::to_s(robot::kTick); ++i) {
      out_ = roomba_.tick(in_);
      wheels_.roll(out_, in_);
    }
    out_ = roomba_.tick(in_);
  }

  EmulatedRoomba roomba_;
  world::RoombaInputs in_ = at_rest();
  world::RoombaOutputs out_;
  FreeWheels wheels_;
};

TEST_F(RoombaSensors, ShowInputsInTheirPackets) {
  in_.bump_left = true;
  in_.wheel_drop_right = true;
  in_.cliff = {true, false, false, true};
  in_.cliff_signal = {10, 2000, 3000, 5000};
  in_.light_bump_signal = {0, 99, 100, 4095, 5000, 50};
  in_.wall_signal = 500;
  in_.virtual_wall = true;
  in_.ir_omni = 162;
  in_.motor_ma = {300, 1600, -20, 0};
  in_.battery_ma = -1200;
  in_.buttons = 1;
  roomba_.tick(in_);
  EXPECT_THAT(ask(7), ElementsAre(2 | 4));
  EXPECT_THAT(ask(8), ElementsAre(1));
  EXPECT_THAT(ask(9), ElementsAre(1));
  EXPECT_THAT(ask(10), ElementsAre(0));
  EXPECT_THAT(ask(12), ElementsAre(1));
  EXPECT_THAT(ask(13), ElementsAre(1));
  EXPECT_THAT(ask(14), ElementsAre(8));
  EXPECT_THAT(ask(17), ElementsAre(162));
  EXPECT_THAT(ask(18), ElementsAre(1));
  EXPECT_EQ(ask_16(PacketId::kCurrent), -1200);
  EXPECT_EQ(ask_16(PacketId::kCharge), 2000);
  EXPECT_EQ(ask_16(PacketId::kCliffRightSignal), 4095);
  EXPECT_THAT(ask(45), ElementsAre(4 | 8 | 16));
  EXPECT_EQ(ask_16(PacketId::kLightBumpFrontRight), 4095);
  EXPECT_EQ(ask_16(PacketId::kRightMotorCurrent), 1600);
  EXPECT_EQ(ask_16(PacketId::kMainBrushMotorCurrent), -20);
}

TEST_F(RoombaSensors, ReportChargingOnTheHomeBaseOutsideSafeAndFullMode) {
  in_.on_home_base = true;
  roomba_.tick(in_);
  EXPECT_THAT(ask(21), ElementsAre(0));
  EXPECT_THAT(ask(34), ElementsAre(2));
  roomba_.receive(Bytes{128});
  EXPECT_TRUE(roomba_.tick(in_).charging_allowed);
  EXPECT_THAT(ask(21), ElementsAre(2));
  in_.battery_charge_mah = in_.battery_capacity_mah;
  roomba_.tick(in_);
  EXPECT_THAT(ask(21), ElementsAre(3));
}

TEST_F(RoombaSensors, CountTheWayDriven) {
  drive(200, 200, 5.0);
  // 1 m / 0.444565 mm per count (page 31: pi * 72.0 / 508.8).
  EXPECT_NEAR(ask_16(PacketId::kEncoderLeft), 1000 / 0.444565, 12);
  EXPECT_NEAR(ask_16(PacketId::kEncoderRight), 1000 / 0.444565, 12);
}

TEST_F(RoombaSensors, CountAcrossTheWrapAndThroughReversals) {
  restart({.speed_step_mps = 0.0, .encoder_start_left = {65400}, .encoder_start_right = {100}});
  wheels_ = FreeWheels{1.5};
  for (int i = 0; i < 10; ++i) {
    drive(-200, 200, 1.0);
    drive(0, 0, 0.5);
    drive(200, -100, 1.0);
    drive(-300, 300, 1.0);
  }
  const robot::Ticks left{static_cast<std::uint16_t>(ask_16(PacketId::kEncoderLeft))};
  const robot::Ticks right{static_cast<std::uint16_t>(ask_16(PacketId::kEncoderRight))};
  const auto counts = [](double angle_rad) { return angle_rad * 508.8 / (2.0 * robot::kPi); };
  EXPECT_NEAR(left - robot::Ticks{65400}, counts(in_.wheel_angle_left_rad), 30.0);
  EXPECT_NEAR(right - robot::Ticks{100}, counts(in_.wheel_angle_right_rad), 30.0);
}

TEST_F(RoombaSensors, TellDistanceSinceTheLastReadAndKeepTheFractionsOfAMillimetre) {
  drive(200, 200, 1.0);
  static_cast<void>(ask(19));
  int sum_mm = 0;
  for (int i = 0; i < 100; ++i) {
    drive(200, 200, 0.015);
    sum_mm += ask_16(PacketId::kDistance);
  }
  EXPECT_NEAR(sum_mm, 0.2 * 100 * 15, 3);
  EXPECT_EQ(ask_16(PacketId::kDistance), 0);
}

TEST_F(RoombaSensors, ClearDistanceWhenAGroupAListOrAStreamReadsIt) {
  drive(200, 200, 1.0);
  static_cast<void>(ask(2));
  EXPECT_EQ(ask_16(PacketId::kDistance), 0);
  drive(200, 200, 1.0);
  roomba_.receive(Bytes{149, 1, 19});
  static_cast<void>(hear(roomba_));
  EXPECT_EQ(ask_16(PacketId::kDistance), 0);
  drive(200, 200, 1.0);
  roomba_.receive(Bytes{148, 1, 19});
  roomba_.tick(in_);
  static_cast<void>(hear(roomba_));
  EXPECT_EQ(ask_16(PacketId::kDistance), 0);
}

TEST_F(RoombaSensors, CapDistanceThatNobodyReads) {
  drive(500, 500, 80.0);
  EXPECT_EQ(ask_16(PacketId::kDistance), 32767);
  EXPECT_EQ(ask_16(PacketId::kDistance), 0);
}

TEST_F(RoombaSensors, TellAngleInDegreesCounterClockwiseAndKeepTheFractions) {
  int sum_deg = 0;
  for (int i = 0; i < 200; ++i) {
    drive(-50, 50, 0.015);
    sum_deg += ask_16(PacketId::kAngle);
  }
  EXPECT_NEAR(sum_deg, robot::deg_from_rad(0.1 / 0.235 * 200 * 0.015), 3.0);
}

TEST_F(RoombaSensors, OfACreate1LoseSlowTurnsWhenReadEachTick) {
  restart({.truncate_angle = true, .speed_step_mps = 0.0});
  int sum_deg = 0;
  for (int i = 0; i < 200; ++i) {
    drive(-50, 50, 0.015);
    sum_deg += ask_16(PacketId::kAngle);
  }
  EXPECT_EQ(sum_deg, 0);
}

TEST_F(RoombaSensors, OfFirmwareUpTo340TellAThirdOfTheAngle) {
  restart({.firmware = {3, 4, 0}, .speed_step_mps = 0.0});
  drive(-100, 100, 3.0);
  EXPECT_NEAR(ask_16(PacketId::kAngle) / 0.324056, robot::deg_from_rad(0.2 / 0.235 * 3.0), 5.0);
  restart({.firmware = {3, 4, 1}, .speed_step_mps = 0.0});
  drive(-100, 100, 3.0);
  EXPECT_NEAR(ask_16(PacketId::kAngle), robot::deg_from_rad(0.2 / 0.235 * 3.0), 5.0);
}

TEST_F(RoombaSensors, OfFirmwareBefore330TellLengthsAsPlayerUndoesThem) {
  restart({.firmware = {3, 2, 9}, .speed_step_mps = 0.0});
  drive(200, 200, 5.0);
  EXPECT_NEAR(ask_16(PacketId::kDistance) * -10, 1000, 15);
  roomba_.receive(Bytes{137, 0, 100, 1, 244});
  EXPECT_EQ(ask_16(PacketId::kRequestedRadius), -50);
}

TEST_F(RoombaSensors, OfSome630sTellTenPercentTooLittleDistance) {
  restart({.distance_scale = 0.9, .speed_step_mps = 0.0});
  drive(200, 200, 5.0);
  EXPECT_NEAR(ask_16(PacketId::kDistance), 900, 10);
}

TEST_F(RoombaSensors, OfSomeWifiModelsTellTheModeOneTooHigh) {
  restart({.mode_one_too_high = true});
  EXPECT_THAT(ask(35), ElementsAre(4));
}

TEST_F(RoombaSensors, TellForwardProgressOnlyWhenDrivingStraightOn) {
  in_.forward_progress = true;
  drive(200, 200, 0.1);
  EXPECT_THAT(ask(58), ElementsAre(1));
  drive(-200, 200, 0.1);
  EXPECT_THAT(ask(58), ElementsAre(0));
  drive(-200, -200, 0.1);
  EXPECT_THAT(ask(58), ElementsAre(0));
}

TEST_F(RoombaSensors, TellTheNumberOfStreamedPackets) {
  roomba_.receive(Bytes{148, 3, 7, 8, 9, 150, 0});
  EXPECT_THAT(ask(38), ElementsAre(3));
}

}  // namespace
}  // namespace sensotwin::twin
