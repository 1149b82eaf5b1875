// SPDX-License-Identifier: MIT
// Clients that nobody here wrote. Each test is skipped, with the reason, where its client is not installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "llrp_session.hpp"
#include "serve_bench.hpp"
#include "tests/robot/output/temporary_folder.hpp"
#include "twin_process.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path kSource = SENSOTWIN_SOURCE_DIR;
const std::string kHallway = (kSource / "scenes/hallway.yaml").string();

/// Runs a line in a shell. What it prints on stdout is left in `folder`.
int shell(const TemporaryFolder& folder, const std::string& line) {
  const int status = std::system(  // NOLINT(cert-env33-c): a shell is what users have
      ("{ " + line + "; } >'" + (folder / "printed").string() + "' 2>'" + (folder / "said").string() + "'")
          .c_str());
  return WEXITSTATUS(status);
}

/// Two ports in a row that were free a moment ago.
std::uint16_t two_free_ports() {
  for (int i = 0; i < 100; ++i) {
    Endpoint first;
    const Handle one = listen_at(first);
    Endpoint second{.port = static_cast<std::uint16_t>(first.port + 1)};
    try {
      const Handle two = listen_at(second);
      return first.port;
    } catch (const std::runtime_error&) {
      continue;
    }
  }
  return 0;
}

/// A hallway whose reader anybody may dial.
class ServedHallway : public ::testing::Test {
 protected:
  ServedHallway() {
    EXPECT_TRUE(twin_.wait_for(folder_ / "served/devices.yaml"));
    const std::string devices = content_of(folder_ / "served/devices.yaml");
    const std::size_t begin = devices.find("llrp: \"") + 7;
    at_ = *endpoint_from(devices.substr(begin, devices.find('"', begin) - begin));
  }
  TemporaryFolder folder_;
  BackgroundTwin twin_{
      {"serve", kHallway, "--no-cards", "--llrp", "127.0.0.1:0", "--out", (folder_ / "served").string()}};
  Endpoint at_;
};

TEST(ForeignClients, PcscScanAndOpenscToolSeeTheTagUnderTheRobotComeAndGo) {
  const TemporaryFolder folder;
  const std::string line = (kSource / "tests/twin/serve/pcsc_session").string() + " '" + TWIN_PROGRAM +
                           "' '" + (kSource / "scenes/house.yaml").string() + "' '" +
                           (folder / "out").string() + "' " + std::to_string(two_free_ports());
  const int code = shell(folder, line);
  if (code == 77) {
    GTEST_SKIP() << content_of(folder / "printed")
                 << "apt-get install vsmartcard-vpcd pcscd pcsc-tools opensc";
  }
  ASSERT_EQ(code, 0) << content_of(folder / "said");
  EXPECT_THAT(content_of(folder / "out/devices.yaml"),
              HasSubstr("  - \"Virtual PCD 00 00\"\n  - \"Virtual PCD 00 01\"\n"));
  const std::string readers = content_of(folder / "out/readers");
  EXPECT_THAT(readers, HasSubstr("Yes             Virtual PCD 00 00"));
  EXPECT_THAT(readers, HasSubstr("No              Virtual PCD 00 01"));
  const std::string card = content_of(folder / "out/card");
  EXPECT_THAT(card, HasSubstr("E0 04 01")) << "the UID of an ICODE SLI";
  EXPECT_THAT(card, HasSubstr("\n01 02 03 04 ")) << "what was written is read";
  const std::string scan = content_of(folder / "out/scan");
  EXPECT_THAT(scan, HasSubstr("3B 8F 80 01 80 4F 0C A0 00 00 03 06 0B 00 14 00 00 00 00 77"));
  const std::size_t removed = scan.find("Event number: 2");
  ASSERT_NE(removed, std::string::npos) << scan;
  EXPECT_NE(scan.find("Card inserted", removed), std::string::npos) << "the next tile's tag\n" << scan;
}

TEST_F(ServedHallway, LetsLlrpjsTakeInventory) {
  const std::string client = (kSource / "tests/twin/serve/llrpjs").string();
  if (shell(folder_, "'" + client + "/install' '" + NPM_FOLDER + "'") != 0) {
    GTEST_SKIP() << "llrpjs is not to be had: " << content_of(folder_ / "said");
  }
  const int code = shell(folder_, std::string{"NODE_PATH='"} + NPM_FOLDER + "/node_modules' node '" + client +
                                      "/inventory.js' " + at_.host + " " + std::to_string(at_.port));
  EXPECT_EQ(code, 0) << content_of(folder_ / "said");
  EXPECT_THAT(content_of(folder_ / "printed"), HasSubstr("300000000000000000000001\n"));
}

TEST_F(ServedHallway, SaysNothingThatTsharkCallsMalformed) {
  if (shell(folder_, "command -v tshark") != 0) {
    GTEST_SKIP() << "tshark is not here: apt-get install tshark";
  }
  LlrpSession session(at_);
  session.take_inventory_and_close();
  ASSERT_TRUE(session.is_over());
  ASSERT_GT(session.reports(), 20);
  write_capture(folder_ / "session.pcap", session.frames());
  const std::string tshark = "tshark -r '" + (folder_ / "session.pcap").string() + "' ";
  ASSERT_EQ(shell(folder_, tshark + "-Y llrp -T fields -e llrp.type | wc -l"), 0)
      << content_of(folder_ / "said");
  EXPECT_EQ(std::stoul(content_of(folder_ / "printed")), session.frames().size());
  // Of a correct Identification tshark 4.0 says that it is malformed (protocols study, 2.9).
  ASSERT_EQ(shell(folder_, tshark + "-Y '(_ws.malformed || _ws.expert) && !(llrp.type == 12)' -T fields "
                                    "-e frame.number -e llrp.type"),
            0);
  EXPECT_EQ(content_of(folder_ / "printed"), "");
}

}  // namespace
}  // namespace sensotwin::twin
