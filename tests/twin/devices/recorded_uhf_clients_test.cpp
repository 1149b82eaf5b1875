// SPDX-License-Identifier: MIT
// What real LLRP clients sent, said to the emulated reader (recorded beside the repository,
// ../shared/vectors).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/twin/devices/uhf_bench.hpp"

namespace sensotwin::twin {
namespace {

namespace fs = std::filesystem;
namespace llrp = robot::llrp;

const fs::path kVectors = fs::path{SENSOTWIN_SOURCE_DIR} / "../shared/vectors";

[[nodiscard]] robot::Bytes bytes_of(const fs::path& path) {
  std::ifstream file{path, std::ios::binary};
  return robot::Bytes(std::istreambuf_iterator<char>{file}, {});
}

[[nodiscard]] UhfReaderSettings fifty_channels() {
  UhfReaderSettings settings;
  settings.channels_hz.assign(50, 915.25e6);
  return settings;
}

class RecordedUhfClients : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kVectors / "llrp_malformed")) {
      GTEST_SKIP() << "no recorded vectors at " << kVectors;
    }
  }

  /// Says every request of a folder whose name begins so, in order: all sessions on one connection. None may
  /// be refused.
  static void expect_all_accepted(const std::string& folder, const std::string& prefix, int at_least) {
    std::vector<fs::path> requests;
    for (const auto& entry : fs::directory_iterator{kVectors / folder}) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(prefix) && name.ends_with(".bin") && name.find("_c2r_") != std::string::npos) {
        requests.push_back(entry.path());
      }
    }
    std::ranges::sort(requests);
    EXPECT_GE(static_cast<int>(requests.size()), at_least);
    UhfBench bench{fifty_channels()};
    for (const fs::path& path : requests) {
      if (!bench.reader.is_connected()) {
        EXPECT_TRUE(bench.reader.connect());
      }
      const std::string name = path.filename().string();
      bench.reader.receive(bytes_of(path));
      for (const FromReader& answer : bench.messages()) {
        std::visit(
            [&](const auto& message) {
              if constexpr (requires { message.status; }) {
                EXPECT_TRUE(message.status.ok())
                    << name << ": " << static_cast<int>(message.status.code) << " "
                    << (message.status.parameter_error ? message.status.parameter_error->parameter : 0);
              }
            },
            answer.message);
      }
    }
  }
};

TEST_F(RecordedUhfClients, SllurpTakesInventoryWithoutARefusal) {
  expect_all_accepted("sllurp", "inventory", 30);
}
TEST_F(RecordedUhfClients, SllurpAddsAccessSpecsWithoutARefusal) {
  expect_all_accepted("sllurp", "access", 15);
}
TEST_F(RecordedUhfClients, LlrpjsTakesInventoryWithoutARefusal) {
  expect_all_accepted("llrpjs", "inventory", 7);
}

/// pyllrp matches answers by their type and takes some refusals for granted: what it was told is the
/// standard.
TEST_F(RecordedUhfClients, PyllrpGetsAnswersOfTheRecordedKindAndOutcome) {
  std::ifstream file{kVectors / "pyllrp/session_index.json"};
  UhfBench bench{fifty_channels()};
  int compared = 0;
  std::vector<FromReader> answers;
  for (const auto& entry : nlohmann::json::parse(file)) {
    if (!entry.contains("file")) {
      continue;
    }
    const std::string name = entry["file"];
    const robot::Bytes bytes = bytes_of(kVectors / "pyllrp" / name);
    const int type = robot::u16_from_be(bytes[0], bytes[1]) & 0x3FF;
    if (name.find("_c2r_") != std::string::npos) {
      if (!bench.reader.is_connected()) {
        ASSERT_TRUE(bench.reader.connect());
        static_cast<void>(bench.sent());
      }
      bench.reader.receive(bytes);
      answers = bench.messages();
    } else if (name.find("_RESPONSE") != std::string::npos) {
      const auto same = std::ranges::find_if(answers, [&](const auto& a) { return a.header.type == type; });
      ASSERT_NE(same, answers.end()) << name;
      const int recorded_code =
          robot::u16_from_be(bytes[type == 1023 ? 19 : 14], bytes[type == 1023 ? 20 : 15]);
      std::visit(
          [&](const auto& message) {
            if constexpr (requires { message.status; }) {
              EXPECT_EQ(message.status.ok(), recorded_code == 0) << name;
            }
          },
          same->message);
      ++compared;
    }
  }
  EXPECT_GE(compared, 10);
}

TEST_F(RecordedUhfClients, MalformedRequestsAreAnsweredAsTheyHaveToBe) {
  std::ifstream file{kVectors / "llrp_malformed/index.json"};
  const auto index = nlohmann::json::parse(file);
  EXPECT_EQ(index.size(), 60u);
  UhfBench bench{fifty_channels()};
  ASSERT_TRUE(bench.reader.connect());
  static_cast<void>(bench.sent());
  for (const auto& entry : index) {
    const std::string name = entry["file"];
    bench.reader.receive(bytes_of(kVectors / "llrp_malformed" / name));
    const robot::Bytes raw = bench.sent();
    EXPECT_TRUE(bench.reader.is_connected()) << name;
    if (!entry.contains("reply_type")) {
      EXPECT_TRUE(raw.empty()) << name;
      continue;
    }
    ASSERT_GE(raw.size(), 10u) << name;
    EXPECT_EQ(robot::u16_from_be(raw[0], raw[1]) & 0x3FF, entry["reply_type"].get<int>()) << name;
    EXPECT_EQ((raw[0] >> 2) & 7, entry["reply_version"].get<int>()) << name;
    // Every reply begins with its status, but Impinj's, which tells vendor and subtype first.
    const std::size_t at = entry["reply_type"] == 1023 ? 15 : 10;
    ASSERT_GE(raw.size(), at + 6) << name;
    const int code = robot::u16_from_be(raw[at + 4], raw[at + 5]);
    const auto& expected = entry["expect"];
    if (expected.is_number()) {
      EXPECT_EQ(code, expected.get<int>()) << name;
    } else if (expected == "success") {
      EXPECT_EQ(code, 0) << name;
    } else if (expected == "error status") {
      EXPECT_NE(code, 0) << name;
    }
  }
}

TEST_F(RecordedUhfClients, CapabilitiesAndConfigurationAreThoseOfARealSpeedwayButForWhatItsOwnersSet) {
  const auto decoded = [](const char* file, std::uint16_t type) {
    const robot::Bytes body = bytes_of(kVectors / "edgex" / file);
    return *llrp::decode({{llrp::kVersion, type, 1}, body});
  };
  const auto real =
      std::get<llrp::GetReaderCapabilitiesResponse>(decoded("GetReaderCapabilitiesResponse-000.bytes", 11));
  UhfReaderSettings settings;
  settings.channels_hz.clear();
  for (const std::uint32_t khz : real.regulatory->uhf->frequencies.hop_tables[0].frequencies_khz) {
    settings.channels_hz.push_back(khz * 1e3);
  }
  EXPECT_EQ(uhf_capabilities(settings), real);

  auto config = std::get<llrp::GetReaderConfigResponse>(decoded("GetReaderConfigResponse-000.bytes", 12));
  for (llrp::AntennaProperties& antenna : config.antenna_properties) {
    antenna.connected = true;  // the recorded reader had one antenna
  }
  config.state->value = 0;
  EXPECT_EQ(uhf_factory_configuration(settings), config);
}

}  // namespace
}  // namespace sensotwin::twin
