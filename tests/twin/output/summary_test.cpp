// SPDX-License-Identifier: MIT
#include "twin/output/summary.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "twin/output/state_hash.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

Summary house() {
  Summary summary;
  summary.scene = "scenes/house.yaml";
  summary.seed = 7;
  summary.state_hash = StateHash{}.text();
  summary.sim_s = 1560.0000001;
  summary.map =
      MapResult{.explorer = "idfm", .tiles_reachable = 207, .tiles_mapped = 206, .minutes = 25.1 + 0.2};
  return summary;
}

TEST(Summary, HoldsTheKeysThatOutsideChecksRelyOn) {
  Summary summary = house();
  summary.expect = judge({{.name = "tiles_mapped", .min = 207}}, figures_of(summary));
  const auto json = nlohmann::json::parse(to_json(summary));
  for (const char* key : {"scene", "seed", "verdict", "expect", "state_hash", "sim_s", "map"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  for (const char* key : {"explorer", "tiles_reachable", "tiles_grid_reachable", "tiles_mapped",
                          "tiles_missed", "tiles_wrong", "visits", "epsilon", "minutes", "metres", "turns"}) {
    EXPECT_TRUE(json["map"].contains(key)) << key;
  }
  EXPECT_EQ(json["expect"][0].dump(),
            R"({"max":null,"min":207.0,"name":"tiles_mapped","ok":false,"value":206.0})");
  EXPECT_EQ(json["verdict"], "not_accepted");
}

TEST(Summary, WritesNumbersWithoutTheNoiseOfTheirLastBits) {
  const std::string text = to_json(house());
  EXPECT_THAT(text, HasSubstr("\"sim_s\": 1560.0,"));
  EXPECT_THAT(text, HasSubstr("\"minutes\": 25.3,"));
  EXPECT_THAT(text, HasSubstr("\"tiles_mapped\": 206,"));
}

TEST(Summary, IsTheSameTextForTheSameRun) {
  EXPECT_EQ(to_json(house()), to_json(house()));
}

TEST(Summary, KeepsSeedsOfSixtyFourBits) {
  Summary summary = house();
  summary.seed = std::numeric_limits<std::uint64_t>::max();
  EXPECT_THAT(to_json(summary), HasSubstr("\"seed\": 18446744073709551615,"));
}

TEST(Summary, LeavesTheMapOutWhenTheMissionHadNone) {
  Summary summary = house();
  summary.map.reset();
  EXPECT_FALSE(nlohmann::json::parse(to_json(summary)).contains("map"));
}

TEST(Summary, IsAcceptedWhenNothingWasExpected) {
  EXPECT_EQ(verdict_of(house()), "accepted");
}

TEST(Summary, IsInterruptedWhateverItsFiguresSay) {
  Summary summary = house();
  summary.interrupted = true;
  EXPECT_EQ(verdict_of(summary), "interrupted");
}

TEST(Expectations, AreMetOnTheirLimits) {
  const auto judged = judge({{.name = "a", .min = 2.0},
                             {.name = "a", .max = 2.0},
                             {.name = "a", .min = 2.1},
                             {.name = "a", .max = 1.9}},
                            {{"a", 2.0}});
  EXPECT_TRUE(judged[0].ok);
  EXPECT_TRUE(judged[1].ok);
  EXPECT_FALSE(judged[2].ok);
  EXPECT_FALSE(judged[3].ok);
}

TEST(Expectations, AreNotMetByFiguresThatTheMissionDidNotProduce) {
  EXPECT_FALSE(judge({{.name = "minutes"}}, {})[0].ok);
  EXPECT_FALSE(judge({{.name = "a"}}, {{"a", std::numeric_limits<double>::quiet_NaN()}})[0].ok);
}

TEST(Expectations, KnowEveryFigureOfTheMapAndTheLinks) {
  const auto names = figure_names();
  for (const char* name : {"tiles_mapped", "minutes", "moves_missed", "roomba_frames_corrupt", "sim_s"}) {
    EXPECT_THAT(names, Contains(name));
  }
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
}

TEST(Expectations, ComplainAboutAnUnknownFigureAndListTheKnownOnes) {
  EXPECT_EQ(complain_about({{.name = "minutes", .max = 26.0}}), std::nullopt);
  const auto complaint = complain_about({{.name = "tiles_maped", .min = 207.0}});
  ASSERT_TRUE(complaint);
  EXPECT_THAT(*complaint, HasSubstr("'tiles_maped'"));
  EXPECT_THAT(*complaint, HasSubstr("tiles_mapped"));
}

TEST(Timing, GivesTheRealTimeFactorAndItsSplit) {
  const auto json = nlohmann::json::parse(to_json(
      Timing{.sim_s = 1500.0, .wall_s = 3.0, .physics_s = 1.0, .devices_s = 0.5, .controller_s = 0.5}));
  EXPECT_EQ(json["rtf"], 500.0);
  EXPECT_EQ(json["split"]["physics_s"], 1.0);
  EXPECT_TRUE(json["split"].contains("render_s"));
}

}  // namespace
}  // namespace sensotwin::twin
