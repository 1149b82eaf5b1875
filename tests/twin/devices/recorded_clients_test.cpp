// SPDX-License-Identifier: MIT
// What real clients sent (recorded beside the repository, ../shared/vectors/oi), said to the emulated
// mainboard.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "robot/wire/oi_commands.hpp"
#include "robot/wire/oi_stream.hpp"
#include "tests/twin/devices/roomba_bench.hpp"
#include "twin/devices/emulated_roomba.hpp"

namespace sensotwin::twin {
namespace {

using robot::Bytes;
using robot::oi::Mode;
using ::testing::SizeIs;

const std::filesystem::path kVectors = std::filesystem::path{SENSOTWIN_SOURCE_DIR} / "../shared/vectors/oi";

class RecordedClientOnTheBoard : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kVectors)) {
      GTEST_SKIP() << "no recorded vectors at " << kVectors;
    }
  }
  /// One command each tick. \returns what the board said after each
  [[nodiscard]] std::vector<Bytes> replay(const std::string& client, EmulatedRoomba& board,
                                          const robot::oi::OpcodeTable& table) {
    std::ifstream file{kVectors / (client + ".to_robot.bin"), std::ios::binary};
    const Bytes sent{std::istreambuf_iterator<char>{file}, {}};
    EXPECT_FALSE(sent.empty());
    std::vector<Bytes> heard;
    robot::oi::CommandDecoder decoder{table};
    for (const std::uint8_t byte : sent) {
      board.receive({&byte, 1});
      if (decoder.push(byte)) {
        outputs_.push_back(board.tick(in_));
        heard.push_back(hear(board));
      }
    }
    return heard;
  }
  world::RoombaInputs in_ = at_rest();
  std::vector<world::RoombaOutputs> outputs_;  ///< after each command
};

TEST_F(RecordedClientOnTheBoard, LibcreateGetsFramesOf72BytesFromItsSecondCommandOn) {
  EmulatedRoomba board{{.speed_step_mps = 0.0}};
  const std::vector<Bytes> heard = replay("libcreate_create2", board, robot::oi::kOpenInterface);
  ASSERT_THAT(heard, SizeIs(20));
  for (std::size_t i = 1; i + 1 < heard.size(); ++i) {
    ASSERT_THAT(heard[i], SizeIs(75)) << "command " << i;
    EXPECT_EQ(heard[i][1], 72);
  }
  EXPECT_DOUBLE_EQ(outputs_[6].wheel_left_mps, 0.5);  // 145 1 244 1 244
  EXPECT_EQ(board.mode(), Mode::kOff);
}

TEST_F(RecordedClientOnTheBoard, Pycreate2Gets80BytesForEachOfItsQuestions) {
  EmulatedRoomba board{{.speed_step_mps = 0.0}};
  int answers = 0;
  for (const Bytes& bytes : replay("pycreate2", board, robot::oi::kOpenInterface)) {
    EXPECT_TRUE(bytes.empty() || bytes.size() == 80u) << bytes.size();
    answers += bytes.empty() ? 0 : 1;
  }
  EXPECT_EQ(answers, 3);
  EXPECT_EQ(board.mode(), Mode::kOff);
}

TEST_F(RecordedClientOnTheBoard, PyRoombaAdapterMovesAnArcWhereItMeansStraight) {
  // It clamps radius 32768 to 2000; an honest robot turns left: the left wheel is the slower one.
  EmulatedRoomba board{{.speed_step_mps = 0.0}};
  const std::vector<Bytes> heard = replay("pyroombaadapter", board, robot::oi::kOpenInterface);
  EXPECT_EQ(heard[2], Bytes{2});
  EXPECT_NEAR(outputs_[6].wheel_left_mps, 0.2 * (1.0 - 0.1175 / 2.0), 1e-9);  // 137 0 200 7 208
  EXPECT_NEAR(outputs_[6].wheel_right_mps, 0.2 * (1.0 + 0.1175 / 2.0), 1e-9);
}

TEST_F(RecordedClientOnTheBoard, PlayerGets26BytesForEachPoll) {
  EmulatedRoomba board{{.body = {.kind = world::RoombaKind::kRoomba400, .wheel_base_m = 0.258}}};
  for (const Bytes& bytes : replay("player_roomba_sci", board, robot::oi::kSerialCommandInterface)) {
    EXPECT_TRUE(bytes.empty() || bytes.size() == 26u) << bytes.size();
  }
  EXPECT_EQ(board.mode(), Mode::kPassive);  // its last command but one is Dock
}

/// One line of a recorded session.
struct SessionLine {
  char kind{' '};  ///< '>' client to robot, '<' robot to client, '-' of the line itself
  Bytes bytes;
};

/// `seconds > name decimals` and `seconds < name hex`.
[[nodiscard]] std::vector<SessionLine> lines_of(const std::filesystem::path& session) {
  std::ifstream file{session};
  std::vector<SessionLine> lines;
  for (std::string text; std::getline(file, text);) {
    std::istringstream words{text};
    std::string seconds;
    SessionLine line;
    if (text.starts_with('#') || !(words >> seconds >> line.kind)) {
      continue;
    }
    std::string last;
    for (std::string word; words >> word; last = word) {
      if (line.kind == '>' && std::isdigit(static_cast<unsigned char>(word[0])) != 0) {
        line.bytes.push_back(static_cast<std::uint8_t>(std::stoi(word)));
      }
    }
    for (std::size_t i = 0; line.kind == '<' && i + 1 < last.size(); i += 2) {
      line.bytes.push_back(static_cast<std::uint8_t>(std::stoi(last.substr(i, 2), nullptr, 16)));
    }
    lines.push_back(line);
  }
  return lines;
}

class RecordedSession : public RecordedClientOnTheBoard, public ::testing::WithParamInterface<const char*> {};

TEST_P(RecordedSession, GetsAnswersAsLongAsTheRecordedOnesAndInTime) {
  EmulatedRoombaConfig config;
  if (std::string{GetParam()}.ends_with("_sci")) {
    config.body.kind = world::RoombaKind::kRoomba400;
  }
  EmulatedRoomba board{config};
  const std::vector<SessionLine> lines = lines_of(kVectors / (std::string{GetParam()} + ".session.txt"));
  ASSERT_FALSE(lines.empty());
  // Nobody waits longer than libcreate: 500 ms (protocols study, 1.8).
  constexpr int kPatienceTicks = 33;
  int answers = 0;
  for (const SessionLine& line : lines) {
    if (line.kind == '>') {
      board.receive(line.bytes);
    } else if (line.kind == '<') {
      Bytes heard;
      for (int i = 0; i < kPatienceTicks && heard.size() < line.bytes.size(); ++i) {
        board.tick(in_);
        const Bytes more = hear(board);
        heard.insert(heard.end(), more.begin(), more.end());
      }
      ASSERT_EQ(heard.size(), line.bytes.size()) << "answer " << answers;
      const bool frame = line.bytes[0] == robot::oi::kStreamHeader && line.bytes.size() > 26;
      EXPECT_TRUE(!frame || (heard[0] == line.bytes[0] && heard[1] == line.bytes[1])) << "answer " << answers;
      ++answers;
    }
  }
  EXPECT_GT(answers, 0);
}

INSTANTIATE_TEST_SUITE_P(AllClients, RecordedSession,
                         ::testing::Values("breezycreate2", "libcreate_create1_500", "libcreate_create2",
                                           "libcreate_roomba400_sci", "player_roomba_sci", "pycreate2",
                                           "pyroombaadapter"),
                         [](const auto& client) { return std::string{client.param}; });

}  // namespace
}  // namespace sensotwin::twin
