// SPDX-License-Identifier: MIT
#include "twin/calibrate/sllurp_log.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "robot/config/problem.hpp"
#include "twin/calibrate/tag_links.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::HasSubstr;

const std::string kHeader = "timestamp,reader,antenna,rssi,epc,phase_angle,channel_index,doppler_frequency\n";

std::string refused(const std::string& text) {
  try {
    (void)parse_sllurp_log(text, "spot.csv");
  } catch (const robot::LoadError& error) {
    EXPECT_EQ(error.exit_code(), 65);
    return error.what();
  }
  return "";
}

// A row of the data study's Test8.
TEST(SllurpLog, ReadsARowOfARealLog) {
  const TagLog log = parse_sllurp_log(
      kHeader + "1746737577.756114,192.168.0.219:5084,2,-65,b'303435fc8803d056d15b963f',1006,7,1087\r\n",
      "a/spot.csv");
  EXPECT_EQ(log.name, "spot.csv");
  EXPECT_EQ(log.epcs, (std::vector<std::string>{"303435fc8803d056d15b963f"}));
  ASSERT_EQ(log.rows.size(), 1U);
  EXPECT_NEAR(log.rows[0].time_s, 1746737577.756114, 1e-6);
  EXPECT_EQ(log.rows[0].antenna, 2);
  EXPECT_EQ(log.rows[0].channel, 7);
  EXPECT_EQ(log.rows[0].rssi_dbm, -65.0);
  EXPECT_NEAR(log.rows[0].phase_rad, 1006.0 / 4096.0 * 2.0 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(log.rows[0].doppler_hz, 67.9375, 1e-12);
}

// Rows of its Test6: no reader column, time as ISO 8601, bare EPC.
TEST(SllurpLog, ReadsTheOlderForm) {
  const TagLog log = parse_sllurp_log(
      "timestamp,antenna,rssi,epc,phase_angle,channel_index,doppler_frequency\n"
      "2025-04-28T17:50:55.460336,1,-62,303435fc8803d056d15b963f,3236,42,683\n"
      "2025-04-28T17:50:56.085119,2,-68,303435fc8803d056d15b963f,2632,49,-20\n",
      "old.csv");
  ASSERT_EQ(log.rows.size(), 2U);
  EXPECT_NEAR(log.rows[1].time_s - log.rows[0].time_s, 0.624783, 1e-6);
  EXPECT_EQ(log.rows[0].epc, log.rows[1].epc);
}

TEST(SllurpLog, NamesFileLineAndColumnOfEachMistake) {
  const std::string text =
      refused(kHeader + "1.0,r,1,-60,b'30',17,3,0\n1.0,r,0,-60,b'30',4096,3,0\n1.0,r,1,-60,zz,17,3,0\n");
  EXPECT_THAT(text, HasSubstr("spot.csv:3:7: error: antenna: '0'; a number from 1 to 65535 was expected"));
  EXPECT_THAT(text, HasSubstr("spot.csv:3:19: error: phase_angle: '4096'"));
  EXPECT_THAT(text, HasSubstr("spot.csv:4:13: error: epc: 'zz'; hexadecimal digits were expected"));
}

TEST(SllurpLog, RefusesWhatIsNoLog) {
  EXPECT_THAT(refused(""), HasSubstr("the file is empty"));
  EXPECT_THAT(refused(kHeader), HasSubstr("no rows below the header"));
  EXPECT_THAT(refused("a,b\n1,2\n"), HasSubstr("no column 'timestamp'"));
  EXPECT_THAT(refused(kHeader.substr(0, kHeader.size() - 1) + ",more\n"), HasSubstr("unknown column 'more'"));
  EXPECT_THAT(refused(kHeader + "1.0,r,1\n"), HasSubstr("spot.csv:2:1: error: 3 cells; 8 were expected"));
  EXPECT_THAT(refused(kHeader + "nan,r,1,-60,b'30',17,3,0\n"), HasSubstr("timestamp: 'nan'"));
  EXPECT_THAT(refused("\x1f\x8b\x08"), HasSubstr("no column"));
}

TEST(SllurpLog, TellsOfAtMostTwentyMistakes) {
  std::string text = kHeader;
  for (int i = 0; i < 1000; ++i) {
    text += "x,r,1,-60,b'30',17,3,0\n";
  }
  const std::string what = refused(text);
  EXPECT_EQ(std::count(what.begin(), what.end(), '\n'), 19);
}

TEST(TagLinks, PairReadsOfOneChannelVisitOnly) {
  TagLog log{.name = "x", .epcs = {"30", "31"}, .rows = {}};
  const auto add = [&](double time_s, int channel, int epc, double phase_rad) {
    log.rows.push_back(
        {.time_s = time_s, .channel = channel, .epc = epc, .phase_rad = phase_rad, .rssi_dbm = -50.0});
  };
  add(0.000, 1, 0, 1.0);
  add(0.014, 1, 0, 1.1);
  add(0.028, 1, 0, 1.1 + std::numbers::pi);
  add(0.048, 2, 0, 0.0);
  add(0.250, 2, 0, 0.5);
  add(0.005, 1, 1, 2.0);
  const auto links = links_of(std::vector<TagLog>{log});
  ASSERT_EQ(links.size(), 2U);
  ASSERT_EQ(links[0].pairs.size(), 2U);
  EXPECT_FALSE(is_flip(links[0].pairs[0].step_rad));
  EXPECT_TRUE(is_flip(links[0].pairs[1].step_rad));
  ASSERT_EQ(links[0].bends_rad.size(), 1U);
  EXPECT_NEAR(links[0].bends_rad[0], -0.1, 1e-12);
  EXPECT_EQ(links[0].channels.size(), 2U);
}

// Data study, 3.9: a row that was first seen on channel 7 and last on 8, delivered before one of channel 8.
TEST(TagLinks, GiveStaleChannelsTheOneOfTheirTime) {
  TagLog log{.name = "x", .epcs = {"30"}, .rows = {}};
  log.rows.push_back({.time_s = 0.30, .antenna = 1, .channel = 7});
  log.rows.push_back({.time_s = 0.25, .antenna = 3, .channel = 8});
  log.rows.push_back({.time_s = 0.33, .antenna = 4, .channel = 8});
  EXPECT_EQ(correct_stale_channels(log), 1U);
  EXPECT_EQ(log.rows[0].channel, 8);
  EXPECT_EQ(log.rows[0].time_s, 0.30) << "the order of the file stays";
  log.rows = {{.time_s = 0.1, .channel = 8}, {.time_s = 0.2, .channel = 7}};
  EXPECT_EQ(correct_stale_channels(log), 0U) << "in order of time: taken as it is";
}

}  // namespace
}  // namespace sensotwin::twin
