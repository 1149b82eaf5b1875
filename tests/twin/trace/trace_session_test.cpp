// SPDX-License-Identifier: MIT
#include "twin/trace/trace_session.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "robot/settings/hallway_file.hpp"
#include "trace_bench.hpp"
#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {
namespace {

using testing::HasSubstr;

TEST(TraceSession, ChecksAMapAsTheRobotsReaderDoes) {
  TraceBench bench;
  const Json checked = bench.ask("check", {{"document", small_document()}});
  EXPECT_TRUE(checked["sound"]);
  EXPECT_EQ(checked["problems"].size(), 0u) << checked["problems"];
  const robot::HallwayFile file = robot::read_hallway_text(checked["text"], "checked");
  EXPECT_EQ(file.map.place_of(9)->from, robot::CompassPoint::kEast);
  EXPECT_EQ(file.map.node(*file.map.find("d")).side(robot::CompassPoint::kEast).hallway,
            robot::Hallway::kUnknown);
}

TEST(TraceSession, NamesThePlaceAndTheSideOfAMistake) {
  TraceBench bench;
  Json document = small_document();
  document["hallways"]["places"][2]["W"]["tags"] = {"6"};
  const Json checked = bench.ask("check", {{"document", document}});
  EXPECT_FALSE(checked["sound"]);
  ASSERT_EQ(checked["problems"].size(), 1u);
  EXPECT_EQ(checked["problems"][0]["place"], "f");
  EXPECT_EQ(checked["problems"][0]["side"], "W");
  EXPECT_THAT(checked["problems"][0]["what"].get<std::string>(),
              HasSubstr("has tag 6, which is at 'c' north too"));
}

TEST(TraceSession, FindsThePlaceOfAMistakeThoughNamesHoldDots) {
  TraceBench bench;
  Json document = small_document();
  document["hallways"]["places"].push_back({{"name", "c.1"}, {"N", {{"to", "?"}, {"tags", {"no tag"}}}}});
  const Json checked = bench.ask("check", {{"document", document}});
  ASSERT_EQ(checked["problems"].size(), 1u);
  EXPECT_EQ(checked["problems"][0]["place"], "c.1");
  EXPECT_EQ(checked["problems"][0]["side"], "N");
}

TEST(TraceSession, TellsOfANameThatIsThereTwice) {
  TraceBench bench;
  Json document = small_document();
  document["hallways"]["places"].push_back({{"name", "c"}});
  const Json checked = bench.ask("check", {{"document", document}});
  EXPECT_FALSE(checked["sound"]);
  EXPECT_EQ(checked["problems"][0]["place"], "c");
}

TEST(TraceSession, PlansAWayByThePlannerOfTheRobotAndSaysItInWords) {
  TraceBench bench;
  const Json route = bench.ask("route", {{"document", small_document()}, {"from", "9"}, {"to", "d"}});
  ASSERT_TRUE(route["found"]);
  EXPECT_EQ(route["start"], "c");
  EXPECT_EQ(route["start_words"], "Tag 9: at c, having come in from the east.");
  // "coming from the East side, turns to the right ... and going out to the North side" (Tsukiyama, section
  // 3).
  EXPECT_EQ(route["words"][0], "Turn right and go north 6.0 m to d (tag 11)");
}

TEST(TraceSession, SaysThatOnlyAnUnknownHallwayMightLeadThere) {
  TraceBench bench;
  const Json route = bench.ask("route", {{"document", small_document()},
                                         {"from", "d"},
                                         {"to", "f"},
                                         {"blocked", Json::array({Json::array({"c", "E"})})}});
  EXPECT_FALSE(route["found"]);
  EXPECT_THAT(route["reason"].get<std::string>(), HasSubstr("marked ?"));
}

TEST(TraceSession, PlansNothingOverAMapWithMistakes) {
  TraceBench bench;
  Json document = small_document();
  document["hallways"]["places"][0]["N"]["to"] = "nowhere";
  const Json refused = bench.ask("route", {{"document", document}, {"from", "c"}, {"to", "f"}}, 422);
  EXPECT_THAT(refused["error"].get<std::string>(), HasSubstr("mistakes"));
}

TEST(TraceSession, SavesTheFileThatTheRobotReads) {
  TraceBench bench;
  const Json saved = bench.ask("save", TraceBench::to_save(small_document()));
  EXPECT_FALSE(saved["draft"]);
  const robot::HallwayFile file = robot::read_hallway_file(bench.folder / "three.hallways.yaml");
  EXPECT_EQ(file.map.nodes().size(), 3u);
  EXPECT_EQ(saved["stamps"].size(), 2u);
}

TEST(TraceSession, OpensWhatItSaved) {
  TraceBench bench;
  bench.ask("save", TraceBench::to_save(small_document()));
  const Json tracing = bench.ask("open", {{"name", "three.trace.json"}});
  EXPECT_EQ(tracing["document"]["hallways"], small_document()["hallways"]);
  EXPECT_EQ(tracing["hallways_file"], "three.hallways.yaml");
  EXPECT_EQ(tracing["stamps"].size(), 2u);
  const Json map = bench.ask("open", {{"name", "three.hallways.yaml"}});
  EXPECT_EQ(map["hallways"]["places"][1]["E"]["tags"], Json({"12"}));
}

/// Whatever the page does with it, the server loses nothing of a building that is drawn with slanted
/// hallways.
TEST(TraceSession, OpensTheHallwaysOfRealBuildingsAndSavesThemTheSame) {
  for (const char* name : {"stata_hallways.yaml", "hospital_hallways.yaml"}) {
    TraceBench bench;
    const auto file = std::filesystem::path(SENSOTWIN_SOURCE_DIR) / "scenes/buildings" / name;
    bench.put(name, content_of(file));
    Json document = small_document();
    document["hallways"] = bench.ask("open", {{"name", name}})["hallways"];
    bench.ask("save", TraceBench::to_save(document));
    EXPECT_EQ(bench.content("three.hallways.yaml"), robot::hallway_yaml(robot::read_hallway_file(file)));
  }
}

TEST(TraceSession, GoesOnWithATracingThatTheCommandLineNames) {
  TraceBench bench;
  bench.ask("save", TraceBench::to_save(small_document()));
  TemporaryFolder elsewhere;
  TraceSession session(elsewhere.path(), bench.scratch.path());
  session.open_operand(bench.folder / "three.trace.json");
  const Json said = Json::parse(session.answer({"session", "", ""}).body);
  EXPECT_EQ(said["name"], "three");
  EXPECT_EQ(said["opened"]["document"]["hallways"], small_document()["hallways"]);
}

TEST(TraceSession, SavesNoHallwayMapUnderTheNameOfASceneOrMap) {
  TraceBench bench;
  for (const char* name : {"three.scene.yaml", "three.map.yaml", "three.txt"}) {
    Json request = TraceBench::to_save(small_document());
    request["hallways_file"] = name;
    bench.ask("save", request, 400);
  }
}

TEST(TraceSession, KeepsADraftThatTheRobotCouldNotRead) {
  TraceBench bench;
  bench.ask("save", TraceBench::to_save(small_document()));
  const std::string sound = bench.content("three.hallways.yaml");
  Json document = small_document();
  document["hallways"]["places"][0]["N"]["to"] = "nowhere";
  Json request = TraceBench::to_save(document);
  request["overwrite"] = true;
  const Json saved = bench.ask("save", request);
  EXPECT_TRUE(saved["draft"]);
  EXPECT_EQ(saved["problems"].size(), 1u);
  EXPECT_EQ(bench.content("three.hallways.yaml"), sound);
  EXPECT_THAT(bench.content("three.trace.json"), HasSubstr("nowhere"));
}

TEST(TraceSession, AsksBeforeItReplacesWhatOthersWrote) {
  TraceBench bench;
  Json request = TraceBench::to_save(small_document());
  request["stamps"] = bench.ask("save", request)["stamps"];
  bench.put("three.hallways.yaml", "somebody else's");
  request["document"]["hallways"]["width_m"] = 1.8;
  const Json conflict = bench.ask("save", request, 409);
  EXPECT_EQ(conflict["conflicts"], Json({"three.hallways.yaml"}));
  EXPECT_EQ(bench.content("three.hallways.yaml"), "somebody else's");
  request["overwrite"] = true;
  bench.ask("save", request);
  EXPECT_THAT(bench.content("three.hallways.yaml"), HasSubstr("width_m: 1.8"));
}

TEST(TraceSession, AsksBeforeItReplacesAFileItNeverSaw) {
  TraceBench bench;
  bench.put("three.trace.json", "{}");
  EXPECT_EQ(bench.ask("save", TraceBench::to_save(small_document()), 409)["conflicts"],
            Json({"three.trace.json"}));
}

TEST(TraceSession, WritesASceneThatTheTwinReads) {
  TraceBench bench;
  Json request = TraceBench::to_save(small_document());
  const Json tried = bench.ask("scene", request);
  ASSERT_TRUE(tried["sound"]) << tried["problems"];
  EXPECT_EQ(bench.session.answer({"session", "", ""}).body.find("three.scene.yaml"), std::string::npos);
  request["scene"] = true;
  bench.ask("save", request);
  const Scene scene = read_scene(bench.folder / "three.scene.yaml");
  EXPECT_EQ(scene.mission.hallway->to, "f");
  EXPECT_EQ(scene.world.hallway_tags.size(), 5u);
}

TEST(TraceSession, RefusesASceneWithAMistakeAndWritesNothing) {
  TraceBench bench;
  Json request = TraceBench::to_save(small_document());
  request["document"]["scene"]["to"] = "nowhere";
  request["scene"] = true;
  const Json refused = bench.ask("save", request, 422);
  EXPECT_THAT(refused["problems"][0]["what"].get<std::string>(), HasSubstr("nowhere"));
  EXPECT_TRUE(std::filesystem::is_empty(bench.folder.path()));
}

TEST(TraceSession, MakesACarpetInARoom) {
  TraceBench bench;
  Json request = TraceBench::to_save(small_document());
  request["document"]["hallways"]["places"] = Json::array();
  request["document"]["scene"] = {
      {"kind", "carpet"},
      {"walls", "room"},
      {"seed", 7},
      {"room_m", {{0, 0}, {2, 0}, {2, 2}, {0, 2}}},
      {"carpet", {{"tile_m", 0.508}, {"without", Json::array({Json::array({0, 0})})}}}};
  const Json tried = bench.ask("scene", request);
  ASSERT_TRUE(tried["sound"]) << tried["problems"];
  EXPECT_EQ(tried["tile_count"], 15);
}

TEST(TraceSession, MakesASceneOfCeilingTags) {
  TraceBench bench;
  Json request = TraceBench::to_save(small_document());
  request["document"]["scene"] = {{"kind", "ceiling"},
                                  {"walls", "room"},
                                  {"seed", 7},
                                  {"controller", "own"},
                                  {"room_m", {{-3, -3}, {9, -3}, {9, 3}, {-3, 3}}},
                                  {"start", {{"at_m", {0, 0}}, {"heading_deg", 0}}},
                                  {"ceiling_tags",
                                   {{{"name", "A"}, {"at_m", {0, 0}}, {"height_m", 3}},
                                    {{"name", "B"}, {"at_m", {4, 0}}, {"height_m", 3}}}}};
  const Json tried = bench.ask("scene", request);
  EXPECT_TRUE(tried["sound"]) << tried["problems"];
}

TEST(TraceSession, SaysWhatIsMissingWhereThereIsNoPlan) {
  TraceBench bench;
  Json request = TraceBench::to_save(small_document());
  request["document"]["scene"]["walls"] = "plan";
  EXPECT_THAT(bench.ask("scene", request, 422)["error"].get<std::string>(), HasSubstr("there is no plan"));
}

TEST(TraceSession, RefusesNamesThatLeadOutOfTheFolder) {
  TraceBench bench;
  const std::vector<std::string> names{"../three", "/etc/passwd", "a/b",  "..",   ".hidden",
                                       "",         "-rf",         "a\nb", "a\\b", {"a\0b", 3}};
  for (const std::string& name : names) {
    Json request = TraceBench::to_save(small_document());
    request["name"] = name;
    EXPECT_EQ(bench.raw("save", request.dump()).status, 400) << name;
    request = TraceBench::to_save(small_document());
    request["hallways_file"] = name + ".yaml";
    EXPECT_EQ(bench.raw("save", request.dump()).status, 400) << name;
    EXPECT_EQ(bench.raw("open", Json{{"name", name}}.dump()).status, 400) << name;
  }
  EXPECT_TRUE(std::filesystem::is_empty(bench.folder.path()));
}

TEST(TraceSession, RefusesWhatIsNoDocument) {
  TraceBench bench;
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  const std::vector<std::string> bodies{"",
                                        "nonsense",
                                        "[]",
                                        "{",
                                        "\xff\xfe",
                                        "{\"document\": 7}",
                                        "{\"document\":" + deep + "}",
                                        "{\"document\": {\"hallways\": []}}",
                                        "{\"document\": {\"hallways\": {\"places\": {}}}}",
                                        "{\"document\": {\"hallways\": {\"places\": [7]}}}"};
  for (const char* what : {"check", "route", "scene", "save", "open"}) {
    for (const std::string& body : bodies) {
      const int status = bench.raw(what, body).status;
      EXPECT_TRUE(status >= 400 && status < 500) << what << " " << body.substr(0, 60);
    }
  }
  EXPECT_EQ(bench.raw("check", std::string(TraceSession::kBodyMax + 1, ' ')).status, 413);
  EXPECT_EQ(bench.raw("no such thing", "{}").status, 404);
}

TEST(TraceSession, LetsTheReaderSayWhatIsWrongWithValuesOfOtherTypes) {
  TraceBench bench;
  Json document = small_document();
  document["hallways"]["places"][0]["at_m"] = "here";
  document["hallways"]["places"][1]["S"] = 12;
  document["hallways"]["places"][2]["colour"] = "red";
  const Json checked = bench.ask("check", {{"document", document}});
  EXPECT_FALSE(checked["sound"]);
  EXPECT_GE(checked["problems"].size(), 3u);
}

TEST(TraceSession, RefusesMorePlacesThanAnybodyDraws) {
  TraceBench bench;
  Json document = small_document();
  for (int i = 0; i < 2001; ++i) {
    document["hallways"]["places"].push_back({{"name", "p" + std::to_string(i)}});
  }
  bench.ask("check", {{"document", document}}, 413);
}

}  // namespace
}  // namespace sensotwin::twin
