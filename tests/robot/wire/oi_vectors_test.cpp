// SPDX-License-Identifier: MIT
// Bytes that real clients sent (recorded beside the repository, ../shared/vectors/oi).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "robot/wire/oi_commands.hpp"

namespace sensotwin::robot::oi {
namespace {

const std::filesystem::path kVectors = std::filesystem::path{SENSOTWIN_SOURCE_DIR} / "../shared/vectors/oi";

struct Replay {
  Bytes sent;
  Bytes encoded_again;
  std::map<Opcode, int> commands;
  int unknown{0};
  int out_of_range{0};
};

[[nodiscard]] Replay replay(const std::string& client, const OpcodeTable& table) {
  std::ifstream file{kVectors / (client + ".to_robot.bin"), std::ios::binary};
  Replay out;
  out.sent.assign(std::istreambuf_iterator<char>{file}, {});
  CommandDecoder decoder{table};
  for (const std::uint8_t byte : out.sent) {
    const auto result = decoder.push(byte);
    if (!result) {
      continue;
    }
    if (!*result) {
      ++out.unknown;
      continue;
    }
    ++out.commands[opcode_of(**result)];
    out.out_of_range += in_range(**result) ? 0 : 1;
    const Bytes bytes = encode(**result);
    out.encoded_again.insert(out.encoded_again.end(), bytes.begin(), bytes.end());
  }
  return out;
}

class RecordedClient : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kVectors)) {
      GTEST_SKIP() << "no recorded vectors at " << kVectors;
    }
  }
  static void expect_all_understood(const Replay& replay) {
    EXPECT_FALSE(replay.sent.empty());
    EXPECT_EQ(replay.unknown, 0);
    EXPECT_EQ(replay.encoded_again, replay.sent);
  }
};

TEST_F(RecordedClient, LibcreateIsUnderstoodAndEncodedAgainByteForByte) {
  const Replay r = replay("libcreate_create2", kOpenInterface);
  expect_all_understood(r);
  EXPECT_EQ(r.out_of_range, 0);
  EXPECT_EQ(r.commands.at(Opcode::kStart), 3);
  EXPECT_EQ(r.commands.at(Opcode::kStream), 1);
  EXPECT_EQ(r.commands.at(Opcode::kDriveDirect), 5);
  EXPECT_EQ(r.commands.at(Opcode::kStop), 1);
}

TEST_F(RecordedClient, LibcreateForCreate1IsUnderstoodAndEncodedAgainByteForByte) {
  expect_all_understood(replay("libcreate_create1_500", kOpenInterface));
}

TEST_F(RecordedClient, Pycreate2IsUnderstoodAndEncodedAgainByteForByte) {
  const Replay r = replay("pycreate2", kOpenInterface);
  expect_all_understood(r);
  EXPECT_GE(r.commands.at(Opcode::kSong), 12);
}

TEST_F(RecordedClient, PyRoombaAdapterIsUnderstoodAndEncodedAgainByteForByte) {
  const Replay r = replay("pyroombaadapter", kOpenInterface);
  expect_all_understood(r);
  EXPECT_EQ(r.commands.at(Opcode::kStream), 2);
}

TEST_F(RecordedClient, BreezyCreate2IsUnderstoodAndEncodedAgainByteForByte) {
  const Replay r = replay("breezycreate2", kOpenInterface);
  expect_all_understood(r);
  EXPECT_EQ(r.commands.at(Opcode::kSensors), 3);
}

TEST_F(RecordedClient, PlayerIsUnderstoodAndEncodedAgainByteForByte) {
  expect_all_understood(replay("player_roomba_sci", kSerialCommandInterface));
}

TEST_F(RecordedClient, LibcreateForRoomba400IsUnderstoodAndEncodedAgainByteForByte) {
  const Replay r = replay("libcreate_roomba400_sci", kSerialCommandInterface);
  EXPECT_EQ(r.unknown, 0);
  EXPECT_GT(r.commands.at(Opcode::kSensors), 1000);
  // The recording is cut after 20 000 bytes, in mid-command at worst.
  ASSERT_GE(r.encoded_again.size(), r.sent.size() - 5);
  EXPECT_TRUE(std::equal(r.encoded_again.begin(), r.encoded_again.end(), r.sent.begin()));
}

}  // namespace
}  // namespace sensotwin::robot::oi
