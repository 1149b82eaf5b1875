// SPDX-License-Identifier: MIT
// Faults on the wires, end to end: the robot's program notices and counts them, and the carpet's map stays
// right.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "mapping_case.hpp"
#include "twin/run/map_verdict.hpp"
#include "twin/run/mapping_twin.hpp"
#include "twin/run/recovered_map.hpp"

namespace sensotwin::twin {
namespace {

/// How a serial line goes wrong.
struct SerialFaults {
  double flip_in{0.0};   ///< chance that a byte to the program has one bit turned
  double lose_in{0.0};   ///< chance that a byte to the program is lost
  double lose_out{0.0};  ///< chance that a byte to the device is lost
};

class FaultySerial final : public robot::ByteLink {
 public:
  FaultySerial(robot::ByteLink& inner, const SerialFaults& faults, robot::RandomStream random)
      : inner_(inner), faults_(faults), random_(random) {}

  int spoilt{0};
  bool cut{false};  ///< the cable is out: nothing comes, nothing goes

 private:
  bool do_write(robot::ByteView bytes) override {
    if (cut) {
      return false;
    }
    std::vector<std::uint8_t> through;
    for (const std::uint8_t byte : bytes) {
      if (random_.chance(faults_.lose_out)) {
        ++spoilt;
      } else {
        through.push_back(byte);
      }
    }
    return inner_.write(through);
  }
  std::size_t do_read(std::span<std::uint8_t> into) override {
    std::size_t count = inner_.read(into);
    if (cut) {
      return 0;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (random_.chance(faults_.lose_in)) {
        ++spoilt;
        continue;
      }
      if (random_.chance(faults_.flip_in)) {
        into[i] = static_cast<std::uint8_t>(into[i] ^ (1u << random_.below(8)));
        ++spoilt;
      }
      into[kept++] = into[i];
    }
    return kept;
  }
  [[nodiscard]] bool do_is_up() const override { return !cut && inner_.is_up(); }

  robot::ByteLink& inner_;
  SerialFaults faults_;
  robot::RandomStream random_;
};

/// A card reader some of whose exchanges end without an answer.
class FaultyReader final : public robot::CardLink {
 public:
  FaultyReader(robot::CardLink& inner, double fail, robot::RandomStream random)
      : inner_(inner), fail_(fail), random_(random) {}

  int spoilt{0};

 private:
  robot::CardPresence do_presence() override { return inner_.presence(); }
  bool do_begin(robot::ByteView command) override { return inner_.begin(command); }
  std::optional<robot::Result<robot::Bytes, robot::CardError>> do_poll() override {
    auto answer = inner_.poll();
    if (answer && random_.chance(fail_)) {
      ++spoilt;
      return robot::Unexpected{robot::CardError::kTimeout};
    }
    return answer;
  }

  robot::CardLink& inner_;
  double fail_;
  robot::RandomStream random_;
};

struct Faults {
  SerialFaults base{};
  SerialFaults compass{};
  double reader{0.0};
};

/// The lesson with faults on its wires.
class FaultyLesson {
 public:
  explicit FaultyLesson(const Faults& faults) : scene_(published("lesson_2x2")) {
    const robot::RandomStream random(99);
    twin_.emplace(scene_, [&](const robot::MappingLinks& links) -> robot::MappingLinks {
      base_.emplace(links.base, faults.base, random.fork("base"));
      compass_.emplace(links.sensors, faults.compass, random.fork("compass"));
      reader_.emplace(links.floor_reader, faults.reader, random.fork("reader"));
      return {*base_, *reader_, links.forward_reader, *compass_};
    });
  }

  void run_until(double until_s) {
    while (!twin_->done() && robot::to_s(twin_->now()) < until_s) {
      twin_->tick();
    }
  }
  [[nodiscard]] MapVerdict verdict() const {
    return judge_map(twin_->world().tags(), twin_->map_id(), placement_of(scene_, *twin_), {});
  }
  [[nodiscard]] const robot::LinkHealth& base_health() const { return twin_->program().base().health(); }

  MappingTwin& twin() { return *twin_; }
  FaultySerial& base() { return *base_; }
  FaultySerial& compass() { return *compass_; }
  FaultyReader& reader() { return *reader_; }

