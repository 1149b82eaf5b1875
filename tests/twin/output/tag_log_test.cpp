// SPDX-License-Identifier: MIT
#include "twin/output/tag_log.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/robot/output/temporary_folder.hpp"

namespace sensotwin::twin {
namespace {

// The first rows of the data study's Test8, spot (1,1): what sllurp wrote of them, but for the reader.
TEST(TagLogWriter, WritesWhatSllurpWrites) {
  constexpr double kUnit_rad = 2.0 * std::numbers::pi / 4096.0;
  const TemporaryFolder folder;
  const robot::Epc epc{{0x30, 0x34, 0x35, 0xfc, 0x88, 0x03, 0xd0, 0x56, 0xd1, 0x5b, 0x96, 0x3f}};
  TagLogWriter writer{robot::OutputFile{folder / "tags.csv"}};
  writer.add({.time_s = 77.72374,
              .epc = epc,
              .antenna = 1,
              .channel = 7,
              .phase_rad = 192 * kUnit_rad,
              .rssi_dbm = -39.0,
              .doppler_hz = 20.75});
  writer.add({.time_s = 77.783627,
              .epc = epc,
              .antenna = 3,
              .channel = 7,
              .phase_rad = 1964 * kUnit_rad,
              .rssi_dbm = -69.0,
              .doppler_hz = -12.1875});
  writer.finish();
  EXPECT_EQ(content_of(folder / "tags.csv"),
            "timestamp,reader,antenna,rssi,epc,phase_angle,channel_index,doppler_frequency\n"
            "77.723740,twin,1,-39,b'303435fc8803d056d15b963f',192,7,332\n"
            "77.783627,twin,3,-69,b'303435fc8803d056d15b963f',1964,7,-195\n");
}

// Protocols study, 2.6: a PeakRSSI of -68 beside an Impinj RSSI of -68.5.
TEST(TagLogWriter, CutsRssiAndWrapsAPhaseJustBelowAWholeTurn) {
  const TemporaryFolder folder;
  TagLogWriter writer{robot::OutputFile{folder / "tags.csv"}};
  writer.add({.phase_rad = 2.0 * std::numbers::pi - 1e-6, .rssi_dbm = -68.5});
  writer.finish();
  EXPECT_TRUE(
      content_of(folder / "tags.csv").ends_with("0.000000,twin,1,-68,b'000000000000000000000000',0,1,0\n"));
}

}  // namespace
}  // namespace sensotwin::twin
