// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "one_tag.hpp"

namespace sensotwin::world {
namespace {

RadioWorld hall(const RadioDescription& radio, int tags) {
  RadioWorld world = one_tag(2);
  world.tags.clear();
  world.radio = radio;
  for (int i = 0; i < tags; ++i) {
    world.tags.push_back({.name = "tag " + std::to_string(i), .at_m = {0.7 * i, 0.0}});
  }
  return world;
}

std::vector<RadioRead> of_tag(const std::vector<RadioRead>& reads, std::uint32_t tag) {
  std::vector<RadioRead> own;
  std::copy_if(reads.begin(), reads.end(), std::back_inserter(own),
               [tag](const RadioRead& read) { return read.tag == tag; });
  return own;
}

void expect_same(const std::vector<RadioRead>& a, const std::vector<RadioRead>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].time_s, b[i].time_s);
    EXPECT_EQ(a[i].phase_rad, b[i].phase_rad);
    EXPECT_EQ(a[i].rssi_dbm, b[i].rssi_dbm);
    EXPECT_EQ(a[i].doppler_hz, b[i].doppler_hz);
  }
}

TEST(RadioProfiles, PaperHasOneFrequencyAndNothingButProportionalNoise) {
  const RadioDescription paper = paper_radio();
  EXPECT_EQ(paper.channels_hz.size(), 1U);
  EXPECT_TRUE(paper.simultaneous);
  EXPECT_EQ(paper.path, PathKind::kBistatic);
  EXPECT_EQ(paper.noise_law, NoiseLaw::kProportional);
  for (const double off :
       {paper.noise_floor_rad, paper.drift_sigma_rad, paper.place_sigma_rad, paper.image_amplitude,
        paper.place_sigma_db, paper.channel_sigma_db, paper.rssi_sigma_db}) {
    EXPECT_EQ(off, 0.0);
  }
}

TEST(RadioProfiles, ImpinjShufflesAnFccTableOfItsOwn) {
  const auto one = impinj_r420_radio(robot::RandomStream{1}, 4).channels_hz;
  const auto other = impinj_r420_radio(robot::RandomStream{2}, 4).channels_hz;
  EXPECT_NE(one, other);
  auto sorted = one;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_NE(one, sorted);
  ASSERT_EQ(sorted.size(), 50U);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    EXPECT_NEAR(sorted[i], 902.75e6 + 0.5e6 * static_cast<double>(i), 1.0);
  }
}

TEST(RadioProfiles, RepeatToTheBitFromOneSeedAndDifferFromAnother) {
  const RadioWorld world = hall(impinj_r420_radio(robot::RandomStream{3}, 2), 5);
  const auto once = reads_at_rest(world, 5.0);
  EXPECT_GT(once.size(), 100U);
  expect_same(once, reads_at_rest(world, 5.0));
  EXPECT_NE(once.front().phase_rad, reads_at_rest(world, 5.0, {}, 2).front().phase_rad);
}

TEST(RadioProfiles, LetAFurtherTagChangeNoOthersReads) {
  RadioDescription radio = impinj_r420_radio(robot::RandomStream{3}, 2);
  radio.simultaneous = true;
  radio.cutoff_dbm = -1000.0;
  RadioWorld world = hall(radio, 4);
  const auto before = reads_at_rest(world, 5.0);
  world.tags.insert(world.tags.begin(), {.name = "new", .at_m = {1.0, 1.0}});
  const auto after = reads_at_rest(world, 5.0);
  for (std::uint32_t tag = 0; tag < 4; ++tag) {
    expect_same(of_tag(before, tag), of_tag(after, tag + 1));
  }
}

// Two EPCs swapped is a mistake on paper: the air does not change.
TEST(RadioProfiles, KeepTheAirOfATagWhoseEpcIsAnother) {
  RadioWorld world = hall(impinj_r420_radio(robot::RandomStream{3}, 2), 3);
  const auto before = reads_at_rest(world, 2.0);
  world.tags[0].epc.bytes[11] = 7;
  expect_same(before, reads_at_rest(world, 2.0));
}

// Data study, 3.1: coherence with a straight line 0.995, and 3.4: delays bent by some nanoseconds.
TEST(RadioProfiles, ImpinjIsNearlyLinearInFrequencyAtOnePlace) {
  RadioWorld world = one_tag(1);
  world.radio = impinj_r420_radio(robot::RandomStream{3}, 1);
  world.radio.cutoff_dbm = -1000.0;
  const double true_s = 2.0 * std::hypot(2.9, 0.08) / kLight_mps;
  double worst = 1.0;
  double mean = 0.0;
  double square_s = 0.0;
  constexpr int kPlaces = 60;
  for (int i = 0; i < kPlaces; ++i) {
    const auto reads = reads_at_rest(world, 10.2, {}, static_cast<std::uint64_t>(i));
    double best = 0.0;
    double best_s = 0.0;
    for (double delay_s = true_s - 40e-9; delay_s < true_s + 40e-9; delay_s += 0.25e-9) {
      std::complex<double> sum;
      for (const RadioRead& read : reads) {
        sum += std::polar(
            1.0, read.phase_rad + 2.0 * robot::kPi * world.radio.channels_hz[read.channel] * delay_s);
      }
      if (std::abs(sum) > best) {
        best = std::abs(sum);
        best_s = delay_s - true_s;
      }
    }
    best /= static_cast<double>(reads.size());
    worst = std::min(worst, best);
    mean += best / kPlaces;
    square_s += best_s * best_s / kPlaces;
  }
  EXPECT_GT(worst, 0.95);
  EXPECT_NEAR(mean, 0.995, 0.004);
  EXPECT_NEAR(std::sqrt(square_s), 2.6e-9, 1e-9);
}

}  // namespace
}  // namespace sensotwin::world
