// SPDX-License-Identifier: MIT
#include "robot/phase/phase_pairing.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "robot/base/geometry.hpp"
#include "tests/robot/phase/phase_experiments.hpp"

namespace sensotwin::robot::testing {
namespace {

const Epc kTag = experiment_epc(0);

UhfRead read_of(int at_ms, std::uint16_t antenna, double phase_rad) {
  return {.at = Instant{} + std::chrono::milliseconds{at_ms},
          .epc = kTag,
          .antenna = antenna,
          .channel = 1,
          .frequency_hz = 915e6,
          .phase_rad = phase_rad,
          .rssi_dbm = -55.0};
}

std::vector<PhasePair> pairs_of(const PairingConfig& config, const std::vector<UhfRead>& reads) {
  PhasePairing pairing{config, kTag};
  std::vector<PhasePair> pairs;
  for (const UhfRead& read : reads) {
    if (const std::optional<PhasePair> pair = pairing.add(read)) {
      pairs.push_back(*pair);
    }
  }
  return pairs;
}

TEST(PhasePairing, SubtractsRightFromLeftOfOneInstant) {
  const auto pairs = pairs_of({}, {read_of(50, 1, 1.0), read_of(50, 2, 1.3)});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_NEAR(pairs[0].difference_rad, -0.3, 1e-12);
  EXPECT_EQ(pairs[0].at, Instant{} + std::chrono::milliseconds{50});
}

TEST(PhasePairing, DoesNotPairDifferentInstantsWhenItShouldNot) {
  EXPECT_TRUE(pairs_of({}, {read_of(50, 1, 1.0), read_of(75, 2, 1.3), read_of(100, 1, 1.0)}).empty());
}

TEST(PhasePairing, OfTheNewestPairsOncePerRound) {
  const PairingConfig config{.pairing = Pairing::kLatest};
  const auto pairs =
      pairs_of(config, {read_of(0, 1, 1.0), read_of(50, 2, 1.3), read_of(100, 1, 1.2), read_of(150, 2, 1.6)});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_NEAR(pairs[0].difference_rad, -0.3, 1e-12);
  EXPECT_NEAR(pairs[1].difference_rad, -0.4, 1e-12);
}

// Both phases grow by 8 rad/s as the robot drives away, the left one is 0.3 rad behind throughout.
TEST(PhasePairing, InterpolatedIsFreeOfTheWayDrivenInBetween) {
  const auto reads = [](const std::vector<std::uint16_t>& order) {
    std::vector<UhfRead> list;
    for (int i = 0; i < 30; ++i) {
      const std::uint16_t antenna = order[static_cast<std::size_t>(i) % order.size()];
      const double grown = 8.0 * 0.05 * i + (antenna == 2 ? 0.3 : 0.0);
      list.push_back(read_of(50 * i, antenna, std::fmod(grown, 2.0 * kPi)));
    }
    return list;
  };
  for (const std::vector<std::uint16_t>& order :
       {std::vector<std::uint16_t>{1, 2}, {1, 2, 1}, {1, 1, 2, 2}}) {
    const auto pairs = pairs_of({.pairing = Pairing::kInterpolated}, reads(order));
    ASSERT_GE(pairs.size(), 10u);
    for (const PhasePair& pair : pairs) {
      EXPECT_NEAR(pair.difference_rad, -0.3, 1e-9);
    }
  }
  // The naive pairing takes the way driven in 50 ms for a tag to the side.
  for (const PhasePair& pair : pairs_of({.pairing = Pairing::kLatest}, reads({1, 2}))) {
    EXPECT_NEAR(pair.difference_rad, -0.3 - 8.0 * 0.05, 1e-9);
  }
}

TEST(PhasePairing, InterpolatedHoldsAtTheInstantOfTheMiddleReading) {
  const auto pairs = pairs_of({.pairing = Pairing::kInterpolated},
                              {read_of(0, 1, 1.0), read_of(40, 2, 1.3), read_of(100, 1, 2.0)});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].at, Instant{} + std::chrono::milliseconds{40});
  EXPECT_NEAR(pairs[0].difference_rad, 1.4 - 1.3, 1e-12);
}

