// SPDX-License-Identifier: MIT
#include "robot/drivers/roomba.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/robot/drivers/roomba_transcripts.hpp"

namespace sensotwin::robot {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsNull;
using ::testing::NotNull;
namespace script = transcripts;
using transcripts::operator+;

/// The other end of the cable, in the test's hands.
class ScriptedLink : public ByteLink {
 public:
  /// What the driver said since the last call.
  [[nodiscard]] Bytes said() { return std::exchange(said_, {}); }
  void answer(const Bytes& bytes) { waiting_ = waiting_ + bytes; }
  void unplug(bool unplugged) { unplugged_ = unplugged; }

 private:
  bool do_write(ByteView bytes) override {
    if (!unplugged_) {
      said_.insert(said_.end(), bytes.begin(), bytes.end());
    }
    return !unplugged_;
  }
  std::size_t do_read(std::span<std::uint8_t> into) override {
    const std::size_t count = std::min(into.size(), waiting_.size());
    std::copy_n(waiting_.begin(), count, into.begin());
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }

  Bytes said_;
  Bytes waiting_;
  bool unplugged_{false};
};

class RoombaDriver : public ::testing::Test {
 protected:
  /// One control step with these bytes at the port. \returns what the driver said
  Bytes step(const Bytes& from_robot = {}) {
    link_.answer(from_robot);
    now_ += kTick;
    roomba_.step(now_);
    return link_.said();
  }
  void start() {
    EXPECT_EQ(step(), script::kStartInSafeMode.to_robot);
    EXPECT_THAT(step(script::kStartInSafeMode.from_robot), IsEmpty());
    ASSERT_EQ(roomba_.status(), RoombaStatus::kReady);
  }
  static Bytes frame(const script::Frame& frame = {}) { return script::bytes_of(frame); }

