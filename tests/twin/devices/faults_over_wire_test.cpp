// SPDX-License-Identifier: MIT
// The faults of docs/wires.md, wire by wire: the robot's driver at one end, the emulated device at the other,
// and what becomes of both.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "faulty_link.hpp"
#include "robot/base/geometry.hpp"
#include "robot/drivers/roomba.hpp"
#include "robot/drivers/sensor_board.hpp"
#include "robot/drivers/uhf_reader.hpp"
#include "robot/hal/no_device.hpp"
#include "robot/program/mode_keeper.hpp"
#include "tests/twin/devices/roomba_bench.hpp"
#include "twin/devices/emulated_sensor_board.hpp"
#include "twin/devices/emulated_uhf_reader.hpp"

namespace sensotwin::twin {
namespace {

using namespace std::chrono_literals;
using robot::RoombaStatus;
using robot::UhfReaderFault;
using robot::UhfReaderStatus;

constexpr double kOneInAHundred = 0.01;

/// Bytes without a meaning, always the same.
[[nodiscard]] robot::Bytes noise(std::size_t size) {
  robot::RandomStream random{8};
  robot::Bytes bytes(size);
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(random.below(256));
  }
  return bytes;
}
constexpr int kNoiseChunks = 1000;
constexpr std::size_t kNoiseChunkBytes = 10'000;  // ten megabytes in all

/// A Roomba that is asked to drive at 0.1 m/s, whatever happens.
class BaseOverFaultyWire : public ::testing::Test {
 protected:
  void run(double seconds) {
    for (double s = 0.0; s < seconds; s += robot::to_s(robot::kTick)) {
      out_ = board_.tick(in_);
      wheels_.roll(out_, in_);
      now_ += robot::kTick;
      driver_.step(now_);
      ++ticks_unheard_;
      if (const robot::RoombaState* fresh = driver_.fresh()) {
        look_at_wheels(*fresh);
        state_ = *fresh;
        ticks_unheard_ = 0;
      }
      keeper_.step(driver_, state_);
      static_cast<void>(driver_.drive({.left_mps = 0.1, .right_mps = 0.1}));
      ++ticks_;
      as_asked_ += is(0.1) ? 1 : 0;
      wrong_in_a_row_ = is(0.1) || is(0.0) ? 0 : wrong_in_a_row_ + 1;
      longest_wrong_ = std::max(longest_wrong_, wrong_in_a_row_);
    }
  }
  void look_at_wheels(const robot::RoombaState& fresh) {
    if (state_.encoders && fresh.encoders) {
      const int jump = std::max(std::abs(fresh.encoders->left - state_.encoders->left),
                                std::abs(fresh.encoders->right - state_.encoders->right));
      most_counts_in_a_tick_ = std::max(most_counts_in_a_tick_, jump / ticks_unheard_);
    }
  }
  [[nodiscard]] bool is(double speed_mps) const {
    return out_.wheel_left_mps == speed_mps && out_.wheel_right_mps == speed_mps;
  }
  [[nodiscard]] double share_as_asked() const { return static_cast<double>(as_asked_) / ticks_; }
  [[nodiscard]] double longest_wrong_s() const { return longest_wrong_ * robot::to_s(robot::kTick); }

