// SPDX-License-Identifier: MIT
// The calibrated radio against what it was not fitted to: how often each of four antennas reads a tag on 32
// spots of a real room (data study, 2: Test8).
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <optional>

#include "real_logs.hpp"
#include "world/radio/profiles.hpp"
#include "world/radio/radio.hpp"

namespace sensotwin::twin {
namespace {

constexpr double kFoot_m = 0.3048;
/// Ports 1 to 4, 4 ft high, 15 ft apart; the tag's height was not recorded and is taken to be theirs.
const std::array<robot::Vec2, 4> kAntennas_ft = {{{0.0, 0.0}, {0.0, 15.0}, {15.0, 15.0}, {15.0, 0.0}}};
constexpr double kHeight_m = 4.0 * kFoot_m;

struct Spot {
  std::string name;
  robot::Vec2 at_m{0.0, 0.0};
  double seconds{0.0};
  std::array<double, 4> reads{};
  std::array<double, 4> rssi_dbm{};
  [[nodiscard]] double rate() const { return (reads[0] + reads[1] + reads[2] + reads[3]) / seconds; }
  [[nodiscard]] double distance_m(std::size_t port) const {
    return (at_m - kFoot_m * kAntennas_ft[port]).norm();
  }
};

std::vector<Spot> measured_spots() {
  std::vector<Spot> spots;
  for (const TagLog& log : logs_of("Test8")) {
    Spot spot{.name = log.name};
    std::sscanf(log.name.c_str(), "(%lf,%lf)", &spot.at_m.x(), &spot.at_m.y());
    spot.at_m *= kFoot_m;
    double first_s = log.rows.front().time_s;
    double last_s = first_s;
    for (const LogRow& row : log.rows) {
      first_s = std::min(first_s, row.time_s);
      last_s = std::max(last_s, row.time_s);
      spot.reads[static_cast<std::size_t>(row.antenna - 1)] += 1.0;
      spot.rssi_dbm[static_cast<std::size_t>(row.antenna - 1)] += row.rssi_dbm;
    }
    spot.seconds = last_s - first_s;
    for (std::size_t port = 0; port < 4; ++port) {
      spot.rssi_dbm[port] /= std::max(1.0, spot.reads[port]);
    }
    spots.push_back(spot);
  }
  return spots;
}

/// RSSI in this room: the slope as the data study's 3.6 has it for Test8; strength of each port as measured
/// at the spots that it heard well (port 2 is an antenna of another band).
constexpr double kSlope_db = -22.2;
std::array<double, 4> strength_at_1m_dbm(const std::vector<Spot>& spots) {
  std::array<double, 4> at_1m_dbm{};
  for (std::size_t port = 0; port < 4; ++port) {
    double heard = 0.0;
    for (const Spot& spot : spots) {
      if (spot.reads[port] >= 20.0) {
        at_1m_dbm[port] += spot.rssi_dbm[port] - kSlope_db * std::log10(spot.distance_m(port));
        heard += 1.0;
      }
    }
    at_1m_dbm[port] /= heard;
  }
  return at_1m_dbm;
}

Spot simulated(const Spot& real, const std::array<double, 4>& at_1m_dbm, std::uint64_t seed) {
  const robot::RandomStream random = robot::RandomStream{seed}.fork(real.name);
  world::RadioWorld world;
  world.radio = world::impinj_r420_radio(random.fork("hop table"), 4);
  world.radio.rssi_at_1m_dbm = at_1m_dbm[0];
  world.radio.rssi_slope_db = kSlope_db;
  world.radio.report_every = 4;  // data study, 3.9: logs before 25 August 2025
  world.radio.accumulate_reads = true;
  world.tags.push_back({.name = "tag", .at_m = real.at_m, .height_m = kHeight_m});
  for (std::size_t port = 0; port < 4; ++port) {
    // The measured strength already holds what the beams lose: the antenna looks at the tag.
    const robot::Vec2 at_m = kFoot_m * kAntennas_ft[port];
    const robot::Vec2 towards = (real.at_m - at_m).normalized();
    world.antennas.push_back(
        {.at_m = {at_m.x(), at_m.y(), kHeight_m},
         .boresight = {towards.x(), towards.y(), 0.0},
         .gain_dbi = world::kReferenceGain_dbi + 0.5 * (at_1m_dbm[port] - at_1m_dbm[0])});
  }
  world::Radio radio(world, random);
  Spot spot{.name = real.name, .at_m = real.at_m, .seconds = real.seconds};
  for (const world::RadioRead& read : radio.step({.begin_s = 0.0, .end_s = real.seconds})) {
    spot.reads[read.antenna] += 1.0;
    spot.rssi_dbm[read.antenna] += read.rssi_dbm;
  }
  return spot;
}

/// Reads a second and shares of the ports, mean over spots.
struct Means {
  double rate{0.0};
  std::array<double, 4> share{};
};
Means means_of(const std::vector<Spot>& spots) {
  Means means;
  double all = 0.0;
  for (const Spot& spot : spots) {
    means.rate += spot.rate() / static_cast<double>(spots.size());
    for (std::size_t port = 0; port < 4; ++port) {
      means.share[port] += spot.reads[port];
      all += spot.reads[port];
    }
  }
  for (double& share : means.share) {
    share /= all;
  }
  return means;
}

TEST(CalibratedRadio, ReadsTheSpotsOfARealRoomAsOftenAsTheRealReaderAndThroughTheSamePorts) {
  if (!std::filesystem::exists(real_logs())) {
    GTEST_SKIP() << "the logs of the data study are not here: ../shared/data/rfid";
  }
  const std::vector<Spot> real = measured_spots();
  ASSERT_EQ(real.size(), 32U);
  const std::array<double, 4> at_1m_dbm = strength_at_1m_dbm(real);
  constexpr int kSeeds = 20;
  std::vector<Spot> simulation;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    for (const Spot& spot : real) {
      simulation.push_back(simulated(spot, at_1m_dbm, seed));
    }
  }
  const Means measured = means_of(real);
  const Means predicted = means_of(simulation);
  std::printf("reads a second: measured %.1f, predicted %.1f\n", measured.rate, predicted.rate);
  for (std::size_t port = 0; port < 4; ++port) {
    std::printf("share of port %zu: measured %.3f, predicted %.3f\n", port + 1, measured.share[port],
                predicted.share[port]);
    EXPECT_NEAR(predicted.share[port], measured.share[port], 0.06);
  }
  EXPECT_NEAR(predicted.rate / measured.rate, 1.0, 0.25);
}

}  // namespace
}  // namespace sensotwin::twin
