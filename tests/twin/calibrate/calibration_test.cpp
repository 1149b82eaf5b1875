// SPDX-License-Identifier: MIT
// Truth that was put into a simulated reader is what calibration finds in its logs.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "robot/config/problem.hpp"
#include "simulated_logs.hpp"
#include "twin/calibrate/calibration_chart.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::HasSubstr;

const std::vector<double> kNearAndFar_m = {0.5, 0.8, 1.2, 2.0, 3.0, 5.0, 8.0, 12.0, 18.0};

TEST(Calibration, FindsTheNoiseLawByRssi) {
  const auto found = calibrated(series_of(plain_r420(), kNearAndFar_m, 25.0).input);
  ASSERT_TRUE(found && found->noise.by_rssi);
  const auto& law = found->noise.by_rssi->parameters;
  // 1024 steps a turn add 0.0061 / sqrt(12) to the floor of 0.0078: 0.0080.
  EXPECT_NEAR(law[0].value, 0.0080, 0.0004);
  EXPECT_NEAR(law[1].value, 0.0155, 0.0008);
  EXPECT_LT(law[1].high - law[1].low, 0.004);
  EXPECT_GT(found->noise.by_rssi->r_squared, 0.98);
  EXPECT_EQ(found->noise.left_out_share, 1.0);
}

TEST(Calibration, FindsNoiseProportionalToDistanceAndSaysThatRssiDoesNotExplainIt) {
  world::RadioDescription radio = plain_r420();
  radio.noise_law = world::NoiseLaw::kProportional;
  radio.noise_per_m_rad = 0.024;
  const auto found = calibrated(series_of(radio, {0.5, 1.0, 1.5, 2.0, 2.5, 3.0}, 15.0).input);
  ASSERT_TRUE(found && found->noise.proportional && found->noise.offset);
  EXPECT_NEAR(found->noise.proportional->parameters[0].value, 0.024, 0.001);
  EXPECT_GT(found->noise.proportional->r_squared, 0.99);
  radio.noise_law = world::NoiseLaw::kOffset;
  radio.noise_floor_rad = 0.012;
  radio.noise_per_m_rad = 0.02;
  const auto offset = calibrated(series_of(radio, {0.3, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0}, 15.0).input);
  ASSERT_TRUE(offset && offset->noise.offset);
  EXPECT_NEAR(offset->noise.offset->parameters[0].value, 0.012, 0.0015);
  EXPECT_NEAR(offset->noise.offset->parameters[1].value, 0.02, 0.0015);
  EXPECT_LT(offset->noise.offset->spread, offset->noise.proportional->spread);
}

TEST(Calibration, FindsTheCurveOfFlips) {
  world::RadioDescription radio = plain_r420();
  radio.cutoff_dbm = -75.0;
  std::vector<double> distances_m;
  for (double dbm = -58.0; dbm >= -74.0; dbm -= 1.0) {
    distances_m.push_back(std::pow(10.0, (dbm - radio.rssi_at_1m_dbm) / radio.rssi_slope_db));
  }
  const auto found = calibrated(series_of(radio, distances_m, 30.0).input);
  ASSERT_TRUE(found && found->flips.rssi_dbm);
  EXPECT_NEAR(found->flips.rssi_dbm->value, -72.2, 1.0);
  EXPECT_NEAR(found->flips.width_db->value, 2.52, 0.5);
  // Whole dBm, cut, hide half a decibel.
  EXPECT_LT(found->flips.rssi_dbm->low, -72.2 + 0.5);
  EXPECT_GT(found->flips.rssi_dbm->high, -72.2 - 0.5);
}

TEST(Calibration, FindsHopTableDelayAndCableFromPhasesAlone) {
  const Series series = series_of(plain_r420(), {0.5, 0.9, 1.4, 1.8, 2.3, 2.7, 3.1}, 25.0);
  const auto found = calibrated(series.input);
  ASSERT_TRUE(found && found->recovered);
  EXPECT_EQ(found->channels_hz, series.radio.channels_hz);
  EXPECT_GT(found->strong_coherence->value, 0.99);
  EXPECT_EQ(found->linear_share, 1.0);
  EXPECT_NEAR(found->cable_delay_s.at(1).value, kCable_s, 0.5e-9);
  EXPECT_NEAR(found->delay_s.at(1).value, kCable_s + 2.0 * 1.814 / 299'792'458.0, 0.5e-9);
}

TEST(Calibration, TellsTheSignFromAPublishedHopTable) {
  for (const double sign : {-1.0, 1.0}) {
    world::RadioDescription radio = world::impinj_r420_radio(robot::RandomStream{5}, 1);
    radio.phase_sign = sign;
    Series series = series_of(radio, {0.5, 1.0, 2.0}, 15.0);
    series.input.channels_hz = radio.channels_hz;
    const auto found = calibrated(series.input);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->phase_sign, sign);
    EXPECT_GT(std::max(*found->rising_coherence, *found->falling_coherence), 0.95);
    EXPECT_LT(std::min(*found->rising_coherence, *found->falling_coherence), 0.5);
  }
}