TEST(PhasePairing, OfSimultaneousReadingsIsTheSameInterpolated) {
  const auto pairs =
      pairs_of({.pairing = Pairing::kInterpolated},
               {read_of(0, 1, 1.0), read_of(0, 2, 1.3), read_of(50, 1, 1.5), read_of(50, 2, 1.9)});
  ASSERT_FALSE(pairs.empty());
  EXPECT_NEAR(pairs[0].difference_rad, -0.3, 1e-12);
}

TEST(PhasePairing, DoesNotBridgeALongSilence) {
  for (const Pairing pairing : {Pairing::kLatest, Pairing::kInterpolated}) {
    EXPECT_TRUE(
        pairs_of({.pairing = pairing}, {read_of(0, 1, 1.0), read_of(900, 2, 1.3), read_of(1800, 1, 1.0)})
            .empty());
  }
}

TEST(PhasePairing, DoesNotCombineChannels) {
  for (const Pairing pairing : {Pairing::kSameInstant, Pairing::kLatest, Pairing::kInterpolated}) {
    UhfRead other = read_of(0, 2, 1.3);
    other.channel = 7;
    EXPECT_TRUE(pairs_of({.pairing = pairing}, {read_of(0, 1, 1.0), other, read_of(0, 1, 1.0)}).empty());
  }
}

TEST(PhasePairing, HearsItsOwnTagAndItsTwoPortsOnly) {
  UhfRead other_tag = read_of(50, 2, 1.3);
  other_tag.epc = experiment_epc(9);
  EXPECT_TRUE(pairs_of({}, {read_of(50, 1, 1.0), other_tag, read_of(50, 3, 1.3)}).empty());
}

TEST(PhasePairing, TurnsThePhaseOfAReaderWhosePhaseFalls) {
  const auto pairs =
      pairs_of({.phase_sign = -1.0}, {read_of(50, 1, 2 * kPi - 1.0), read_of(50, 2, 2 * kPi - 1.3)});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_NEAR(pairs[0].difference_rad, -0.3, 1e-12);
}

// A lag of 2 pi f T in each cable, at a frequency where the two differ by 21 turns and a third.
TEST(PhasePairing, TakesTheDelaysOfTheCablesOut) {
  const double left_rad = 1.0 + 2.0 * kPi * 915e6 * 36.2e-9;
  const double right_rad = 1.3 + 2.0 * kPi * 915e6 * 59.5e-9;
  const auto pairs =
      pairs_of({.left_delay_s = 36.2e-9, .right_delay_s = 59.5e-9},
               {read_of(50, 1, std::fmod(left_rad, 2 * kPi)), read_of(50, 2, std::fmod(right_rad, 2 * kPi))});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_NEAR(pairs[0].difference_rad, -0.3, 1e-9);
}

TEST(PhasePairing, ForgivesFlipsByPiWhenToldOf) {
  const auto pairs = pairs_of({.pairing = Pairing::kInterpolated, .pi_ambiguous = true},
                              {read_of(0, 1, 1.0), read_of(50, 2, 1.5 + kPi), read_of(100, 1, 1.4 + kPi)});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_NEAR(pairs[0].difference_rad, -0.3, 1e-12);
}

TEST(PhasePairing, ForgetsTheLastTagWithItsReadings) {
  PhasePairing pairing{{}, experiment_epc(3)};
  UhfRead left = read_of(50, 1, 1.0);
  left.epc = experiment_epc(3);
  EXPECT_FALSE(pairing.add(left));
  pairing.follow(kTag);
  EXPECT_EQ(pairing.last_read(), std::nullopt);
  EXPECT_FALSE(pairing.add(read_of(50, 2, 1.3)));
  EXPECT_TRUE(pairing.last_read().has_value());
}

}  // namespace
}  // namespace sensotwin::robot::testing