 private:
  Scene scene_;
  std::optional<FaultySerial> base_;
  std::optional<FaultySerial> compass_;
  std::optional<FaultyReader> reader_;
  std::optional<MappingTwin> twin_;
};

TEST(FaultyWires, WithoutFaultsChangeNothing) {
  FaultyLesson lesson({});
  lesson.run_until(900.0);
  EXPECT_EQ(lesson.twin().hash().text(), run_of(published("lesson_2x2")).state_hash);
}

TEST(FaultyWires, ThatTurnBitsOfTheStreamCostFramesAndNoTile) {
  FaultyLesson lesson({.base = {.flip_in = 1e-3}});
  lesson.run_until(900.0);
  EXPECT_GT(lesson.base().spoilt, 0);
  EXPECT_GT(lesson.base_health().frames_corrupt, 0u);
  EXPECT_EQ(lesson.verdict().mapped, 16);
  EXPECT_EQ(lesson.verdict().wrong, 0);
}

TEST(FaultyWires, ThatLoseBytesBothWaysCostTimeAndNoTile) {
  FaultyLesson lesson({.base = {.lose_in = 5e-4, .lose_out = 5e-4}});
  lesson.run_until(900.0);
  EXPECT_GT(lesson.base().spoilt, 0);
  EXPECT_EQ(lesson.verdict().mapped, 16);
  EXPECT_EQ(lesson.verdict().wrong, 0);
}

TEST(FaultyWires, ThatLoseOneByteInAHundredBothWaysCostTimeAndNoTile) {
  FaultyLesson lesson({.base = {.lose_in = 0.01, .lose_out = 0.01}, .compass = {.lose_in = 0.01}});
  lesson.run_until(900.0);
  EXPECT_GT(lesson.base_health().frames_corrupt, lesson.base_health().frames_good);
  EXPECT_EQ(lesson.verdict().mapped, 16);
  EXPECT_EQ(lesson.verdict().wrong, 0);
}

// Some of these frames pass their sum: a driver that believed them would map 1 tile of 16, and 13 wrongly.
TEST(FaultyWires, ThatBendOneByteInAHundredCostTimeAndNoTile) {
  FaultyLesson lesson({.base = {.flip_in = 0.01}, .compass = {.flip_in = 0.01}});
  lesson.run_until(900.0);
  EXPECT_GT(lesson.base_health().frames_corrupt, lesson.base_health().frames_good);
  EXPECT_EQ(lesson.verdict().mapped, 16);
  EXPECT_EQ(lesson.verdict().wrong, 0);
}

TEST(FaultyWires, ThatSpoilAFifthOfTheCardExchangesCostNoTile) {
  FaultyLesson lesson({.reader = 0.2});
  lesson.run_until(900.0);
  EXPECT_GT(lesson.reader().spoilt, 0);
  EXPECT_EQ(lesson.verdict().mapped, 16);
  EXPECT_EQ(lesson.verdict().wrong, 0);
}

TEST(FaultyWires, ThatGarbleTheCompassAreCountedAndCostNoTile) {
  FaultyLesson lesson({.compass = {.flip_in = 5e-3}});
  lesson.run_until(900.0);
  EXPECT_GT(lesson.twin().program().sensor_board().health().bad_checksum, 0);
  EXPECT_EQ(lesson.verdict().mapped, 16);
  EXPECT_EQ(lesson.verdict().wrong, 0);
}

TEST(FaultyWires, CutFromTheCompassLeaveTagsAndWheelsToSteerBy) {
  FaultyLesson lesson({});
  lesson.compass().cut = true;
  lesson.run_until(900.0);
  EXPECT_EQ(lesson.verdict().mapped, 16);
  EXPECT_EQ(lesson.verdict().wrong, 0);
}

// The machine itself drives on when its cable is out: nobody can tell it to stop. What it may not do is to
// write wrong coordinates afterwards.
TEST(FaultyWires, PulledFromTheRoombaForASecondNeverMakeTheMapWrong) {
  FaultyLesson lesson({});
  lesson.run_until(20.0);
  lesson.base().cut = true;
  lesson.run_until(21.0);
  lesson.base().cut = false;
  lesson.run_until(900.0);
  EXPECT_EQ(lesson.verdict().wrong, 0);
  EXPECT_GT(lesson.base_health().frames_missed, 60u);
}

}  // namespace
}  // namespace sensotwin::twin