  ScriptedLink link_;
  Instant now_;
  Roomba roomba_{link_, {}};
};

TEST_F(RoombaDriver, StartsStreamsAndEntersSafeModeInOneBreath) {
  start();
  ASSERT_THAT(roomba_.fresh(), NotNull());
  EXPECT_EQ(roomba_.fresh()->mode, oi::Mode::kSafe);
  EXPECT_EQ(roomba_.fresh()->battery_mv, 16000);
  EXPECT_EQ(roomba_.fresh()->battery_ma, -200);
  EXPECT_EQ(roomba_.fresh()->capacity_mah, 2696);
  EXPECT_EQ(roomba_.fresh()->extended->cliff_signal[3], 2400);
  EXPECT_EQ(roomba_.fresh()->stamp, now_);
}

TEST_F(RoombaDriver, StartsInFullModeWhenAsked) {
  ScriptedLink link;
  Roomba roomba{link, {.mode = oi::Mode::kFull}};
  roomba.step(Instant{});
  EXPECT_EQ(link.said(), script::kStartInFullMode.to_robot);
  link.answer(script::kStartInFullMode.from_robot);
  roomba.step(Instant{kTick});
  EXPECT_EQ(roomba.status(), RoombaStatus::kReady);
}

TEST_F(RoombaDriver, SaysTheStartAgainAfterHalfASecondWithoutTheWantedMode) {
  step();
  const Instant said = now_;
  Bytes again;
  while (again.empty()) {
    again = step(frame({.mode = 1}));
    ASSERT_LT(now_ - said, std::chrono::seconds{1});
  }
  EXPECT_EQ(again, script::kStartInSafeMode.to_robot);
  EXPECT_GE(now_ - said, std::chrono::milliseconds{500});
  EXPECT_EQ(roomba_.health().starts, 2u);
}

TEST_F(RoombaDriver, MovesNothingBeforeItIsReady) {
  step();
  EXPECT_FALSE(roomba_.drive({.left_mps = 0.1, .right_mps = 0.1}));
  EXPECT_THAT(link_.said(), IsEmpty());
}

TEST_F(RoombaDriver, SendsWheelSpeedsAsBigEndianMillimetresPerSecondRightWheelFirst) {
  start();
  EXPECT_TRUE(roomba_.drive({.left_mps = -0.2, .right_mps = 0.2}));
  EXPECT_EQ(link_.said(), script::kTurnLeft.to_robot);
  step(script::kTurnLeft.from_robot);
  EXPECT_EQ(roomba_.fresh()->extended->requested_left_mm_s, -200);
}

TEST_F(RoombaDriver, SendsUnchangedSpeedsOnlyEveryTenFrames) {
  start();
  static_cast<void>(roomba_.drive({.left_mps = -0.2, .right_mps = 0.2}));
  static_cast<void>(link_.said());
  for (int i = 1; i <= 30; ++i) {
    const Bytes said = step(frame());
    EXPECT_EQ(said, i % 10 == 0 ? script::kTurnLeft.to_robot : Bytes{}) << "frame " << i;
    EXPECT_TRUE(roomba_.drive({.left_mps = -0.2, .right_mps = 0.2}));
    EXPECT_THAT(link_.said(), IsEmpty());
  }
}

TEST_F(RoombaDriver, ShowsAFrameInOneStepOnly) {
  start();
  step(frame());
  EXPECT_THAT(roomba_.fresh(), NotNull());
  step();
  EXPECT_THAT(roomba_.fresh(), IsNull());
}

TEST_F(RoombaDriver, JoinsAFrameThatCameInTwoHalves) {
  start();
  const Bytes bytes = frame({.counts_left = 7});
  step(Bytes(bytes.begin(), bytes.begin() + 40));
  EXPECT_THAT(roomba_.fresh(), IsNull());
  step(Bytes(bytes.begin() + 40, bytes.end()));
  ASSERT_THAT(roomba_.fresh(), NotNull());
  EXPECT_EQ(roomba_.fresh()->encoders->left, Ticks{7});
}

TEST_F(RoombaDriver, KeepsTheNewestOfSeveralFramesAndCountsTheOthers) {
  start();
  step(frame({.counts_left = 1}) + frame({.counts_left = 2}) + frame({.counts_left = 3}));
  EXPECT_EQ(roomba_.fresh()->encoders->left, Ticks{3});
  EXPECT_EQ(roomba_.health().frames_superseded, 2u);
  EXPECT_EQ(roomba_.health().frames_good, 4u);
}

TEST_F(RoombaDriver, StopsTheWheelsWhenFramesStopFor100Milliseconds) {
  start();
  static_cast<void>(roomba_.drive({.left_mps = 0.3, .right_mps = 0.3}));
  static_cast<void>(link_.said());
  const Instant last_frame = now_;
  Bytes said;
  while (said.empty()) {
    said = step();
    ASSERT_LT(now_ - last_frame, std::chrono::seconds{1});
  }
  EXPECT_EQ(said, script::kStop.to_robot);
  EXPECT_EQ(roomba_.status(), RoombaStatus::kStreamLost);
  EXPECT_GE(now_ - last_frame, std::chrono::milliseconds{100});
  EXPECT_LT(now_ - last_frame, std::chrono::milliseconds{120});
  EXPECT_FALSE(roomba_.drive({.left_mps = 0.3, .right_mps = 0.3}));
  EXPECT_THAT(link_.said(), IsEmpty());
}

TEST_F(RoombaDriver, RepeatsTheStopWhileFramesStayAwayAndIsReadyWhenTheyComeBack) {
  start();
  int stops = 0;
  for (int i = 0; i < 70; ++i) {
    stops += step().empty() ? 0 : 1;
  }
  EXPECT_GE(stops, 8);
  step(frame());
  EXPECT_EQ(roomba_.status(), RoombaStatus::kReady);
  EXPECT_TRUE(roomba_.drive({.left_mps = 0.1, .right_mps = 0.1}));
}

TEST_F(RoombaDriver, CountsCorruptFramesMissedSlotsAndSkippedBytes) {
  start();
  Bytes corrupt = frame();
  corrupt[50] ^= 4;
  step(corrupt);
  Bytes short_by_one = frame();
  short_by_one.erase(short_by_one.begin() + 30);
  step(short_by_one);
  step(frame());
  ASSERT_THAT(roomba_.fresh(), NotNull());
  EXPECT_EQ(roomba_.health().frames_corrupt, 2u);
  EXPECT_EQ(roomba_.health().frames_missed, 2u);
  EXPECT_EQ(roomba_.health().bytes_skipped, corrupt.size() + short_by_one.size());
}

TEST_F(RoombaDriver, StandsAfterASafetyEventUntilItIsRearmed) {
  start();
  static_cast<void>(roomba_.drive({.left_mps = 0.3, .right_mps = 0.3}));
  static_cast<void>(link_.said());
  EXPECT_EQ(step(script::kWheelDrop.from_robot), script::kWheelDrop.to_robot);
  EXPECT_EQ(roomba_.status(), RoombaStatus::kModeLost);
  EXPECT_TRUE(roomba_.fresh()->wheel_drop_left);
  EXPECT_FALSE(roomba_.drive({.left_mps = 0.3, .right_mps = 0.3}));
  for (int i = 0; i < 100; ++i) {
    EXPECT_THAT(step(frame({.mode = 1})), IsEmpty());
  }
  roomba_.rearm();
  EXPECT_EQ(step(frame({.mode = 1})), script::kStartInSafeMode.to_robot);
  step(frame());
  EXPECT_EQ(roomba_.status(), RoombaStatus::kReady);
}

TEST_F(RoombaDriver, SeesThroughARobotThatReportsItsModeOneTooHigh) {
  Roomba roomba{link_, {.mode_report_offset = 1}};
  roomba.step(Instant{});
  link_.answer(frame({.mode = 3}));
  roomba.step(Instant{kTick});
  EXPECT_EQ(roomba.status(), RoombaStatus::kReady);
  EXPECT_EQ(roomba.fresh()->mode, oi::Mode::kSafe);
}

TEST_F(RoombaDriver, StopsTheWheelsBeforeItEndsTheInterface) {
  start();
  roomba_.shut_down();
  EXPECT_EQ(link_.said(), script::kShutDown.to_robot);
  EXPECT_THAT(step(frame()), IsEmpty());
  EXPECT_EQ(roomba_.status(), RoombaStatus::kShutDown);
}

TEST_F(RoombaDriver, TriesSpeedsAgainWhenTheLinkWasDown) {
  start();
  link_.unplug(true);
  EXPECT_FALSE(roomba_.drive({.left_mps = -0.2, .right_mps = 0.2}));
  EXPECT_EQ(roomba_.health().writes_refused, 1u);
  link_.unplug(false);
  EXPECT_TRUE(roomba_.drive({.left_mps = -0.2, .right_mps = 0.2}));
  EXPECT_EQ(link_.said(), script::kTurnLeft.to_robot);
}

TEST_F(RoombaDriver, GivesEncoderCountsAcrossTheWrap) {
  start();
  step(frame({.counts_left = 65530, .counts_right = 3}));
  const EncoderCounts before = *roomba_.fresh()->encoders;
  step(frame({.counts_left = 4, .counts_right = 65533}));
  const EncoderCounts now = *roomba_.fresh()->encoders;
  EXPECT_EQ(now.left - before.left, 10);
  EXPECT_EQ(now.right - before.right, -6);
}

class Roomba400Driver : public RoombaDriver {
 protected:
  Bytes poll_step(const Bytes& from_robot = {}) {
    link_.answer(from_robot);
    now_ += kTick;
    sci_.step(now_);
    return link_.said();
  }
  Roomba sci_{link_, {.interface = RoombaConfig::Interface::kSci}};
};

TEST_F(Roomba400Driver, StartsByControlPollsAndSaysWhatThisRobotCannotTell) {
  EXPECT_EQ(poll_step(), script::kSciStart.to_robot + script::kSciPoll.to_robot);
  EXPECT_EQ(poll_step(script::kSciPoll.from_robot), script::kSciPoll.to_robot);
  EXPECT_EQ(sci_.status(), RoombaStatus::kReady);
  ASSERT_THAT(sci_.fresh(), NotNull());
  EXPECT_EQ(sci_.fresh()->battery_mv, 16000);
  EXPECT_FALSE(sci_.fresh()->mode);
  EXPECT_FALSE(sci_.fresh()->encoders);
  EXPECT_FALSE(sci_.fresh()->light_bumper);
  EXPECT_EQ(sci_.fresh()->travel, Travel{});
}

TEST_F(Roomba400Driver, DrivesByVelocityAndRadius) {
  poll_step();
  poll_step(script::kSciPoll.from_robot);
  EXPECT_TRUE(sci_.drive({.left_mps = 0.2, .right_mps = 0.2}));
  EXPECT_EQ(link_.said(), script::kSciStraight.to_robot);
  EXPECT_TRUE(sci_.drive({.left_mps = -0.1, .right_mps = 0.1}));
  EXPECT_THAT(link_.said(), ElementsAre(137, 0, 100, 0, 1));
}

TEST_F(Roomba400Driver, AsksAgainWhenAnAnswerStaysIncompleteFor50Milliseconds) {
  poll_step();
  EXPECT_THAT(poll_step(Bytes(25, 0)), IsEmpty());
  EXPECT_THAT(poll_step(), IsEmpty());
  EXPECT_THAT(poll_step(), IsEmpty());
  EXPECT_EQ(poll_step(), script::kSciPoll.to_robot);
  EXPECT_EQ(sci_.health().bytes_skipped, 25u);
  poll_step(script::kSciPoll.from_robot);
  EXPECT_EQ(sci_.health().frames_good, 1u);
}

TEST_F(Roomba400Driver, CountsAnAnswerThatNoRobotCanMeanAsCorrupt) {
  poll_step();
  poll_step(Bytes(26, 0xFF));
  EXPECT_THAT(sci_.fresh(), IsNull());
  EXPECT_EQ(sci_.health().frames_corrupt, 1u);
}

TEST_F(Roomba400Driver, ConcludesFromAWheelDropThatTheRobotLeftSafeMode) {
  poll_step();
  poll_step(script::kSciPoll.from_robot);
  Bytes dropped = script::kSciPoll.from_robot;
  dropped[0] = 16;  // the castor
  poll_step(dropped);
  EXPECT_EQ(sci_.status(), RoombaStatus::kModeLost);
}

}  // namespace
}  // namespace sensotwin::robot
