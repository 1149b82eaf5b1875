// SPDX-License-Identifier: MIT
#include "twin/trace/plan_picture.hpp"

#include <gmock/gmock.h>

#include "robot/config/problem.hpp"
#include "trace_bench.hpp"
#include "twin/scene/map_import.hpp"

namespace sensotwin::twin {
namespace {

using testing::HasSubstr;

/// 4 x 2 pixels: a black one in the upper left corner, the rest white.
const std::string kPgm = "P2\n4 2\n255\n0 255 255 255\n255 255 255 255\n";

std::string trouble(const std::string& bytes) {
  try {
    (void)plan_from_bytes(bytes, "plan");
  } catch (const robot::LoadError& error) {
    EXPECT_EQ(error.exit_code(), robot::kExitInvalid);
    return error.what();
  }
  return "none";
}

TEST(PlanPicture, ShowsAPgmAsAPng) {
  const PlanPicture plan = plan_from_bytes(kPgm, "plan.pgm");
  EXPECT_EQ(plan.columns, 4);
  EXPECT_EQ(plan.rows, 2);
  EXPECT_TRUE(plan.png.starts_with("\x89PNG"));
  EXPECT_EQ(plan_from_bytes(plan.png, "again").png, plan.png);
}

TEST(PlanPicture, SaysWhatIsNoPicture) {
  EXPECT_THAT(trouble(""), HasSubstr("is empty"));
  EXPECT_THAT(trouble("GIF89a"), HasSubstr("error: "));
  EXPECT_THAT(trouble(kPgm.substr(0, 14)), HasSubstr("cut off"));
  const std::string png = plan_from_bytes(kPgm, "plan").png;
  EXPECT_THAT(trouble(png.substr(0, png.size() / 2)), HasSubstr("cut off"));
}

TEST(PlanPicture, RefusesAPictureThatUnpacksToGigabytesBeforeItIsUnpacked) {
  std::string png = plan_from_bytes(kPgm, "plan").png;
  // Width and height in the first chunk: 16 000 each.
  for (const std::size_t at : {16u, 20u}) {
    png.replace(at, 4, std::string{'\0', '\0', '\x3e', '\x80'});
  }
  EXPECT_THAT(trouble(png), HasSubstr("more than 40 million pixels"));
}

TEST(PlanPicture, TakesScaleAndPlaceOfAMap) {
  TraceBench bench;
  bench.put("map.pgm", kPgm);
  bench.put("map.yaml",
            "image: map.pgm\nresolution: 0.1\norigin: [1, 2, 0.5]\nnegate: 0\noccupied_thresh: "
            "0.6\nfree_thresh: 0.2\n");
  const PlanPicture plan = read_plan(bench.folder / "map.yaml");
  EXPECT_TRUE(plan.scaled);
  EXPECT_DOUBLE_EQ(plan.resolution_m, 0.1);
  EXPECT_DOUBLE_EQ(plan.X_WO.p_m.y(), 2.0);
  EXPECT_DOUBLE_EQ(plan.occupied_thresh, 0.6);
}

TEST(PlanPicture, MissesThePictureOfAMap) {
  TraceBench bench;
  bench.put("map.yaml",
            "image: gone.pgm\nresolution: 0.1\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: "
            "0.6\nfree_thresh: 0.2\n");
  try {
    (void)read_plan(bench.folder / "map.yaml");
    FAIL();
  } catch (const robot::LoadError& error) {
    EXPECT_EQ(error.exit_code(), robot::kExitMissing);
    EXPECT_THAT(error.what(), HasSubstr("gone.pgm"));
  }
}

TEST(PlanPicture, BecomesAMapWithTheSameWalls) {
  TraceBench bench;
  PlanPicture plan = plan_from_bytes(kPgm, "plan");
  plan.X_WO = {{5.0, 6.0}, 0.0};
  const MapFiles files = map_files(plan, "m.pgm");
  bench.put("m.pgm", files.pgm);
  bench.put("m.yaml", files.yaml);
  const OccupancyMap map = read_map(bench.folder / "m.yaml");
  EXPECT_EQ(map.count(Cell::kOccupied), 1u);
  EXPECT_EQ(map.at(0, 1), Cell::kOccupied);
  EXPECT_EQ(map.at(robot::Vec2{5.01, 6.09}), Cell::kOccupied);
}

TEST(PlanPicture, KeepsThinWallsWhenAFineScanBecomesAMap) {
  TraceBench bench;
  PlanPicture plan = plan_from_bytes(kPgm, "plan");
  plan.resolution_m = 0.005;
  const MapFiles files = map_files(plan, "m.pgm");
  bench.put("m.pgm", files.pgm);
  bench.put("m.yaml", files.yaml);
  const OccupancyMap map = read_map(bench.folder / "m.yaml");
  EXPECT_DOUBLE_EQ(map.resolution_m, 0.02);
  EXPECT_EQ(map.columns, 1);
  EXPECT_EQ(map.at(0, 0), Cell::kOccupied);
  // One cell of 4 x 4 pixels, of which the picture fills the upper two rows.
  EXPECT_DOUBLE_EQ(map.X_WO.p_m.y(), -0.01);
}

TEST(TraceSession, HoldsAPictureThatWasDroppedOnThePage) {
  TraceBench bench;
  const TraceReply taken = bench.raw("upload", kPgm, "my plan.pgm");
  ASSERT_EQ(taken.status, 200) << taken.body;
  const Json plan = Json::parse(taken.body)["plan"];
  EXPECT_EQ(plan["width_px"], 4);
  const TraceReply picture = bench.raw("plan", "", plan["id"]);
  EXPECT_EQ(picture.type, "image/png");
  EXPECT_EQ(bench.raw("plan", "", "0123").status, 404);
  EXPECT_EQ(bench.raw("upload", "no picture", "x.png").status, 422);
}

TEST(TraceSession, KeepsThePictureBesideATracing) {
  TraceBench bench;
  Json document = small_document();
  document["plan"] = Json::parse(bench.raw("upload", kPgm, "p.pgm").body)["plan"];
  document["plan"]["resolution_m"] = 0.25;
  document["plan"]["scaled"] = true;
  bench.ask("save", TraceBench::to_save(document));
  const Json opened = bench.ask("open", {{"name", "three.trace.json"}});
  EXPECT_EQ(opened["document"]["plan"]["resolution_m"], 0.25);
  EXPECT_EQ(bench.raw("plan", "", opened["document"]["plan"]["id"]).status, 200);
  std::filesystem::remove(bench.folder / "three.plan.png");
  const Json without = bench.ask("open", {{"name", "three.trace.json"}});
  EXPECT_TRUE(without["document"]["plan"].is_null());
  EXPECT_THAT(without["note"].get<std::string>(), HasSubstr("three.plan.png"));
}

TEST(TraceSession, RefusesAPlanOfUnknownScaleAsWalls) {
  TraceBench bench;
  Json request = TraceBench::to_save(small_document());
  request["document"]["plan"] = Json::parse(bench.raw("upload", kPgm, "p.pgm").body)["plan"];
  request["document"]["scene"]["walls"] = "plan";
  EXPECT_THAT(bench.ask("scene", request, 422)["error"].get<std::string>(), HasSubstr("no scale"));
}

}  // namespace
}  // namespace sensotwin::twin