  EmulatedRoomba board_{{.speed_step_mps = 0.0}};
  EmulatedSerial serial_{board_};
  FaultyLink wire_{serial_};
  robot::Roomba driver_{wire_, {}};
  robot::ModeKeeper keeper_{robot::oi::Mode::kSafe};
  robot::RoombaState state_;
  world::RoombaInputs in_ = at_rest();
  world::RoombaOutputs out_;
  FreeWheels wheels_;
  robot::Instant now_;
  int ticks_unheard_{0};
  int most_counts_in_a_tick_{0};
  int ticks_{0};
  int as_asked_{0};
  int wrong_in_a_row_{0};
  int longest_wrong_{0};
};

TEST_F(BaseOverFaultyWire, LosingOneByteInAHundredDrivesOnAndIsRightWithinASecondOfTheLastLoss) {
  run(1.0);
  wire_.lose_in = wire_.lose_out = kOneInAHundred;
  run(600.0);
  // A frame of 110 bytes is whole in one of three cases, and seven bad ones in a row stop the wheels for a
  // moment.
  EXPECT_GT(share_as_asked(), 0.8);
  EXPECT_LT(longest_wrong_s(), 2.0)
      << "a command whose byte was lost eats the next; speeds are said again and again";
  EXPECT_GT(driver_.health().frames_corrupt, 1000u);
  wire_.lose_in = wire_.lose_out = 0.0;
  run(1.0);
  EXPECT_EQ(driver_.status(), RoombaStatus::kReady);
  EXPECT_TRUE(is(0.1));
}

TEST_F(BaseOverFaultyWire,
       WithOneByteInAHundredCorruptBelievesNoWheelThatJumpsAndIsRightWithinASecondOfTheLast) {
  run(1.0);
  wire_.corrupt_in = kOneInAHundred;
  run(600.0);
  EXPECT_GT(share_as_asked(), 0.8);
  EXPECT_EQ(longest_wrong_s(), 0.0) << "what it says is not touched";
  // Some four frames in a thousand pass their sum though two bytes are bent.
  EXPECT_LE(most_counts_in_a_tick_, 102) << "three times as fast as it can drive, and a tick of grace";
  EXPECT_GT(driver_.health().frames_corrupt, 1000u);
  wire_.corrupt_in = 0.0;
  run(1.0);
  EXPECT_EQ(driver_.status(), RoombaStatus::kReady);
  EXPECT_TRUE(is(0.1));
}

// A command may become any other: power, baud, reset. Whatever the machine was told, it does not drive at a
// wrong speed for long, and either goes on or stands.
TEST_F(BaseOverFaultyWire, WithOneByteInAHundredCorruptBothWaysGoesOnOrStands) {
  run(1.0);
  for (int round = 0; round < 30; ++round) {
    wire_.corrupt_in = wire_.corrupt_out = kOneInAHundred;
    run(20.0);
    wire_.corrupt_in = wire_.corrupt_out = 0.0;
    run(2.0);
    EXPECT_TRUE(is(driver_.status() == RoombaStatus::kReady ? 0.1 : 0.0))
        << "round " << round << ": " << out_.wheel_left_mps << " " << out_.wheel_right_mps;
    if (driver_.status() != RoombaStatus::kReady) {
      in_.power = false;  // what its user does then
      run(1.0);
      in_.power = true;
      run(2.0);
      ASSERT_EQ(driver_.status(), RoombaStatus::kReady) << "round " << round;
    }
  }
  EXPECT_LT(longest_wrong_s(), 2.0);
}

TEST_F(BaseOverFaultyWire, StalledFor200MillisecondsStopsTheWheelsAndDrivesOnAfterwards) {
  run(1.0);
  for (int i = 0; i < 20; ++i) {
    wire_.set_stalled(true);
    run(0.2);
    EXPECT_EQ(driver_.status(), RoombaStatus::kStreamLost);
    wire_.set_stalled(false);
    run(0.2);
    EXPECT_EQ(driver_.status(), RoombaStatus::kReady);
    EXPECT_TRUE(is(0.1));
  }
  EXPECT_EQ(longest_wrong_s(), 0.0) << "what was held up comes through in its order";
}

TEST_F(BaseOverFaultyWire, AfterTenMegabytesOfNoiseIsReadyWithinASecond) {
  const robot::Bytes chunk = noise(kNoiseChunkBytes);
  for (int i = 0; i < kNoiseChunks; ++i) {
    wire_.inject(chunk);
    run(0.3);
  }
  run(1.0);
  EXPECT_EQ(driver_.status(), RoombaStatus::kReady);
  EXPECT_TRUE(is(0.1));
  EXPECT_GT(driver_.health().bytes_skipped, 9'000'000u);
}

/// A compass board whose heading is always 100 degrees.
class CompassOverFaultyWire : public ::testing::Test {
 protected:
  void run(double seconds) {
    for (double s = 0.0; s < seconds; s += robot::to_s(robot::kTick)) {
      now_ += robot::kTick;
      board_.step(now_, kYaw_rad);
      driver_.step(now_);
      ++steps_;
      known_ += driver_.compass() ? 1 : 0;
      wrong_ +=
          driver_.compass() && std::abs(driver_.compass()->yaw_from_north_rad - kYaw_rad) > 1e-9 ? 1 : 0;
    }
  }
  static inline const double kYaw_rad = robot::yaw_rad_from_heading_deg(100.0);

