// SPDX-License-Identifier: MIT
// The figures of the data study, found again in its logs.
#include "real_logs.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>

namespace sensotwin::twin {
namespace {

#define SKIP_WITHOUT_REAL_LOGS()                                                    \
  if (!std::filesystem::exists(real_logs())) {                                      \
    GTEST_SKIP() << "the logs of the data study are not here: ../shared/data/rfid"; \
  }

/// Column of derived/hoptable_recovered.csv: 1 May 2025, 2 August and September.
std::vector<double> table_of_study(int column) {
  std::ifstream in(real_logs() / "derived/hoptable_recovered.csv");
  std::vector<double> channels_hz;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (int c = 0; c <= column; ++c) {
      std::getline(cells, cell, ',');
    }
    channels_hz.push_back(1e6 * std::stod(cell));
  }
  return channels_hz;
}

std::optional<Calibration> calibrated(const CalibrationInput& input) {
  CalibrationSettings settings;
  settings.resamples = 50;
  settings.starts = 60;
  return calibrate(input, settings, [] { return true; });
}

TEST(RealLogs, OfOneAntennaGiveNoiseLawHopTableFlipsAndTimingOfTheStudy) {
  SKIP_WITHOUT_REAL_LOGS();
  const auto found = calibrated(input_of({"Test12", "Test13", "Test14", "Test15"}));
  ASSERT_TRUE(found && found->noise.by_rssi && found->recovered);
  std::printf("read noise predicted from other logs within 0.8 to 1.25: %.0f %%\n",
              100.0 * found->noise.left_out_share);
  std::printf("coherence %.3f over %zu strong links, %.0f %% over 0.95\n", found->strong_coherence->value,
              found->recovered->links, 100.0 * found->linear_share);
  EXPECT_GE(found->noise.left_out_share, 0.9);
  EXPECT_EQ(found->channels_hz, table_of_study(2));
  EXPECT_EQ(found->linear_share, 1.0);
  EXPECT_GT(found->strong_coherence->low, 0.98);
  // Data study, 3.5: 0.0078 and 0.0155 from 117 logs, of which these are 27; 3.7: -72.2 dBm and 2.52 dB.
  EXPECT_NEAR(found->noise.by_rssi->parameters[0].value, 0.0078, 0.0008);
  EXPECT_NEAR(found->noise.by_rssi->parameters[1].value, 0.0155, 0.0015);
  EXPECT_NEAR(found->flips.rssi_dbm->value, -72.2, 2.0);
  EXPECT_NEAR(found->flips.width_db->value, 2.52, 0.6);
  EXPECT_EQ(found->phase_steps, 1024);
  const ReaderTiming& timing = found->timings.at(0);  // 3.8
  EXPECT_NEAR(timing.slot_s.at(1).value, 0.01402, 0.0001);
  EXPECT_NEAR(timing.dwell_s->value, 0.20335, 0.002);
  EXPECT_NEAR(timing.hop_dead_s->value, 0.006, 0.0005);
}

// Data study, 3.4: delays of 57 to 85 ns; 3.5: a line through zero is worse than a constant.
TEST(RealLogs, WithDistancesSayThatNoiseDoesNotGrowInProportion) {
  SKIP_WITHOUT_REAL_LOGS();
  CalibrationInput input = input_of({"Test13"});
  for (std::size_t l = 0; l < input.logs.size(); ++l) {
    input.distance_m[l] = 0.3048 * (input.logs[l].name[8] - '0');  // Test13a-5-0.csv: 5 ft
  }
  const auto found = calibrated(input);
  ASSERT_TRUE(found && found->noise.proportional && found->noise.offset);
  EXPECT_LT(found->noise.proportional->r_squared, 0.0);
  EXPECT_GT(found->noise.by_rssi->r_squared, 0.7);
  EXPECT_GT(found->noise.proportional->spread, 1.5);
  EXPECT_LT(found->noise.by_rssi->spread, 1.2);
  EXPECT_NEAR(found->noise.proportional->parameters[0].value, 0.0092, 0.002);
  EXPECT_GT(found->delay_s.at(1).value, 57e-9);
  EXPECT_LT(found->delay_s.at(1).value, 85e-9);
  EXPECT_NEAR(found->rssi->slope_db.value, -22.2, 4.0);
}

// The study found this table from 64 spots, of which 32 are here.
TEST(RealLogs, OfFourAntennasGiveAnotherHopTableNearlyAndTheSlots) {
  SKIP_WITHOUT_REAL_LOGS();
  const auto found = calibrated(input_of({"Test8"}));
  ASSERT_TRUE(found && found->recovered);
  const std::vector<double> study = table_of_study(1);
  int equal = 0;
  double farthest_hz = 0.0;
  for (std::size_t c = 0; c < study.size(); ++c) {
    equal += found->channels_hz[c] == study[c] ? 1 : 0;
    farthest_hz = std::max(farthest_hz, std::abs(found->channels_hz[c] - study[c]));
  }
  std::printf("%d of 50 channels as in the study, the farthest %.1f MHz off\n", equal, 1e-6 * farthest_hz);
  EXPECT_GE(equal, 40);
  EXPECT_LE(farthest_hz, 0.5e6);
  const ReaderTiming& timing = found->timings.at(0);
  EXPECT_EQ(timing.ports, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_NEAR(timing.slot_s.at(1).value, 0.0289, 0.002);
  EXPECT_NEAR(timing.slot_s.at(2).value, 0.0293, 0.002);
  EXPECT_NEAR(timing.slot_s.at(3).value, 0.0310, 0.002);
  EXPECT_NEAR(timing.slot_s.at(4).value, 0.0140, 0.001);
  EXPECT_GT(timing.out_of_order_share, 0.08);
}

// Data study, 3.2: with the table known, falling phase fits and rising does not.
TEST(RealLogs, WithTheirHopTableSayThatPhaseFalls) {
  SKIP_WITHOUT_REAL_LOGS();
  CalibrationInput input = input_of({"Test13"});
  input.channels_hz = table_of_study(2);
  const auto found = calibrated(input);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->phase_sign, -1.0);
  EXPECT_GT(*found->falling_coherence, 0.95);
  EXPECT_LT(*found->rising_coherence, 0.5);
}

}  // namespace
}  // namespace sensotwin::twin
