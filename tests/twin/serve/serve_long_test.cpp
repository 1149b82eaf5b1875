// SPDX-License-Identifier: MIT
// An hour of simulated time beside clients that never read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "llrp_session.hpp"
#include "tests/robot/output/temporary_folder.hpp"
#include "twin_process.hpp"

namespace sensotwin::twin {
namespace {

/// Resident memory of a process, kB.
long resident_kb(pid_t process) {
  const std::string status = content_of("/proc/" + std::to_string(process) + "/status");
  const std::size_t at = status.find("VmRSS:");
  return at == std::string::npos ? 0 : std::stol(status.substr(at + 6));
}

TEST(ServedHour, TakesNoMoreMemoryAtItsEndThanAfterItsFirstTenMinutes) {
  const TemporaryFolder folder;
  BackgroundTwin twin({"serve", std::string{SENSOTWIN_SOURCE_DIR} + "/scenes/hallway.yaml", "--no-cards",
                       "--llrp", "127.0.0.1:0", "--rtf", "200", "--out", (folder / "served").string()});
  ASSERT_TRUE(twin.wait_for(folder / "served/devices.yaml"));
  const std::string devices = content_of(folder / "served/devices.yaml");
  const std::size_t begin = devices.find("llrp: \"") + 7;
  const auto at = endpoint_from(devices.substr(begin, devices.find('"', begin) - begin));
  ASSERT_TRUE(at);

  const PortClient base(folder / "served/base");
  base.say({128, 132, 148, 1, 100, 145, 0, 50, 0, 100});  // round in circles
  const PortClient sensors(folder / "served/sensors");
  const TcpClient reader(*at);
  robot::llrp::SetReaderConfig config;
  config.keepalive =
      robot::llrp::KeepaliveSpec{.trigger = robot::llrp::KeepaliveTrigger::kPeriodic, .period_ms = 1000};
  reader.say(robot::llrp::encode(robot::llrp::ImpinjEnableExtensions{}, 4));
  reader.say(robot::llrp::encode(config, 1));
  reader.say(robot::llrp::encode(robot::llrp::AddRoSpec{every_read()}, 2));
  reader.say(robot::llrp::encode(robot::llrp::EnableRoSpec{7}, 3));

  const auto wait_s = [](int seconds) { ::poll(nullptr, 0, 1000 * seconds); };
  wait_s(3);  // ten minutes of its time: the kernel's buffers are full, and so are its own
  const long early_kb = resident_kb(twin.process());
  wait_s(15);
  const long late_kb = resident_kb(twin.process());
  EXPECT_GT(early_kb, 0);
  EXPECT_LT(late_kb - early_kb, 1024) << early_kb << " kB, then " << late_kb << " kB";
  EXPECT_EQ(twin.stop(SIGINT).code, 130);
  const std::string report = content_of(folder / "served/serve.json");
  EXPECT_THAT(report, ::testing::Not(::testing::HasSubstr("\"reports_lost\": 0"))) << report;
}

}  // namespace
}  // namespace sensotwin::twin
