// SPDX-License-Identifier: MIT
#include "twin/validate/report.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "seeds_of_figures.hpp"
#include "twin/validate/junit.hpp"
#include "twin/validate/report_pictures.hpp"
#include "well_formed_xml.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const Expectation kAtMostEight{.name = "minutes", .min = std::nullopt, .max = 8.0};

TEST(SeedsText, JoinsNeighbours) {
  EXPECT_EQ(seeds_text({1, 2, 3, 4}), "1..4");
  EXPECT_EQ(seeds_text({3, 7, 8, 20}), "3, 7..8, 20");
  EXPECT_EQ(seeds_text({}), "");
}

TEST(RerunCommand, SurvivesAShell) {
  Validation validation = validated(expecting(kAtMostEight), runs_with(up_to(3)));
  EXPECT_EQ(rerun_command(validation, 2), "twin run scenes/made_up.yaml --seed 2");
  validation.scene = "my scenes/it's.yaml";
  validation.set = {"robot.start.at_m=[1, 2]", "time_limit_s=9"};
  EXPECT_EQ(
      rerun_command(validation, 2),
      "twin run 'my scenes/it'\\''s.yaml' --seed 2 --set 'robot.start.at_m=[1, 2]' --set time_limit_s=9");
}

TEST(Table, NamesTheFailingSeedsAndHowToRepeatThem) {
  const std::string table = to_table(validated(expecting(kAtMostEight), runs_with(up_to(10))));
  EXPECT_THAT(table, HasSubstr("made_up: 10 of 10 seeds (1..10), intervals at 95 %\n"));
  EXPECT_THAT(table, HasSubstr("MISSED  minutes at most 8 in every seed"));
  EXPECT_THAT(table, HasSubstr("8 of 10  44.39 to 97.48 %"));  // Clopper and Pearson, 8 of 10
  EXPECT_THAT(table, HasSubstr("missed by seeds 9..10\n  twin run scenes/made_up.yaml --seed 9\n"));
  EXPECT_THAT(table, HasSubstr("verdict not_accepted\n"));
}

TEST(Table, SaysTheBoundBesideAFigureThatHasOne) {
  std::vector<RunOutcome> runs = runs_with({1.0, 2.0});
  for (RunOutcome& run : runs) {
    run.figures = {{"rmse_m", 0.009}, {"bound_m", 0.0075}};
  }
  const Expectation expectation{.name = "rmse_m", .min = std::nullopt, .max = 0.01};
  EXPECT_THAT(to_table(validated(expecting(expectation), runs)),
              HasSubstr("bound   rmse_m: posterior Cramer-Rao, 0.0075\n"));
  EXPECT_THAT(to_table(validated(expecting(kAtMostEight), runs_with({1.0}))), Not(HasSubstr("Cramer-Rao")));
}

TEST(Report, SaysInJsonWhatWasAskedFoundAndMissed) {
  const auto json = nlohmann::json::parse(to_json(validated(expecting(kAtMostEight), runs_with(up_to(10)))));
  EXPECT_EQ(json["verdict"], "not_accepted");
  EXPECT_EQ(json["seeds"], "1..10");
  EXPECT_EQ(json["seeds_done"], 10);
  const auto& expect = json["expect"][0];
  EXPECT_EQ(expect["figure"], "minutes");
  EXPECT_EQ(expect["ok"], false);
  EXPECT_EQ(expect["kept"], 8);
  EXPECT_EQ(expect["failing"][1]["seed"], 10);
  EXPECT_EQ(expect["failing"][1]["command"], "twin run scenes/made_up.yaml --seed 10");
  EXPECT_EQ(json["figures"]["minutes"]["median"], 5.5);
}

TEST(Report, OfMissingSeedsIsInterruptedEvenWhereAllIsKept) {
  Validation validation = validated(expecting(kAtMostEight), runs_with(up_to(3)));
  EXPECT_EQ(verdict_of(validation), "accepted");
  validation.seeds.push_back(4);
  EXPECT_EQ(verdict_of(validation), "interrupted");
  EXPECT_THAT(to_table(validation), HasSubstr("3 of 4 seeds (1..4)"));
}

TEST(JUnit, HasACaseForEachThresholdAndTellsFailuresApart) {
  Expectation expectation = kAtMostEight;
  expectation.min = 0.0;
  const std::string xml = to_junit(validated(expecting(expectation), runs_with(up_to(10))));
  EXPECT_EQ(xml_fault(xml), "");
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"made_up\" tests=\"2\" failures=\"1\" errors=\"0\""));
  EXPECT_THAT(xml, HasSubstr("name=\"minutes at least 0 in every seed\""));
  EXPECT_THAT(xml, HasSubstr("seed 9: 9\n  twin run scenes/made_up.yaml --seed 9\n"));
}

TEST(JUnit, StaysWellFormedWhateverAScenesPathHolds) {
  Validation validation = validated(expecting(kAtMostEight), runs_with(up_to(10)));
  validation.scene = "<a & \"b\">\x01\xFFü.yaml";
  const std::string xml = to_junit(validation);
  EXPECT_EQ(xml_fault(xml), "");
  EXPECT_THAT(xml, HasSubstr("&lt;a &amp; &quot;b&quot;&gt;\xEF\xBF\xBD\xEF\xBF\xBDü.yaml"));
}

TEST(JUnit, OfAnInterruptedValidationIsNeverGreen) {
  Validation validation = validated(expecting(kAtMostEight), runs_with(up_to(3)));
  validation.seeds.push_back(4);
  const std::string xml = to_junit(validation);
  EXPECT_EQ(xml_fault(xml), "");
  EXPECT_THAT(xml, HasSubstr("tests=\"1\" failures=\"0\" errors=\"1\""));
  EXPECT_THAT(xml, HasSubstr("<error message=\"interrupted after 3 of 4 seeds\"/>"));
}

TEST(XmlFault, FindsWhatIsNotWellFormed) {
  EXPECT_EQ(xml_fault("<?xml version=\"1.0\"?><a><b c=\"d\"/>text &amp; more</a>"), "");
  EXPECT_NE(xml_fault("<a><b></a></b>"), "");
  EXPECT_NE(xml_fault("<a>R & D</a>"), "");
  EXPECT_NE(xml_fault("<a b=\"<\"/>"), "");
  EXPECT_NE(xml_fault("<a/><b/>"), "");
}

TEST(Distribution, CarriesThresholdsAndTheIntervalsOfStatistics) {
  Expectation expectation = kAtMostEight;
  expectation.statistics[1] = Bounds{std::nullopt, 7.0};  // median
  const Validation validation = validated(expecting(expectation), runs_with(up_to(10)));
  const render::DistributionChart chart = distribution_of(validation, "minutes");
  EXPECT_EQ(chart.values.size(), 10u);
  ASSERT_EQ(chart.limits.size(), 2u);
  EXPECT_TRUE(chart.limits[0].of_each);
  EXPECT_FALSE(chart.limits[1].of_each);
  EXPECT_FALSE(chart.rows[0].interval);
  EXPECT_EQ(chart.rows[1].interval->low, 2.0);
  EXPECT_EQ(chart.rows[1].interval->high, 9.0);
  EXPECT_THAT(chart.rows[1].text, HasSubstr("median of minutes at most 7: 5.5, interval 2 to 9, open"));
}

}  // namespace
}  // namespace sensotwin::twin
