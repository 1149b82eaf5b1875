// SPDX-License-Identifier: MIT
// All wires of a scene at once, ticked as fast as the machine allows.
#include "twin/serve/served_wires.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "llrp_session.hpp"
#include "serve_bench.hpp"
#include "tests/robot/output/temporary_folder.hpp"
#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {
namespace {

namespace llrp = robot::llrp;

class ServedHallwayInProcess : public ::testing::Test {
 protected:
  void tick() {
    twin_.tick();
    wall_s_ += 0.015;
    wires_.pump(wall_s_);
  }
  [[nodiscard]] const Wire& wire(const std::string& name) const {
    return **std::ranges::find(wires_.all(), name, [](const auto& each) { return each->name(); });
  }
  /// Ticks until a sentence has come, two seconds of the twin's time at most.
  [[nodiscard]] std::string sentence_at(const PortClient& client) {
    std::string all;
    EXPECT_TRUE(eventually([&] { return all.find("\r\n$HCHDM,") != std::string::npos; },
                           [&] {
                             tick();
                             const robot::Bytes more = client.hear();
                             all.append(more.begin(), more.end());
                           }));
    return all;
  }

  TemporaryFolder folder_;
  ServedTwin twin_{read_scene(std::filesystem::path{SENSOTWIN_SOURCE_DIR} / "scenes/hallway.yaml")};
  ServedWires wires_{twin_,
                     {.strict_baud = false, .llrp = Endpoint{}, .vpcd = std::nullopt},
                     folder_ / "",
                     [](std::string_view) {}};
  double wall_s_{0.0};
};

TEST_F(ServedHallwayInProcess, SpeaksItsHeadingOnAfterTenMegabytesOfRandomBytesAtTheSensorsPort) {
  const PortClient client(folder_ / "sensors");
  const robot::Bytes bytes = noise(10'000'000);
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const std::size_t chunk = std::min<std::size_t>(bytes.size() - sent, 4096);
    sent += client.say({bytes.begin() + static_cast<std::ptrdiff_t>(sent),
                        bytes.begin() + static_cast<std::ptrdiff_t>(sent + chunk)});
    wall_s_ += 0.015;
    wires_.pump(wall_s_);
  }
  EXPECT_EQ(sentence_at(client).front(), '$');
  EXPECT_GT(wire("sensors").tally().bytes_in, 9'000'000u);
}

TEST_F(ServedHallwayInProcess, LosesSentencesAndNothingElseForAClientThatNeverReadsItsSensors) {
  const PortClient client(folder_ / "sensors");
  for (int i = 0; i < 20'000; ++i) {
    tick();
  }
  EXPECT_GT(wire("sensors").tally().bytes_dropped, 10'000u) << "what a terminal does not hold";
  EXPECT_LT(client.hear().size(), 100'000u);
  EXPECT_THAT(sentence_at(client), ::testing::HasSubstr("$HCHDM,")) << "and a late reader hears the newest";
}

// The same over processes, by the resident memory that users see: serve_long_test.cpp.
TEST_F(ServedHallwayInProcess, HoldsNoMoreMemoryAfterAnHourThanAfterTenMinutesBesideClientsThatNeverRead) {
  const PortClient base(folder_ / "base");
  base.say({128, 132, 148, 1, 100, 145, 0, 50, 0, 100});  // round in circles
  const PortClient sensors(folder_ / "sensors");
  const TcpClient reader(*endpoint_from(*wires_.devices()->llrp));
  llrp::SetReaderConfig config;
  config.keepalive = llrp::KeepaliveSpec{.trigger = llrp::KeepaliveTrigger::kPeriodic, .period_ms = 1000};
  reader.say(llrp::encode(llrp::ImpinjEnableExtensions{}, 4));
  reader.say(llrp::encode(config, 1));
  reader.say(llrp::encode(llrp::AddRoSpec{every_read()}, 2));
  reader.say(llrp::encode(llrp::EnableRoSpec{7}, 3));
  ASSERT_TRUE(eventually([&] { return !twin_.uhf_reader()->antennas().empty(); }, [&] { tick(); }));
  const auto heap_after = [&](double minutes) {
    while (robot::to_s(twin_.now()) < 60.0 * minutes) {
      tick();
    }
    return mallinfo2().uordblks;
  };
  const std::size_t early = heap_after(10.0);
  const std::size_t late = heap_after(60.0);
  EXPECT_LT(late, early + 100'000) << early << " bytes after ten minutes, " << late << " after sixty";
  EXPECT_GT(wire("llrp").tally().reports_lost, 0u);
  EXPECT_GT(wire("base").tally().bytes_dropped, 1'000'000u);
}

}  // namespace
}  // namespace sensotwin::twin
