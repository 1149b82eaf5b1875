// SPDX-License-Identifier: MIT
#include "robot/program/mapping_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "carpet_devices.hpp"
#include "robot/mapping/explorer_kind.hpp"
#include "tests/robot/drivers/roomba_transcripts.hpp"

namespace sensotwin::robot {
namespace {

using testing::compass_sentence;
using testing::FakeBase;
using testing::FakeReader;
using testing::FakeSerial;
using testing::KinematicCarpet;

constexpr std::uint32_t kMapId = 77;
constexpr std::uint8_t kSafeOpcode = 131;
constexpr std::uint8_t kFullOpcode = 132;
constexpr std::uint8_t kSafeMode = 2;
constexpr std::uint8_t kFullMode = 3;

/// The program, its four cables, and a drawn room at the far end of them. The base's light bumper is dark:
/// the room is felt by touch.
class MappingProgramOnWires : public ::testing::Test {
 protected:
  void steps(int n) {
    for (int i = 0; i < n; ++i) {
      step();
    }
  }
  void step() {
    const Sensed sensed = carpet_.step({.wheels = base_.obey(), .write = std::nullopt});
    base_.tell(sensed);
    floor_.in_field = carpet_.tag_in_field();
    if (sensed.compass_rad && compass_talks_) {
      sensors_.say(compass_sentence(*sensed.compass_rad));
    }
    program_.step(carpet_.now());
    left_safe_ = left_safe_ || base_.mode() == kFullMode;
  }
  /// Until so many tiles are known. \returns false when the mission ended before
  bool run_until_known(std::size_t tiles) {
    while (!program_.done() && program_.mission().map().visited_count() < tiles) {
      step();
    }
    return !program_.done();
  }
  /// \param limit_s  no room in these tests takes longer
  bool run(double limit_s = 600.0) {
    while (!program_.done() && to_s(carpet_.now()) < limit_s) {
      step();
    }
    return program_.done();
  }
  /// Rolls straight on, well away from the last tag.
  void run_until_rolling() {
    while (std::min(base_.wheels().left_mps, base_.wheels().right_mps) < 0.2) {
      ASSERT_FALSE(program_.done());
      step();
    }
  }
  void expect_whole_map() {
    EXPECT_TRUE(program_.mission().succeeded());
    EXPECT_EQ(program_.mission().map().visited_count(), carpet_.tags().size());
    for (const Tile tile : carpet_.tags()) {
      const Tile in_M{tile.column - carpet_.start().column, tile.row - carpet_.start().row};
      const TagUid uid = KinematicCarpet::uid(tile);
      EXPECT_EQ(program_.mission().map().tag_on(in_M), uid);
      const auto record = decode_tag_record(floor_.memory(uid));
      ASSERT_TRUE(record.has_value()) << "column " << tile.column << ", row " << tile.row;
      const CarpetRecord expected{.map_id = kMapId,
                                  .column = static_cast<std::int16_t>(in_M.column),
                                  .row = static_cast<std::int16_t>(in_M.row)};
      EXPECT_EQ(std::get<CarpetRecord>(*record), expected);
    }
  }
  static MappingProgramConfig config() {
    MappingProgramConfig config;
    config.map_id = kMapId;
    return config;
  }