  EmulatedSensorBoard board_{{}};
  FaultyLink wire_{board_};
  robot::SensorBoard driver_{wire_};
  robot::Instant now_;
  int steps_{0};
  int known_{0};
  int wrong_{0};
};

TEST_F(CompassOverFaultyWire,
       LosingOneByteInAHundredKnowsItsHeadingAllTheTimeAndIsWrongForNoMoreThanItsSumLetsPass) {
  run(1.0);
  wire_.lose_in = kOneInAHundred;
  steps_ = known_ = 0;
  run(600.0);
  // Of sentences of 18 bytes one in six is lost; five in a row, which is stale, once in an hour.
  EXPECT_GT(known_, 0.999 * steps_);
  // Two equal characters lost leave the sum as it was: both zeros of 100.0, one sentence in some thousands.
  EXPECT_LT(wrong_, 0.003 * steps_);
}

// The sum of NMEA is an exclusive or: two characters with the same bit turned pass it. Of 13 characters that
// count, 13 * 12 / 2 pairs at 1e-4, one in eight with the same bit: one sentence in a thousand, each of which
// lives 0.1 s.
TEST_F(CompassOverFaultyWire, WithOneByteInAHundredCorruptIsWrongForNoMoreThanItsSumLetsPass) {
  run(1.0);
  wire_.corrupt_in = kOneInAHundred;
  steps_ = known_ = 0;
  run(3600.0);
  EXPECT_GT(known_, 0.999 * steps_);
  EXPECT_LT(wrong_, 0.003 * steps_);
  EXPECT_GT(driver_.health().bad_checksum, 1000u);
}

TEST_F(CompassOverFaultyWire, StalledFor200MillisecondsKeepsItsReading) {
  run(1.0);
  steps_ = known_ = 0;
  for (int i = 0; i < 20; ++i) {
    wire_.set_stalled(true);
    run(0.2);
    wire_.set_stalled(false);
    run(0.3);
  }
  EXPECT_EQ(known_, steps_);
  EXPECT_EQ(driver_.health().bad_frame + driver_.health().bad_checksum, 0u);
}

TEST_F(CompassOverFaultyWire, PulledOutHasNoReadingAfterHalfASecondAndOneAgainWhenItIsBack) {
  run(1.0);
  board_.unplug();
  run(0.6);
  EXPECT_FALSE(driver_.compass());
  board_.replug();
  run(0.2);
  EXPECT_TRUE(driver_.compass());
  EXPECT_EQ(driver_.health().link_lost, 1u);
}

TEST_F(CompassOverFaultyWire, AfterTenMegabytesOfNoiseHasAReadingWithinASecond) {
  const robot::Bytes chunk = noise(kNoiseChunkBytes);
  for (int i = 0; i < kNoiseChunks; ++i) {
    wire_.inject(chunk);
    run(0.3);
  }
  run(1.0);
  ASSERT_TRUE(driver_.compass());
  EXPECT_NEAR(driver_.compass()->yaw_from_north_rad, kYaw_rad, 1e-9);
}

/// A UHF reader before which a tag lies and answers every 15 ms.
class UhfOverFaultyWire : public ::testing::Test {
 protected:
  void run(double seconds) {
    for (double s = 0.0; s < seconds; s += robot::to_s(robot::kTick)) {
      now_ += robot::kTick;
      reader_->report({.at = now_, .epc = {{0x30}}, .antenna = 1, .phase_rad = 1.0, .rssi_dbm = -50.0});
      reader_->step(now_);
      driver_.step(now_);
      reads_ += driver_.reads().size();
      for (const robot::UhfRead& read : driver_.reads()) {
        EXPECT_LE(read.at, now_);
      }
    }
  }
  /// Reads of the next so many seconds.
  [[nodiscard]] std::size_t reads_in(double seconds) {
    reads_ = 0;
    run(seconds);
    return reads_;
  }

