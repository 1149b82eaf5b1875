// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "one_tag.hpp"
#include "world/radio/report_queue.hpp"

namespace sensotwin::world {
namespace {

TEST(RadioTiming, ReadsAllAntennasAtOnceInThePapersProfile) {
  RadioWorld world = one_tag(2);
  world.radio = paper_radio();
  const auto reads = reads_at_rest(world, 10.0);
  ASSERT_EQ(reads.size(), 402U);
  for (std::size_t i = 0; i < reads.size(); ++i) {
    EXPECT_EQ(reads[i].antenna, i % 2);
    EXPECT_NEAR(reads[i].time_s, 0.05 * static_cast<double>(i / 2), 1e-12);
  }
}

TEST(RadioTiming, IsTheSameHoweverTimeIsCutIntoSteps) {
  RadioWorld world = one_tag(2);
  world.radio = impinj_r420_radio(robot::RandomStream{2}, 2);
  world.radio.cutoff_dbm = -1000.0;
  const auto whole = reads_at_rest(world, 3.0);
  Radio radio(world, robot::RandomStream{1});
  std::size_t next = 0;
  for (int tick = 0; tick < 200; ++tick) {
    for (const RadioRead& read : radio.step({.begin_s = 0.015 * tick, .end_s = 0.015 * (tick + 1)})) {
      ASSERT_LT(next, whole.size());
      EXPECT_EQ(read.time_s, whole[next].time_s);
      EXPECT_EQ(read.phase_rad, whole[next].phase_rad);
      ++next;
    }
  }
  EXPECT_EQ(next, whole.size());
}

// Data study, 3.8: a cycle of 103 ms, slots 28.9, 29.3, 31.0, 14.0 ms.
TEST(RadioTiming, GoesRoundFourAntennasWithTheMeasuredSlots) {
  RadioWorld world = one_tag(4);
  multiplex(world, measured_slots_s(4));
  const auto reads = reads_at_rest(world, 20.0);
  const std::array<double, 4> slots_s = {0.0289, 0.0293, 0.0310, 0.01402};
  std::array<double, 4> share{};
  for (std::size_t i = 0; i + 1 < reads.size(); ++i) {
    EXPECT_EQ(reads[i + 1].antenna, (reads[i].antenna + 1) % 4);
    EXPECT_NEAR(reads[i + 1].time_s - reads[i].time_s, slots_s[reads[i].antenna], 1e-9);
    share[reads[i].antenna] += 1.0 / static_cast<double>(reads.size());
  }
  EXPECT_NEAR(static_cast<double>(reads.size()) / 20.0, 4.0 / 0.1032, 0.1);
  EXPECT_NEAR(share[3], 0.25, 0.01);
}

TEST(RadioTiming, IsHeldUpByAnAntennaThatHearsNothing) {
  RadioWorld world = one_tag(3);
  multiplex(world, {0.029, 0.029, 0.014});
  world.antennas[1].boresight = {0.0, 0.0, -1.0};
  world.radio.cutoff_dbm = -75.0;
  world.radio.silent_slot_s = 0.042;
  const auto reads = reads_at_rest(world, 1.0);
  for (std::size_t i = 1; i < reads.size(); ++i) {
    EXPECT_EQ(reads[i].antenna, reads[i - 1].antenna == 0 ? 2 : 0);
    EXPECT_NEAR(reads[i].time_s - reads[i - 1].time_s, reads[i].antenna == 2 ? 0.029 + 0.042 : 0.014, 1e-9);
  }
  EXPECT_EQ(reads.size(), 23U) << "cycles of 85 ms: twelve begun, eleven whole";
}

// Data study, 3.8: one read each 14.02 ms, dwell 203.35 ms (10 to 90 %: 195 to 214), 10.2 s for 50 channels.
TEST(RadioTiming, HopsThroughItsTableInOrderAfterTheRoundAtHand) {
  RadioWorld world = one_tag(1);
  world.radio = impinj_r420_radio(robot::RandomStream{2}, 1);
  world.radio.cutoff_dbm = -1000.0;
  const auto reads = reads_at_rest(world, 20.4);
  double visit_begin_s = 0.0;
  int hops = 0;
  for (std::size_t i = 1; i < reads.size(); ++i) {
    if (reads[i].channel == reads[i - 1].channel) {
      EXPECT_NEAR(reads[i].time_s - reads[i - 1].time_s, 0.01402, 1e-9);
      continue;
    }
    ++hops;
    EXPECT_EQ(reads[i].channel, (reads[i - 1].channel + 1) % 50);
    EXPECT_NEAR(reads[i].time_s - reads[i - 1].time_s, 0.01402 + 0.006, 1e-9);
    EXPECT_NEAR(reads[i].time_s - visit_begin_s, 0.20335, 0.02);
    visit_begin_s = reads[i].time_s;
  }
  EXPECT_EQ(hops, 100);
  EXPECT_NEAR(static_cast<double>(reads.size()) / 20.4, 69.7, 1.0);
}

TEST(RadioTiming, ReadsManyTagsInABurstAndStretchesTheRound) {
  RadioWorld world = one_tag(1);
  multiplex(world, {0.014});
  for (int i = 1; i < 9; ++i) {
    world.tags.push_back({.name = std::to_string(i), .at_m = {0.1 * i, 0.0}});
  }
  const auto reads = reads_at_rest(world, 1.0);
  for (std::size_t i = 1; i < reads.size(); ++i) {
    const double gap_s = reads[i].time_s - reads[i - 1].time_s;
    EXPECT_NEAR(gap_s, reads[i].tag == 0 ? 0.014 : 0.0007, 1e-9);
  }
  EXPECT_EQ(reads[8].tag, 8U);
}

TEST(RadioTiming, UsesTheAntennasThatItIsTold) {
  RadioWorld world = one_tag(4);
  multiplex(world, {0.05, 0.05, 0.05, 0.05});
  Radio radio(world, robot::RandomStream{1});
  radio.use_antennas({}, 0.0);
  EXPECT_TRUE(reads_at_rest(radio, {}, 1.0).empty());
  const std::array<std::uint16_t, 3> order = {2, 0, 2};
  radio.use_antennas(order, 1.0);
  const auto reads = radio.step({.begin_s = 1.0, .end_s = 1.26});
  ASSERT_EQ(reads.size(), 6U);
  EXPECT_EQ(reads[0].antenna, 2);
  EXPECT_EQ(reads[1].antenna, 0);
  EXPECT_EQ(reads[2].antenna, 2);
  EXPECT_EQ(reads[3].antenna, 2);
  EXPECT_NEAR(reads[5].time_s, 1.25, 1e-9);
}

// Data study, 3.9: with N > 1 rows carry the channel of the first read, time and phase of the last, and stand
// in the order of the first.
TEST(RadioReports, KeepTheFirstChannelAndTheLastTimeOfATagReadTwice) {
  RadioDescription radio;
  radio.report_every = 4;
  radio.accumulate_reads = true;
  radio.report_latency_s = 0.01;
  ReportQueue queue(radio);
  queue.push({.time_s = 0.00, .antenna = 0, .channel = 6, .phase_rad = 1.0});
  queue.push({.time_s = 0.03, .antenna = 2, .channel = 6, .phase_rad = 2.0});
  queue.push({.time_s = 0.06, .antenna = 3, .channel = 7, .phase_rad = 3.0});
  std::vector<RadioRead> rows;
  queue.take_arrived(0.1, rows);
  EXPECT_TRUE(rows.empty());
  queue.push({.time_s = 0.09, .antenna = 0, .channel = 7, .phase_rad = 4.0});
  queue.take_arrived(0.095, rows);
  EXPECT_TRUE(rows.empty()) << "it is on its way";
  queue.take_arrived(0.1, rows);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].time_s, 0.09);
  EXPECT_EQ(rows[0].phase_rad, 4.0);
  EXPECT_EQ(rows[0].channel, 6);
  EXPECT_EQ(rows[1].time_s, 0.03);
}

TEST(RadioReports, HoldEveryReadWhereNothingIsAccumulated) {
  RadioWorld world = one_tag(2);
  multiplex(world, {0.02, 0.02});
  const auto single = reads_at_rest(world, 10.0);
  world.radio.report_every = 4;
  const auto four = reads_at_rest(world, 10.0);
  ASSERT_EQ(four.size(), single.size() / 4 * 4);
  for (std::size_t i = 0; i < four.size(); ++i) {
    EXPECT_EQ(four[i].time_s, single[i].time_s);
  }
}

}  // namespace
}  // namespace sensotwin::world