  KinematicCarpet carpet_{{"....", "....", "S..."}, {}, 1};
  FakeBase base_;
  FakeReader floor_;
  FakeReader forward_;
  FakeSerial sensors_;
  bool compass_talks_{true};
  bool left_safe_{false};
  MappingProgram program_{
      {base_.serial, floor_, forward_, sensors_}, config(), make_explorer(ExplorerKind::kIdfm)};
};

TEST_F(MappingProgramOnWires, SaysTheStartAndStandsUntilTheRobotAnswers) {
  base_.mute = true;
  step();
  EXPECT_EQ(base_.serial.heard(), transcripts::kStartInSafeMode.to_robot);
  step();
  EXPECT_TRUE(base_.serial.heard().empty());
  EXPECT_FALSE(program_.state().has_value());
}

TEST_F(MappingProgramOnWires, MapsARoomAndWritesItsTagsOverBytesAlone) {
  ASSERT_TRUE(run());
  expect_whole_map();
  EXPECT_EQ(base_.times_said(kSafeOpcode), 1);
  EXPECT_EQ(base_.times_said(kFullOpcode), 0);
  EXPECT_EQ(program_.mission().counts().writes_failed, 0);
  EXPECT_EQ(program_.base().health().frames_corrupt, 0u);
}

TEST_F(MappingProgramOnWires, StopsTheWheelsWhenTheStreamIsLostAndGoesOnWhenItIsBack) {
  ASSERT_TRUE(run_until_known(1));
  run_until_rolling();
  base_.mute = true;
  steps(8);  // 120 ms; the driver waits 100
  EXPECT_EQ(base_.wheels(), WheelSpeeds{});
  EXPECT_EQ(program_.base().status(), RoombaStatus::kStreamLost);
  steps(60);
  EXPECT_EQ(base_.wheels(), WheelSpeeds{});
  base_.mute = false;
  ASSERT_TRUE(run());
  expect_whole_map();
}

TEST_F(MappingProgramOnWires, LosesNoWayByCorruptFrames) {
  base_.spoil_every = 5;
  ASSERT_TRUE(run());
  expect_whole_map();
  EXPECT_GT(program_.base().health().frames_corrupt, 100u);
  EXPECT_EQ(program_.mission().counts().moves_missed, 0);
}

TEST_F(MappingProgramOnWires, GoesOnWhenTheReaderWasUnpluggedForAWhile) {
  ASSERT_TRUE(run_until_known(2));
  floor_.plugged = false;
  steps(70);  // a second
  EXPECT_FALSE(program_.floor_reader().health().connected);
  floor_.plugged = true;
  ASSERT_TRUE(run());
  expect_whole_map();
  EXPECT_EQ(program_.floor_reader().health().vanished, 1u);
  EXPECT_EQ(program_.floor_reader().health().returned, 1u);
}

TEST_F(MappingProgramOnWires, FailsButEndsWhenTheReaderNeverComesBack) {
  ASSERT_TRUE(run_until_known(2));
  floor_.plugged = false;
  ASSERT_TRUE(run(7200.0)) << "it searches far around before it gives up";
  EXPECT_FALSE(program_.mission().succeeded());
  steps(2);
  EXPECT_EQ(base_.wheels(), WheelSpeeds{});
}

TEST_F(MappingProgramOnWires, MapsWithoutAWordFromTheCompass) {
  compass_talks_ = false;
  ASSERT_TRUE(run());
  expect_whole_map();
  EXPECT_FALSE(program_.sensor_board().compass().has_value());
}

TEST_F(MappingProgramOnWires, MapsWhenTheCompassFallsSilentOnTheWay) {
  ASSERT_TRUE(run_until_known(3));
  compass_talks_ = false;
  ASSERT_TRUE(run());
  expect_whole_map();
  EXPECT_EQ(program_.sensor_board().health().went_stale, 1u);
}

TEST_F(MappingProgramOnWires, LeavesAHomeBaseInFullModeAndIsSafeAgainAfterwards) {
  base_.docked = true;
  const Vec2 home = carpet_.X_WR().p_m;
  while (base_.docked && to_s(carpet_.now()) < 60.0) {
    step();
    base_.docked = (carpet_.X_WR().p_m - home).norm() < 0.05;
  }
  ASSERT_FALSE(base_.docked) << "it must drive off";
  EXPECT_TRUE(left_safe_);
  steps(100);
  EXPECT_EQ(base_.mode(), kSafeMode);
  ASSERT_TRUE(run());
  expect_whole_map();
  EXPECT_EQ(base_.times_said(kFullOpcode), 1);
}

TEST_F(MappingProgramOnWires, WaitsWhileItIsLiftedAndGoesOnWhenPutDown) {
  ASSERT_TRUE(run_until_known(2));
  run_until_rolling();
  base_.lifted = true;
  steps(100);
  EXPECT_EQ(base_.wheels(), WheelSpeeds{});
  EXPECT_EQ(program_.base().status(), RoombaStatus::kModeLost);
  EXPECT_EQ(base_.times_said(kSafeOpcode), 1) << "it is not armed while a wheel hangs";
  base_.lifted = false;
  steps(20);
  EXPECT_EQ(base_.mode(), kSafeMode);
  ASSERT_TRUE(run());
  EXPECT_TRUE(program_.mission().succeeded());
}

/// Puts a tag before the forward antenna for long enough to be read, and takes it away.
class ForwardReader : public MappingProgramOnWires {
 protected:
  void pass(TagUid uid) {
    forward_.in_field = uid;
    steps(10);
    forward_.in_field.reset();
    steps(5);
  }
  template <class Record>
  void holds(TagUid uid, const Record& record) {
    const auto bytes = encode(record);
    std::copy(bytes.begin(), bytes.end(), forward_.memory(uid).begin());
  }
  static constexpr TagUid kSocket = 0xE004'0100'0000'AAAAu;
  static constexpr TagUid kChair = 0xE004'0100'0000'BBBBu;
};

TEST_F(ForwardReader, ReportsEachObjectOnceHoweverOftenItIsSeen) {
  holds(kSocket, LandmarkRecord{LandmarkKind::kPowerOutlet});
  holds(kChair, ObjectRecord{.category = 3, .length = 40, .width = 45, .color = 2});
  for (const TagUid uid : {kSocket, kChair, kSocket, kSocket, kChair}) {
    pass(uid);
  }
  const std::vector<ObjectSeen> seen = program_.take_objects();
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0].tag, kSocket);
  EXPECT_EQ(seen[0].record, TagRecord{LandmarkRecord{LandmarkKind::kPowerOutlet}});
  EXPECT_EQ(seen[1].tag, kChair);
  EXPECT_EQ(std::get<ObjectRecord>(seen[1].record).length, 40);
  EXPECT_LT(seen[0].stamp, seen[1].stamp);
  pass(kChair);
  EXPECT_TRUE(program_.take_objects().empty());
}

TEST_F(ForwardReader, ReportsNoTagOfTheCarpetAndNoBlankOne) {
  holds(kSocket, CarpetRecord{.map_id = kMapId, .column = 1, .row = 0});
  pass(kSocket);
  pass(kChair);  // blank
  EXPECT_TRUE(program_.take_objects().empty());
}

TEST_F(ForwardReader, TellsWhereTheRobotWasWhenItSawTheObject) {
  holds(kSocket, LandmarkRecord{LandmarkKind::kPowerOutlet});
  ASSERT_TRUE(run_until_known(2));
  run_until_rolling();
  const Vec2 start = KinematicCarpet::centre_m(carpet_.start());
  const Vec2 before = carpet_.X_WR().p_m - start;
  pass(kSocket);
  const std::vector<ObjectSeen> seen = program_.take_objects();
  ASSERT_EQ(seen.size(), 1u);
  // Four steps of identification and reading at 0.3 m/s, and what the pose is known to.
  EXPECT_LT((seen[0].X_MR.p_m - before).norm(), 4 * 0.0045 + 0.03);
}

}  // namespace
}  // namespace sensotwin::robot