  robot::NoByteLink quiet_;
  std::optional<EmulatedUhfReader> reader_{std::in_place, UhfReaderSettings{}};
  FaultyLink wire_{reader_->link()};
  robot::UhfReader driver_{wire_, {}};
  robot::Instant now_;
  std::size_t reads_{0};
};

/// After a fault the set-up waits 8 s at most before it is tried again; behind a length that was spoilt, a
/// message of 64 KiB is awaited for the time of its reports, some 11 s.
constexpr double kUhfRecovery_s = 20.0;

TEST_F(UhfOverFaultyWire, LosingOneByteInAHundredOfItsWordsReadsAsBeforeAfterTheLastLoss) {
  run(2.0);
  wire_.lose_in = kOneInAHundred;
  EXPECT_GT(reads_in(300.0), 20u) << "some come through";
  wire_.lose_in = 0.0;
  run(kUhfRecovery_s);
  EXPECT_EQ(driver_.status(), UhfReaderStatus::kReading);
  EXPECT_GT(reads_in(2.0), 125u) << "of 133";
}

TEST_F(UhfOverFaultyWire, WithOneByteInAHundredOfItsWordsCorruptReadsAsBeforeAfterTheLast) {
  run(2.0);
  wire_.corrupt_in = kOneInAHundred;
  EXPECT_GT(reads_in(300.0), 20u) << "some come through";
  wire_.corrupt_in = 0.0;
  run(kUhfRecovery_s);
  EXPECT_EQ(driver_.status(), UhfReaderStatus::kReading);
  EXPECT_GT(reads_in(2.0), 125u) << "of 133";
}

// TCP loses nothing. Should a byte of ours be missing all the same, the reader waits for the rest of a
// message, and nothing but a new connection can tell it otherwise.
TEST_F(UhfOverFaultyWire, ThatLostAByteOfARequestIsSaidNotToAnswerAndReadsOnANewConnection) {
  wire_.lose_out = kOneInAHundred;
  run(60.0);
  EXPECT_NE(driver_.health().count(UhfReaderFault::kNoAnswer), 0u);
  EXPECT_NE(driver_.status(), UhfReaderStatus::kReading);
  wire_.lose_out = 0.0;
  reader_->link().cut();
  run(0.1);
  reader_->link().mend();
  run(3.0);
  EXPECT_EQ(driver_.status(), UhfReaderStatus::kReading);
  EXPECT_GT(reads_in(2.0), 125u) << "of 133";
}

TEST_F(UhfOverFaultyWire, StalledFor200MillisecondsLosesNoRead) {
  run(2.0);
  reads_ = 0;
  for (int i = 0; i < 20; ++i) {
    wire_.set_stalled(true);
    run(0.2);
    wire_.set_stalled(false);
    run(0.3);
  }
  EXPECT_NEAR(static_cast<double>(reads_), 20 * 0.5 / 0.015, 30.0);
  EXPECT_EQ(driver_.last_fault(), UhfReaderFault::kNone);
}

TEST_F(UhfOverFaultyWire, RebootedInMidInventoryReadsAgainThoughItForgotEverythingAndItsClockIsSetBack) {
  run(2.0);
  wire_.cut = true;
  run(1.0);
  EXPECT_EQ(driver_.status(), UhfReaderStatus::kDown);
  UhfReaderSettings settings;
  settings.utc_at_start_us = 1'000'000;  // 1970, until somebody tells it the time
  reader_.emplace(settings);
  wire_.plug_into(reader_->link());
  wire_.cut = false;
  run(2.0);
  EXPECT_EQ(driver_.status(), UhfReaderStatus::kReading);
  EXPECT_EQ(driver_.health().setups, 2u);
  EXPECT_GT(reads_in(2.0), 125u);
}

TEST_F(UhfOverFaultyWire, ThatAnotherClientHasIsToldSoAndReadWhenTheOtherHasGone) {
  EmulatedUhfReader taken{UhfReaderSettings{}};
  ASSERT_TRUE(taken.connect());
  wire_.inject(taken.refusal());
  reader_->link().cut();  // the greeting of a reader that is free does not come
  wire_.plug_into(quiet_);
  run(1.0);
  EXPECT_EQ(driver_.last_fault(), UhfReaderFault::kBusy);
  EXPECT_NE(driver_.status(), UhfReaderStatus::kReading);
  wire_.cut = true;
  run(0.1);
  reader_->link().mend();
  wire_.plug_into(reader_->link());
  wire_.cut = false;
  run(3.0);
  EXPECT_EQ(driver_.status(), UhfReaderStatus::kReading);
}

TEST_F(UhfOverFaultyWire, AfterTenMegabytesOfNoiseReadsAgain) {
  const robot::Bytes chunk = noise(kNoiseChunkBytes);
  for (int i = 0; i < kNoiseChunks; ++i) {
    wire_.inject(chunk);
    run(0.03);
  }
  run(kUhfRecovery_s);
  EXPECT_EQ(driver_.status(), UhfReaderStatus::kReading);
  EXPECT_GT(reads_in(2.0), 125u);
}

}  // namespace
}  // namespace sensotwin::twin
