// SPDX-License-Identifier: MIT
#include "twin/calibrate/hop_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "robot/base/geometry.hpp"

namespace sensotwin::twin {
namespace {

struct Truth {
  std::vector<double> channels_hz;
  std::vector<PhaseByChannel> links;
};

/// Links with delays 5 ns apart from 60 ns on, phases off by `sigma_rad`.
Truth made(int links, double sign, double sigma_rad, std::uint64_t seed) {
  robot::RandomStream random{seed};
  const Band band;
  Truth truth;
  std::vector<int> slots(static_cast<std::size_t>(band.channels));
  std::iota(slots.begin(), slots.end(), 0);
  for (std::size_t i = slots.size() - 1; i > 0; --i) {
    std::swap(slots[i], slots[random.below(static_cast<std::uint32_t>(i + 1))]);
  }
  for (const int slot : slots) {
    truth.channels_hz.push_back(band.at_hz(slot));
  }
  for (int l = 0; l < links; ++l) {
    const double delay_s = 60e-9 + 5e-9 * l;
    const double constant_rad = random.uniform(0.0, 6.28);
    PhaseByChannel link;
    for (const double hz : truth.channels_hz) {
      link.push_back(std::polar(
          1.0, sign * 2.0 * robot::kPi * hz * delay_s + constant_rad + random.normal(0.0, sigma_rad)));
    }
    truth.links.push_back(link);
  }
  return truth;
}

bool always() {
  return true;
}

TEST(HopTable, IsRecoveredFromPhasesWhicheverWayTheyGo) {
  for (const double sign : {-1.0, 1.0}) {
    const Truth truth = made(8, sign, 0.05, 3);
    const auto table = recover_hop_table(truth.links, {}, sign, 30, 20, robot::RandomStream{1}, always);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->channels_hz, truth.channels_hz);
    EXPECT_GT(table->agreeing, 3);
    EXPECT_GT(*std::min_element(table->stability.begin(), table->stability.end()), 0.5);
  }
}

TEST(HopTable, ReadWithTheWrongSignIsItsMirrorImage) {
  const Truth truth = made(8, -1.0, 0.05, 3);
  const auto table = recover_hop_table(truth.links, {}, 1.0, 30, 1, robot::RandomStream{1}, always);
  ASSERT_TRUE(table);
  for (std::size_t c = 0; c < truth.channels_hz.size(); ++c) {
    EXPECT_NEAR(table->channels_hz[c], 1830e6 - truth.channels_hz[c], 1.0);
  }
}

TEST(HopTable, HoldsEachFrequencyOnceEvenWhereChannelsWereNeverHeard) {
  Truth truth = made(6, -1.0, 0.05, 4);
  for (PhaseByChannel& link : truth.links) {
    link[7] = link[31] = 0.0;
  }
  const auto table = recover_hop_table(truth.links, {}, -1.0, 30, 1, robot::RandomStream{1}, always);
  ASSERT_TRUE(table);
  auto sorted = table->channels_hz;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(std::unique(sorted.begin(), sorted.end()), sorted.end());
  // Where a channel at the edge of the band is not heard, the phases hold for the table one step aside as
  // well.
  int right = 0;
  for (const double aside_hz : {-1e6, -0.5e6, 0.0, 0.5e6, 1e6}) {
    int equal = 0;
    for (std::size_t c = 0; c < sorted.size(); ++c) {
      equal += std::abs(table->channels_hz[c] + aside_hz - truth.channels_hz[c]) < 1.0 ? 1 : 0;
    }
    right = std::max(right, equal);
  }
  EXPECT_GE(right, 46);
}

TEST(HopTable, IsNotClaimedFromOneLinkOrWhenStopped) {
  const Truth truth = made(3, -1.0, 0.05, 5);
  EXPECT_FALSE(
      recover_hop_table(std::span(truth.links).first(1), {}, -1.0, 10, 1, robot::RandomStream{1}, always));
  EXPECT_FALSE(recover_hop_table(truth.links, {}, -1.0, 10, 1, robot::RandomStream{1}, [] { return false; }));
}

TEST(FrequencyLine, FindsADelayToATenthOfANanosecond) {
  const Truth truth = made(1, -1.0, 0.02, 6);
  const FrequencyLine line = fit_line(truth.links[0], truth.channels_hz, -1.0);
  // Standard error of a slope over 50 channels: 0.02 / (2 pi 7.2 MHz sqrt(50)) = 0.06 ns.
  EXPECT_NEAR(line.delay_s, 60e-9, 0.25e-9);
  EXPECT_GT(line.coherence, 0.999);
  EXPECT_LT(fit_line(truth.links[0], truth.channels_hz, 1.0).coherence, 0.5);
}

}  // namespace
}  // namespace sensotwin::twin
