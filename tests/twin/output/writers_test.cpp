// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>

#include "temporary_folder.hpp"
#include "twin/output/event_log.hpp"
#include "twin/output/map_export.hpp"
#include "twin/output/state_hash.hpp"
#include "twin/output/text_format.hpp"
#include "twin/output/trace_writer.hpp"

namespace sensotwin::twin {
namespace {

using robot::from_s;
using robot::Instant;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <int Decimals>
std::string fixed(double value) {
  std::string text(24, '?');
  text.resize(static_cast<std::size_t>(put_fixed<Decimals>(text.data(), value) - text.data()));
  return text;
}

TEST(FixedPoint, RoundsToTheNearestDigit) {
  EXPECT_EQ(fixed<3>(1.2344999), "1.234");
  EXPECT_EQ(fixed<3>(1.2346), "1.235");
  EXPECT_EQ(fixed<3>(-1.2346), "-1.235");
  EXPECT_EQ(fixed<0>(2.0), "2");
  EXPECT_EQ(fixed<2>(1234567.891), "1234567.89");
}

TEST(FixedPoint, KeepsTheZerosBehindThePoint) {
  EXPECT_EQ(fixed<5>(0.00012), "0.00012");
  EXPECT_EQ(fixed<5>(3.0), "3.00000");
}

TEST(FixedPoint, NeverWritesMinusZero) {
  EXPECT_EQ(fixed<2>(-0.0), "0.00");
  EXPECT_EQ(fixed<2>(-0.004), "0.00");
}

TEST(FixedPoint, WritesNothingForWhatIsNoNumberOrTooLarge) {
  EXPECT_EQ(fixed<5>(kNan), "");
  EXPECT_EQ(fixed<5>(-std::numeric_limits<double>::infinity()), "");
  EXPECT_EQ(fixed<5>(1e12), "");
}

TEST(JsonString, EscapesWhatJsonReserves) {
  std::string text;
  append_json_string(text, "a\"b\\c\n\t\x01 \xC3\xBC");
  EXPECT_EQ(text, "\"a\\\"b\\\\c\\n\\t\\u0001 \xC3\xBC\"");
}

TEST(JsonString, ReplacesBytesThatAreNoUtf8) {
  for (const std::string bad :
       {"\xFF", "\xC3", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xC0\xAF"}) {
    std::string text;
    append_json_string(text, bad);
    EXPECT_TRUE(nlohmann::json::accept(text)) << text;
    EXPECT_THAT(text, ::testing::HasSubstr("\xEF\xBF\xBD"));
  }
}

TEST(XmlText, EscapesWhatXmlReservesAndReplacesWhatItForbids) {
  std::string text;
  append_xml_text(text, "<a b=\"c\">'R&D'\n\xC3\xBC\x01\xFF\xEF\xBF\xBE");
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(text, "&lt;a b=&quot;c&quot;&gt;&apos;R&amp;D&apos;\n\xC3\xBC" + replaced + replaced + replaced);
}

TEST(TraceWriter, WritesHeaderAndRowsAsDocumented) {
  const TemporaryFolder folder;
  TraceWriter trace(OutputFile(folder / "trace.csv"), 1);
  trace.add({.now = Instant{from_s(0.015)},
             .X_WR = {{1.0, -2.5}, 0.5},
             .X_OR_odometry = {{0.25, 0.0}, -0.125},
             .command_left_mps = 0.2,
             .command_right_mps = -0.2,
             .bump_left = true});
  trace.add({.now = Instant{from_s(0.030)},
             .X_MR_estimate = robot::Pose2{{0.508, 0.0}, 0.0},
             .bump_right = true,
             .tag = 0xE00401001234ABCDu});
  trace.finish();
  EXPECT_EQ(content_of(folder / "trace.csv"),
            "t_s,truth_x_m,truth_y_m,truth_yaw_rad,odometry_x_m,odometry_y_m,odometry_yaw_rad,"
            "estimate_x_m,estimate_y_m,estimate_yaw_rad,command_left_mps,command_right_mps,bump,tag\n"
            "0.015,1.00000,-2.50000,0.50000,0.25000,0.00000,-0.12500,,,,0.20000,-0.20000,2,\n"
            "0.030,0.00000,0.00000,0.00000,0.00000,0.00000,0.00000,0.50800,0.00000,0.00000,0.00000,0.00000,1,"
            "E00401001234ABCD\n");
}

TEST(TraceWriter, KeepsEveryNthRowBeginningWithTheFirst) {
  const TemporaryFolder folder;
  TraceWriter trace(OutputFile(folder / "trace.csv"), 4);
  for (int tick = 0; tick < 10; ++tick) {
    trace.add({.now = Instant{tick * robot::kTick}});
  }
  trace.finish();
  const std::string text = content_of(folder / "trace.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 3);
  EXPECT_THAT(text, ::testing::HasSubstr("\n0.000,"));
  EXPECT_THAT(text, ::testing::HasSubstr("\n0.060,"));
  EXPECT_THAT(text, ::testing::HasSubstr("\n0.120,"));
}

// Processor time, system calls included, so that a busy machine does not fail it. The limit is six times what
// one row costs (RowCost below): a return to printf-like formatting, 1.5 microseconds, does not go unnoticed.
TEST(TraceWriter, WritesARowInLessThanAMicrosecond) {
  constexpr int kRows = 200'000;
  const TemporaryFolder folder;
  TraceWriter trace(OutputFile(folder / "trace.csv"), 1);
  TraceRow row{.X_WR = {{1.23456, 2.34567}, 0.5}, .X_OR_odometry = {{1.2, 2.3}, 0.4}, .tag = 1};
  row.X_MR_estimate = row.X_WR;
  const std::clock_t begin = std::clock();
  for (int tick = 0; tick < kRows; ++tick) {
    row.now = Instant{tick * robot::kTick};
    row.X_WR.p_m.x() += 0.0031;
    trace.add(row);
  }
  trace.finish();
  const double row_us = 1e6 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / kRows;
  RecordProperty("RowCost_ns", static_cast<int>(1000.0 * row_us));
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
  EXPECT_LT(row_us, 1.0);
#endif
}

TEST(EventLog, PutsTimeFirstAndKeysInTheOrderGiven) {
  const TemporaryFolder folder;
  EventLog log(OutputFile(folder / "events.jsonl"));
  log.add(
      Instant{from_s(1.5)}, "tag_found",
      {{"uid", uid_text(0xE004010012345678u)}, {"column", 3}, {"row", -1}, {"x_m", 1.524}, {"new", true}});
  log.add(Instant{from_s(2.0)}, "bump");
  log.finish();
  EXPECT_EQ(
      content_of(folder / "events.jsonl"),
      R"({"t_s":1.500,"event":"tag_found","uid":"E004010012345678","column":3,"row":-1,"x_m":1.524,"new":true})"
      "\n"
      R"({"t_s":2.000,"event":"bump"})"
      "\n");
  EXPECT_EQ(log.count(), 2);
}

TEST(EventLog, WritesNullForNotANumberBecauseJsonHasNone) {
  const TemporaryFolder folder;
  EventLog log(OutputFile(folder / "events.jsonl"));
  log.add(Instant{}, "odd", {{"a", kNan}, {"b", 2.0}, {"c", -0.0}, {"d", 0.25}});
  log.finish();
  EXPECT_EQ(content_of(folder / "events.jsonl"),
            "{\"t_s\":0.000,\"event\":\"odd\",\"a\":null,\"b\":2,\"c\":0,\"d\":0.25}\n");
}

TEST(StateHash, IsTheSameOnEveryMachine) {
  StateHash hash;
  hash.add(1.5);
  hash.add(-7);
  hash.add(std::uint8_t{200});
  // Golden: the three steps of the formula in the header, taken by a Python script on big integers.
  EXPECT_EQ(hash.text(), "28510efac511bad7");
}

TEST(StateHash, ChangesWithEveryBitOfAWord) {
  for (int bit = 0; bit < 64; ++bit) {
    StateHash plain;
    StateHash flipped;
    plain.add(std::uint64_t{0});
    flipped.add(std::uint64_t{1} << bit);
    for (int i = 0; i < 3; ++i) {
      plain.add(i);
      flipped.add(i);
    }
    EXPECT_NE(plain.value(), flipped.value()) << bit;
  }
}

TEST(StateHash, TellsOrderApart) {
  StateHash ab;
  StateHash ba;
  ab.add(1);
  ab.add(2);
  ba.add(2);
  ba.add(1);
  EXPECT_NE(ab.value(), ba.value());
}

/// The trinary rule of nav2_map_server: occupancy = (255 - pixel) / 255, no negation.
char trinary(unsigned char pixel) {
  const double occupancy = (255 - pixel) / 255.0;
  return occupancy > 0.65 ? '#' : occupancy < 0.196 ? '.' : '?';
}

TEST(MapExport, ReadsBackByTheTrinaryRuleWithTheFirstRowOnTop) {
  const TemporaryFolder temporary;
  RunFolder folder(temporary.path(), Existing::kRefuse);
  constexpr auto kFree = GridCell::kFree;
  constexpr auto kWall = GridCell::kOccupied;
  constexpr auto kDark = GridCell::kUnknown;
  write_map(folder, {.width = 3,
                     .height = 2,
                     .resolution_m = 0.05,
                     .X_MG = {{-1.0, 0.5}, 0.25},
                     .cells = {kWall, kWall, kWall, kFree, kFree, kDark}});
  const std::string pgm = content_of(temporary / "map.pgm");
  ASSERT_TRUE(pgm.starts_with("P5\n3 2\n255\n"));
  std::string picture;
  for (const char pixel : pgm.substr(pgm.size() - 6)) {
    picture += trinary(static_cast<unsigned char>(pixel));
  }
  EXPECT_EQ(picture, "..?###");
  EXPECT_EQ(content_of(temporary / "map.yaml"),
            "image: map.pgm\nmode: trinary\nresolution: 0.050000\norigin: [-1.000000, 0.500000, 0.250000]\n"
            "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

}  // namespace
}  // namespace sensotwin::twin
