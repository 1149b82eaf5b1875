// SPDX-License-Identifier: MIT
// `twin calibrate` as a process, on logs of a tag at three distances from one antenna.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "robot/base/random.hpp"
#include "tests/robot/output/temporary_folder.hpp"
#include "twin/output/tag_log.hpp"
#include "twin_process.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::HasSubstr;

constexpr double kTurn_rad = 2.0 * std::numbers::pi;

/// Four reads on each of 50 channels in rising order of frequency, phase falling with a delay.
void write_log(const std::filesystem::path& file, double delay_s) {
  robot::RandomStream random = robot::RandomStream{1}.fork(file.filename().string());
  TagLogWriter writer{robot::OutputFile{file}};
  for (std::uint16_t read = 0; read < 200; ++read) {
    const double hz = 902.75e6 + 0.5e6 * (read / 4);
    const double rad = -kTurn_rad * hz * delay_s + random.normal(0.0, 0.01);
    writer.add({.time_s = 0.014 * read,
                .channel = static_cast<std::uint16_t>(read / 4 + 1),
                .phase_rad = rad - kTurn_rad * std::floor(rad / kTurn_rad),
                .rssi_dbm = -40.0});
  }
  writer.finish();
}

/// Three logs in the folder. \returns them as operands
std::string three_logs(const TemporaryFolder& folder) {
  std::string operands;
  for (const double delay_ns : {60.0, 66.0, 73.0}) {
    const auto file = folder / (std::to_string(static_cast<int>(delay_ns)) + ".csv");
    write_log(file, 1e-9 * delay_ns);
    operands += " '" + file.string() + "'";
  }
  return operands;
}

TEST(CalibrateProcess, ReportsAndWritesProfileAndPicture) {
  const TemporaryFolder folder;
  const std::string logs = three_logs(folder);
  const std::string files =
      " --out '" + (folder / "reader.yaml").string() + "' --chart '" + (folder / "reader.png").string() + "'";
  const Outcome outcome = twin("calibrate" + logs + files + " --starts 20 --resamples 20");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("3 logs, 3 links of tag and antenna, 600 reads; seed 1"));
  EXPECT_THAT(outcome.out, HasSubstr("Hop table recovered from 3 strong links"));
  EXPECT_THAT(content_of(folder / "reader.yaml"), HasSubstr("channels_hz: [902750000, 903250000,"));
  EXPECT_TRUE(content_of(folder / "reader.png").starts_with("\x89PNG\r\n\x1a\n"));
  EXPECT_EQ(twin("calibrate" + logs + files).code, 73) << "exists";
}

TEST(CalibrateProcess, TakesThePublishedHopTableAndTellsTheSign) {
  const TemporaryFolder folder;
  const std::string logs = three_logs(folder);
  std::ofstream table(folder / "table.csv");
  table << "channel_index,freq_mhz\n";
  for (int i = 0; i < 50; ++i) {
    table << i + 1 << ',' << 902.75 + 0.5 * i << '\n';
  }
  table.close();
  const Outcome outcome = twin("calibrate" + logs + " --json --resamples 20 --hop-table '" +
                               (folder / "table.csv").string() + "'");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["frequency"]["phase_sign"], -1.0);
  EXPECT_GT(json["frequency"]["coherence_falling"], 0.99);
  EXPECT_NEAR(json["frequency"]["links"][1]["delay_s"].get<double>(), 66e-9, 0.5e-9);
}

TEST(CalibrateProcess, RefusesBadInputWithPlaceAndCode) {
  const TemporaryFolder folder;
  const auto broken = folder / "broken.csv";
  std::ofstream{broken} << "timestamp,antenna,rssi,epc,phase_angle,channel_index,doppler_frequency\n"
                           "1.0,1,-60,30,17,3,0\n1.0,1,-60,30,5000,3,0\n";
  const Outcome outcome = twin("calibrate '" + broken.string() + "'");
  EXPECT_EQ(outcome.code, 65);
  EXPECT_THAT(outcome.err, HasSubstr("broken.csv:3:14: error: phase_angle: '5000'"));
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(twin("calibrate '" + (folder / "none.csv").string() + "'").code, 66);
  EXPECT_EQ(twin("calibrate").code, 2);
  EXPECT_EQ(twin("calibrate" + three_logs(folder) + " --band 902:50").code, 2);
  EXPECT_EQ(twin("calibrate" + three_logs(folder) + " --band 902.75:0.5:16").code, 65) << "channel 50 of 16";
}

}  // namespace
}  // namespace sensotwin::twin
