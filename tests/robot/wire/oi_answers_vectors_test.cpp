// SPDX-License-Identifier: MIT
// What the manual prints as examples, and what was said to recorded clients (beside the repository,
// ../shared/vectors/oi).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "robot/wire/oi_commands.hpp"
#include "robot/wire/oi_packets.hpp"
#include "robot/wire/oi_stream.hpp"
#include "robot/wire/oi_stream_layout.hpp"
#include "robot/wire/sci.hpp"

namespace sensotwin::robot::oi {
namespace {

namespace fs = std::filesystem;

const fs::path kVectors = fs::path{SENSOTWIN_SOURCE_DIR} / "../shared/vectors/oi";

class RecordedAnswers : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kVectors)) {
      GTEST_SKIP() << "no recorded vectors at " << kVectors;
    }
  }
};

class ManualsExamples : public RecordedAnswers {
 protected:
  void SetUp() override {
    RecordedAnswers::SetUp();
    if (!IsSkipped()) {
      std::ifstream file{kVectors / "spec_examples.json"};
      examples_ = nlohmann::json::parse(file);
    }
  }
  nlohmann::json examples_;
};

TEST_F(ManualsExamples, OfCommandsAreInRangeAndEncodedAgainByteForByte) {
  ASSERT_EQ(examples_["commands"].size(), 7u);
  for (const auto& example : examples_["commands"]) {
    const Bytes bytes = example["bytes"];
    CommandDecoder decoder;
    std::optional<Command> command;
    for (const std::uint8_t byte : bytes) {
      ASSERT_FALSE(command) << example;
      if (const auto outcome = decoder.push(byte)) {
        ASSERT_TRUE(*outcome) << example;
        command = **outcome;
      }
    }
    ASSERT_TRUE(command) << example;
    EXPECT_TRUE(in_range(*command)) << example;
    EXPECT_EQ(encode(*command), bytes) << example;
  }
}

TEST_F(ManualsExamples, OfAStreamFrameIsDecodedAndEncodedAgainByteForByte) {
  const Bytes bytes = examples_["stream_example"]["bytes"];
  StreamDecoder decoder;
  std::ranges::copy(bytes, decoder.room().begin());
  decoder.received(bytes.size());
  const auto payload = decoder.next();
  ASSERT_TRUE(payload && *payload);
  SensorValues values;
  ASSERT_TRUE(decode_payload(**payload, values));
  // Erratum: the manual's prose says 549 (0x0225); the decimal bytes 2 25 are 537.
  EXPECT_EQ(values[PacketId::kCliffFrontLeftSignal], 537);
  std::array<std::uint8_t, 16> again{};
  const auto size = encode_frame(Bytes{29, 13}, values, again);
  ASSERT_TRUE(size);
  EXPECT_EQ(Bytes(again.begin(), again.begin() + static_cast<std::ptrdiff_t>(*size)), bytes);
}

TEST_F(ManualsExamples, OfGroupsAndSizesAreThoseOfTheTables) {
  for (const auto& [id, size] : examples_["group_sizes"].items()) {
    EXPECT_EQ(packet_run(static_cast<std::uint8_t>(std::stoi(id))).size, size.get<int>()) << id;
  }
  for (const auto& [id, range] : examples_["group_contents"].items()) {
    const PacketRun& run = packet_run(static_cast<std::uint8_t>(std::stoi(id)));
    EXPECT_EQ(std::to_string(run.first) + "-" + std::to_string(run.last), range.get<std::string>()) << id;
  }
  const std::vector<int> two_bytes = examples_["two_byte_packets"];
  const std::vector<int> is_signed = examples_["signed_packets"];
  for (int id = kFirstPacket; id <= kLastPacket; ++id) {
    const PacketInfo& info = packet_info(static_cast<std::uint8_t>(id));
    EXPECT_EQ(info.size == 2, std::ranges::count(two_bytes, id) == 1) << id;
    EXPECT_EQ(info.is_signed, std::ranges::count(is_signed, id) == 1) << id;
  }
}

struct Answer {
  std::string client;
  std::optional<std::uint8_t> packet;  ///< none: a frame of a stream
  Bytes bytes;
};

/// `seconds < sensors ID hex` and `seconds < stream hex` of every session.
[[nodiscard]] std::vector<Answer> all_answers() {
  std::vector<Answer> answers;
  for (const auto& entry : fs::directory_iterator{kVectors}) {
    std::ifstream file{entry.path()};
    for (std::string text; entry.path().extension() == ".txt" && std::getline(file, text);) {
      std::istringstream words{text};
      std::string seconds;
      std::string direction;
      std::string what;
      std::string hex;
      words >> seconds >> direction >> what;
      if (text.starts_with('#') || direction != "<") {
        continue;
      }
      Answer answer{entry.path().stem().stem().string(), std::nullopt, {}};
      if (what == "sensors") {
        int id = 0;
        words >> id;
        answer.packet = static_cast<std::uint8_t>(id);
      }
      words >> hex;
      for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
        answer.bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
      }
      answers.push_back(std::move(answer));
    }
  }
  return answers;
}

/// The ids of a frame that decode_payload() understood.
[[nodiscard]] Bytes ids_of(ByteView payload) {
  Bytes ids;
  while (!payload.empty()) {
    ids.push_back(payload.front());
    payload = payload.subspan(1u + packet_run(payload.front()).size);
  }
  return ids;
}

TEST_F(RecordedAnswers, ToSingleRequestsAreUnderstoodAndEncodedAgainByteForByte) {
  int seen = 0;
  for (const Answer& answer : all_answers()) {
    if (!answer.packet) {
      continue;
    }
    ++seen;
    const bool sci = answer.client.ends_with("_sci");
    SensorValues values;
    const auto size = sci ? sci::decode_sensors(*answer.packet, answer.bytes, values)
                          : decode_packet(*answer.packet, answer.bytes, values);
    ASSERT_TRUE(size) << answer.client << " " << int{*answer.packet};
    EXPECT_EQ(*size, answer.bytes.size()) << answer.client;
    Bytes again(answer.bytes.size());
    ASSERT_TRUE(sci ? sci::encode_sensors(*answer.packet, values, again)
                    : encode_packet(*answer.packet, values, again));
    EXPECT_EQ(again, answer.bytes) << answer.client;
  }
  EXPECT_EQ(seen, 41);
}

TEST_F(RecordedAnswers, InStreamsAreUnderstoodAndEncodedAgainByteForByte) {
  int seen = 0;
  for (const Answer& answer : all_answers()) {
    if (answer.packet) {
      continue;
    }
    ++seen;
    StreamDecoder decoder;
    std::ranges::copy(answer.bytes, decoder.room().begin());
    decoder.received(answer.bytes.size());
    const auto payload = decoder.next();
    ASSERT_TRUE(payload && *payload) << answer.client;
    const Bytes held((*payload)->begin(), (*payload)->end());
    SensorValues values;
    ASSERT_TRUE(decode_payload(held, values)) << answer.client;
    const auto layout = StreamLayout::of(ids_of(held));
    ASSERT_TRUE(layout) << answer.client;
    Bytes again(answer.bytes.size());
    EXPECT_EQ(layout->encode(values, again), answer.bytes.size());
    EXPECT_EQ(again, answer.bytes) << answer.client;
  }
  EXPECT_EQ(seen, 9);
}

}  // namespace
}  // namespace sensotwin::robot::oi