TEST(Calibration, FindsDwellDeadTimeStepsDopplerAndRssi) {
  const auto found = calibrated(series_of(plain_r420(), {0.6, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0}, 20.0).input);
  ASSERT_TRUE(found);
  const ReaderTiming& timing = found->timings.at(0);
  EXPECT_NEAR(timing.slot_s.at(1).value, 0.01402, 1e-5);
  EXPECT_NEAR(timing.dwell_s->value, 0.20335, 0.002);
  EXPECT_NEAR(timing.hop_dead_s->value, 0.006, 1e-4);
  EXPECT_NEAR(timing.reads_per_s->value, 69.7, 1.0);
  EXPECT_EQ(timing.out_of_order_share, 0.0);
  EXPECT_EQ(found->phase_steps, 1024);
  EXPECT_NEAR(found->doppler->bias_hz.value, 9.75, 1.0);
  EXPECT_NEAR(found->doppler->floor_hz.value, 6.6, 0.7);
  EXPECT_NEAR(found->doppler->at_50dbm_hz.value, 8.8, 0.9);
  EXPECT_NEAR(found->rssi->at_1m_dbm.value, -34.75, 0.3) << "half-decibel steps, cut to whole ones";
  EXPECT_NEAR(found->rssi->slope_db.value, -22.2, 0.6);
}

TEST(Calibration, FindsSlotsAndSharesOfFourPortsAndTheBurstOfManyTags) {
  world::RadioWorld world = tag_above(world::impinj_r420_radio(robot::RandomStream{5}, 4), 1.0);
  world.radio.place_sigma_db = 0.0;
  for (int i = 0; i < 3; ++i) {
    world.antennas.push_back(world.antennas[0]);
  }
  CalibrationInput input;
  input.logs.push_back(simulated_log(world, 20.0, "four ports"));
  for (std::uint8_t i = 1; i < 6; ++i) {
    world.tags.push_back(world.tags[0]);
    world.tags.back().name = std::to_string(i);
    world.tags.back().epc.bytes[0] = i;
  }
  input.logs.push_back(simulated_log(world, 20.0, "six tags"));
  input.distance_m.resize(2);
  const auto found = calibrated(input);
  ASSERT_TRUE(found);
  const ReaderTiming& timing = found->timings.at(0);
  EXPECT_NEAR(timing.slot_s.at(1).value, 0.0289, 0.0005);
  EXPECT_NEAR(timing.slot_s.at(3).value, 0.0310, 0.0005);
  EXPECT_NEAR(timing.slot_s.at(4).value, 0.0140, 0.0005);
  EXPECT_NEAR(timing.port_share.at(2), 0.25, 0.02);
  EXPECT_NEAR(timing.per_tag_s->value, 0.0007, 1e-5);
}

TEST(Calibration, SetsTheChannelsOfAccumulatingReportsRight) {
  world::RadioWorld world = tag_above(plain_r420(), 2.0);
  world.radio.slots_s = {0.029, 0.029, 0.031, 0.014};
  for (int i = 0; i < 3; ++i) {
    world.antennas.push_back(world.antennas[0]);
  }
  world.antennas[1].boresight = {0.0, 0.0, -1.0};  // hears nothing: the others' rows are updated
  world.radio.report_every = 4;
  world.radio.accumulate_reads = true;
  CalibrationInput input;
  input.logs.push_back(simulated_log(world, 60.0, "four ports"));
  input.distance_m.resize(1);
  input.channels_hz = world.radio.channels_hz;
  const auto found = calibrated(input);
  ASSERT_TRUE(found);
  EXPECT_GT(found->timings.at(0).out_of_order_share, 0.1) << "data study, 3.9: 12 to 28 %";
  EXPECT_GT(found->stale_channels, found->reads / 50);
  EXPECT_GT(found->strong_coherence.value_or(Estimate{1.0, 1.0, 1.0}).value, 0.9);
}

TEST(Calibration, WritesAProfileWithKeysOfTheRadioDescriptionAndTheSameReportTwice) {
  const Series series = series_of(plain_r420(), {0.5, 1.0, 1.5, 2.0, 3.0}, 15.0);
  const auto found = calibrated(series.input);
  const auto again = calibrated(series.input);
  ASSERT_TRUE(found && again);
  const std::string profile = to_profile(*found);
  for (const char* key : {"radio:\n  profile: impinj_r420\n", "  channels_hz: [", "  phase_sign: -1\n",
                          "  noise_law: rssi\n", "  noise_floor_rad: 0.00", "  slots_s: [0.01402]\n",
                          "  dwell_s: 0.20", "  phase_steps: 1024\n", "cable_delay_s: 6.0"}) {
    EXPECT_THAT(profile, HasSubstr(key));
  }
  EXPECT_EQ(to_json(*found), to_json(*again));
  const auto json = nlohmann::json::parse(to_json(*found));
  EXPECT_EQ(json["frequency"]["channels_hz"].size(), 50U);
  EXPECT_EQ(json["noise"]["links"].size(), 5U);
  EXPECT_THAT(to_table(*found), HasSubstr("Hop table recovered from 5 strong links"));
}

TEST(Calibration, DrawsItsReport) {
  const auto found = calibrated(series_of(plain_r420(), {0.5, 1.0, 2.0, 3.0}, 15.0).input);
  ASSERT_TRUE(found);
  const auto picture = draw_calibration(*found);
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->height_px(), 2000);
}

TEST(Calibration, RefusesAChannelBeyondTheBandAndStopsWhenTold) {
  Series series = series_of(plain_r420(), {0.5}, 11.0);
  CalibrationSettings settings;
  settings.band.channels = 16;
  EXPECT_THROW((void)calibrated(series.input, settings), robot::LoadError);
  EXPECT_FALSE(calibrate(series.input, {}, [] { return false; }));
}

}  // namespace
}  // namespace sensotwin::twin
