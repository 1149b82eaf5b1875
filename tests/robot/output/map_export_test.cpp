// SPDX-License-Identifier: MIT
#include "robot/output/map_export.hpp"

#include <gtest/gtest.h>

#include <string>

#include "robot/output/run_folder.hpp"
#include "tests/robot/output/temporary_folder.hpp"

namespace sensotwin::robot {
namespace {

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
}  // namespace sensotwin::robot
