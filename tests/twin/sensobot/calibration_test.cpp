// SPDX-License-Identifier: MIT
// The program of `sensobot calibrate` in worlds whose robots are not what they are told to be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "calibration_bench.hpp"
#include "robot/calibration/calibration_report.hpp"
#include "robot/settings/robot_file.hpp"
#include "tests/robot/output/temporary_folder.hpp"
#include "twin/run/mapping_twin.hpp"
#include "twin/run/phase_config.hpp"
#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::HasSubstr;

/// A carpet of 4 m by 4 m; the robot on it has another base than 0.235 m and wheels that differ by some
/// tenths of a percent, as a seed draws them. What it is told are the defaults.
Scene carpet(std::uint64_t seed, const std::vector<std::string>& set = {}) {
  return read_scene_text(R"(version: 1
world:
  room: { walls_m: [[0, 0], [4.064, 0], [4.064, 4.064], [0, 4.064]] }
  carpet: { tile_m: 0.508 }
robot:
  base: { wheel_base_m: 0.245, wheel_diameter_m: 0.0731, wheel_diameter_sigma: 0.005, wheel_base_sigma: 0.01 }
  start: { at_m: [1.27, 1.27], heading_deg: 2 }
mission:
  map: { explorer: sweep }
)",
                         "carpet.yaml", {.set = set, .seed = seed});
}

robot::RobotSettings told_of(const Scene& scene) {
  robot::RobotSettings told = robot_settings_of(scene, 1);
  told.base = {};
  return told;
}

TEST(Calibration, FindsWheelsThatAreNotAsTheyWereToldByLapsBothWaysRound) {
  double before_m = 0.0;
  double after_m = 0.0;
  constexpr int kSeeds = 8;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Scene scene = carpet(seed);
    CalibrationTwin twin(scene, told_of(scene), {});
    const robot::CalibrationResult& result = twin.run();
    ASSERT_EQ(result.fault, "") << seed;
    ASSERT_TRUE(result.wheels && result.turned_base_m) << seed;
    EXPECT_TRUE(twin.stands()) << seed;
    const robot::WheelFit& fit = *result.wheels;
    const TrueWheels& truth = twin.truth();
    const double diameter_m = fit.metres_per_count.value * 508.8 / robot::kPi;
    SCOPED_TRACE(robot::calibration_json(result, told_of(scene)));
    // Told 4 % wrong. Tags are laid by 5 mm, which is half a percent of the square's side.
    EXPECT_NEAR(fit.wheel_base_m.value / truth.base_m(), 1.0, 0.01) << seed;
    EXPECT_NEAR(diameter_m / truth.mean_diameter_m(), 1.0, 0.01) << seed;
    EXPECT_NEAR(fit.wheel_ratio.value / truth.ratio(), 1.0, 0.003) << seed;
    EXPECT_LT(std::abs(fit.wheel_base_m.value - truth.base_m()), 3.0 * fit.wheel_base_m.sigma) << seed;
    EXPECT_LT(std::abs(fit.wheel_ratio.value - truth.ratio()), 3.0 * fit.wheel_ratio.sigma) << seed;
    EXPECT_NEAR(result.turned_base_m->value / truth.base_m(), 1.0, 0.01) << seed;
    EXPECT_NEAR(fit.read_radius_m.value, 0.08, 0.003) << seed;
    before_m += fit.closure.before_m;
    after_m += fit.closure.after_m;
  }
  RecordProperty("closure_before_mm", std::to_string(1e3 * before_m / kSeeds));
  RecordProperty("closure_after_mm", std::to_string(1e3 * after_m / kSeeds));
  // What the carpet adds anew in each lap stays.
  EXPECT_LT(after_m, 0.5 * before_m);
}

TEST(Calibration, ItsFragmentIsTakenByARunUnchangedAndClosesTheNextLaps) {
  const Scene scene = carpet(11);
  const robot::RobotSettings told = told_of(scene);
  CalibrationTwin first(scene, told, {});
  const robot::CalibrationResult& result = first.run();
  ASSERT_EQ(result.fault, "");
  const TemporaryFolder folder;
  std::ofstream(folder / "measured.yaml") << robot::calibration_yaml(result, told, "a test");
  const robot::RobotFile robot = robot::read_robot_text(
      "version: 1\ndevices: { base: a, sensors: b, card_readers: [c] }\n"
      "robot: { base: { wheel_base_m: 0.3, speed_max_mps: 0.4 }, floor_reader: { blocks_per_command: 1 } }\n",
      "robot.yaml", {}, robot::RobotFileUse::kRun, folder / "measured.yaml");
  EXPECT_NEAR(robot.settings.base.wheel_base_m, result.wheels->wheel_base_m.value, 1e-5);
  EXPECT_NEAR(robot.settings.base.wheel_ratio, result.wheels->wheel_ratio.value, 1e-5);
  EXPECT_EQ(robot.settings.base.speed_max_mps, 0.4) << "what was not measured stays";
  EXPECT_EQ(robot.settings.floor_reader.blocks_per_command, 1);
  CalibrationTwin second(scene, robot.settings, {.turns = 0});
  const robot::CalibrationResult& again = second.run();
  ASSERT_EQ(again.fault, "");
  EXPECT_LT(again.wheels->closure.before_m, 0.6 * result.wheels->closure.before_m);
  EXPECT_THAT(robot::calibration_text(result, told), HasSubstr("a lap closes within"));
}

struct Mishap {
  const char* name;
  std::vector<std::string> set;
  robot::CalibrationPlan plan;
  const char* said;
};

TEST(Calibration, EndsWithWordsAndStandingWheelsWhenItCannotBe) {
  const Mishap mishaps[] = {
      {"between tags", {"robot.start.at_m=[1.524,1.524]"}, {.turns = 0}, "no tag was read within a metre"},
      {"a tag is missing",
       {"world.carpet.without=[[3, 2]]"},
       {.turns = 0},
       "found no tag on the way to the tag 0.51 m ahead of the first and 0.00 m to its left"},
      {"something in the way",
       {"world.furniture=[{ name: box, at_m: [2.28, 1.27], size_m: [0.2, 0.4], mass_kg: 80 }]"},
       {.turns = 0},
       "it touched something"},
  };
  for (const Mishap& mishap : mishaps) {
    SCOPED_TRACE(mishap.name);
    const Scene scene = carpet(3, mishap.set);
    CalibrationTwin twin(scene, told_of(scene), mishap.plan);
    const robot::CalibrationResult& result = twin.run();
    EXPECT_TRUE(twin.done());
    EXPECT_THAT(result.fault, HasSubstr(mishap.said));
    EXPECT_EQ(robot::calibration_yaml(result, told_of(scene), "a test"), "");
    EXPECT_TRUE(twin.stands());
  }
}

/// Two antennas under a ceiling tag: their cables are not what the robot is told.
Scene under_a_tag(std::uint64_t seed, const std::string& profile) {
  return read_scene_text(R"(version: 1
world:
  room: { walls_m: [[-3, -3], [3, -3], [3, 3], [-3, 3]] }
  carpet: none
  floor: { nap_drift: 0, roughness: 0.003, rolling_resistance: 0.01 }
  ceiling_tags: [{ name: A, at_m: [0.1, 0.05] }]
  radio: { profile: )" + profile +
                             R"( }
robot:
  uhf_reader:
    antennas:
      - { at_m: [0, 0.1, 0.1], cable_delay_s: 4.1e-8 }
      - { at_m: [0, -0.1, 0.1], cable_delay_s: 4.35e-8 }
  start: { at_m: [0, 0], heading_deg: 30 }
mission:
  phase: { controller: own, destinations: [A] }
)",
                         "tag.yaml", {.seed = seed});
}

class CableCalibration : public testing::TestWithParam<const char*> {};

TEST_P(CableCalibration, FindsOffsetsAndDelaysByTurningUnderATag) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Scene scene = under_a_tag(seed, GetParam());
    const world::RadioWorld radio = radio_of(scene, robot::RandomStream(scene.seed));
    robot::RobotSettings told = robot_settings_of(scene, radio);
    for (robot::AntennaMount& antenna : told.uhf_reader.antennas) {
      antenna.cable_delay_s = 0.0;
    }
    CalibrationTwin twin(scene, told, {.turns = 0, .laps = 0, .spins = 2});
    const robot::CalibrationResult& result = twin.run();
    ASSERT_EQ(result.fault, "") << seed;
    EXPECT_TRUE(twin.stands());
    SCOPED_TRACE(robot::calibration_text(result, told) + robot::calibration_json(result, told));
    const robot::FittedPort& second = result.antennas->ports[1];
    const double turns = told.uhf_reader.centre_hz * (4.35e-8 - 4.1e-8);
    const double true_rad = told.uhf_reader.phase_sign * 2.0 * robot::kPi * turns;
    const double period_rad = told.uhf_reader.pi_ambiguous ? robot::kPi : 2.0 * robot::kPi;
    const double off_rad = std::remainder(second.phase_offset_rad.value - true_rad, period_rad);
    EXPECT_LT(std::abs(off_rad), 3.0 * second.phase_offset_rad.sigma) << seed;
    EXPECT_LT(second.phase_offset_rad.sigma, 0.35) << seed;
    if (result.antennas->delays_known) {
      for (const robot::FittedPort& port : result.antennas->ports) {
        const double true_s = port.port == 1 ? 4.1e-8 : 4.35e-8;
        EXPECT_NEAR(port.cable_delay_s.value, true_s, 3.0 * port.cable_delay_s.sigma) << seed;
        EXPECT_LT(port.cable_delay_s.sigma, 4e-9) << seed;
      }
    }
    EXPECT_EQ(result.antennas->delays_known, std::string{GetParam()} == "impinj_r420");
  }
}

INSTANTIATE_TEST_SUITE_P(OfReader, CableCalibration, testing::Values("paper", "impinj_r420"),
                         [](const auto& profile) { return std::string{profile.param}; });

TEST(CablesThatCannotBeMeasured, AreSaidToBelongToATagThatWasNotHeard) {
  const Scene scene = under_a_tag(1, "paper");
  robot::RobotSettings told = robot_settings_of(scene, radio_of(scene, robot::RandomStream(scene.seed)));
  told.ceiling_tags.front().epc.bytes[0] ^= 1u;
  CalibrationTwin twin(scene, told, {.turns = 0, .laps = 0, .spins = 2});
  EXPECT_THAT(twin.run().fault, HasSubstr("the ceiling tag 'A' was not read"));
  EXPECT_TRUE(twin.stands());
}

}  // namespace
}  // namespace sensotwin::twin
