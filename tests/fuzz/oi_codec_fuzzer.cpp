// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <vector>

#include "robot/drivers/roomba.hpp"
#include "robot/wire/oi_commands.hpp"
#include "robot/wire/oi_opcodes.hpp"
#include "robot/wire/oi_stream.hpp"
#include "robot/wire/oi_stream_layout.hpp"
#include "robot/wire/sci.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/oi_parts.hpp"

namespace sensotwin::fuzz {

namespace oi = robot::oi;
using robot::Bytes;
using robot::ByteView;

/// A command is encoded to the very bytes that it was decoded from; moved into its ranges, it stays there.
void oi_commands(ByteView input, const oi::OpcodeTable& table) {
  oi::CommandDecoder decoder{table};
  std::size_t begin = 0;
  for (std::size_t i = 0; i < input.size(); ++i) {
    const auto outcome = decoder.push(input[i]);
    if (!outcome) {
      continue;
    }
    const ByteView consumed = input.subspan(begin, i + 1 - begin);
    begin = i + 1;
    require(!decoder.waiting(), "a command that is complete awaits nothing");
    if (!*outcome) {
      require(outcome->error() == oi::CommandError::kSongTooLong || consumed.size() == 1,
              "a byte that begins no command is skipped alone");
      continue;
    }
    require(std::ranges::equal(oi::encode(**outcome), consumed), "a command is encoded as it came");
    const oi::Command clamped = oi::clamped(**outcome);
    require(oi::in_range(clamped) && oi::clamped(clamped) == clamped, "a clamped command is in range");
    require(!oi::in_range(**outcome) || clamped == **outcome, "a command in range is clamped to itself");
  }
}

namespace {

struct Heard {
  std::vector<Bytes> payloads;
  std::vector<oi::StreamError> errors;
  std::uint64_t skipped{0};
  bool operator==(const Heard&) const = default;
};

[[nodiscard]] Heard hear(ByteView input, std::optional<std::uint8_t> expected, std::size_t piece) {
  oi::StreamDecoder decoder{expected};
  Heard heard;
  feed(decoder, input, piece, [&](const auto& outcome) {
    if (outcome) {
      heard.payloads.emplace_back(outcome->begin(), outcome->end());
    } else {
      heard.errors.push_back(outcome.error());
    }
  });
  heard.skipped = decoder.bytes_skipped();
  return heard;
}

/// Ids of a payload that decode_payload() understood.
[[nodiscard]] Bytes ids_of(ByteView payload) {
  Bytes ids;
  while (!payload.empty()) {
    ids.push_back(payload.front());
    payload = payload.subspan(1u + oi::packet_run(payload.front()).size);
  }
  return ids;
}

}  // namespace

/// Frames do not depend on how the stream was cut; every byte is in a frame, skipped, or still held.
void oi_frames(ByteView input, std::size_t piece) {
  for (const auto expected : {std::optional<std::uint8_t>{}, std::optional<std::uint8_t>{3}}) {
    const Heard whole = hear(input, expected, input.size());
    require(whole == hear(input, expected, piece), "a torn stream gives the frames of a whole one");
    std::size_t accounted = whole.skipped;
    for (const Bytes& payload : whole.payloads) {
      accounted += payload.size() + oi::kStreamOverhead;
      require(!expected || payload.size() == *expected, "a frame has the length asked for");
    }
    require(accounted <= input.size(), "no byte is used twice");
  }
}

/// Values that were read from a payload are written into one that reads the same; StreamLayout agrees in
/// every byte.
void oi_payload(ByteView input) {
  const ByteView payload = input.first(std::min(input.size(), oi::kMaxPayloadBytes));
  oi::SensorValues values;
  const auto count = oi::decode_payload(payload, values);
  if (!count || *count == 0) {
    return;
  }
  const Bytes ids = ids_of(payload);
  require(ids.size() == *count && oi::payload_bytes(ids) == payload.size(), "ids fill their payload");
  std::array<std::uint8_t, 258> frame{};
  const auto size = oi::encode_frame(ids, values, frame);
  require(size && *size == payload.size() + oi::kStreamOverhead, "what was read can be written");
  const ByteView written = ByteView{frame}.first(*size);

  const Heard heard = hear(written, std::nullopt, written.size());
  require(heard.payloads.size() == 1 && heard.skipped == 0, "a frame that was written is heard");
  oi::SensorValues again;
  require(oi::decode_payload(heard.payloads[0], again).has_value() && again == values,
          "values read, written and read are the same");

  const auto layout = oi::StreamLayout::of(ids);
  oi::SensorValues by_layout;
  require(layout && layout->decode(payload, by_layout) && by_layout == values,
          "a layout reads the same values");
  std::array<std::uint8_t, 258> frame_by_layout{};
  require(layout->encode(values, frame_by_layout) == *size && frame == frame_by_layout,
          "a layout writes the same bytes");
}

/// The answer to a single request is encoded to the bytes that it was decoded from.
void oi_answers(ByteView input) {
  if (input.empty()) {
    return;
  }
  const std::uint8_t id = input.front();
  const ByteView answer = input.subspan(1);
  std::array<std::uint8_t, 80> room{};
  oi::SensorValues values;
  if (const auto size = oi::decode_packet(id, answer, values)) {
    const auto written = oi::encode_packet(id, values, room);
    require(
        written && *written == *size && std::ranges::equal(ByteView{room}.first(*size), answer.first(*size)),
        "an answer is encoded as it came");
  }
  oi::SensorValues sci_values;
  if (const auto size = robot::sci::decode_sensors(id, answer, sci_values)) {
    const auto written = robot::sci::encode_sensors(id, sci_values, room);
    require(
        written && *written == *size && std::ranges::equal(ByteView{room}.first(*size), answer.first(*size)),
        "an SCI answer is encoded as it came");
  }
}

/// A driver that hears anything at all says nothing but whole commands in their ranges.
void oi_driver(ByteView input, std::size_t piece, bool sci) {
  ScriptedLink link;
  robot::RoombaConfig config;
  config.interface =
      sci ? robot::RoombaConfig::Interface::kSci : robot::RoombaConfig::Interface::kOpenInterface;
  robot::Roomba driver{link, config};
  Script script{input};
  robot::Instant now{};
  while (!script.empty()) {
    link.say(script.bytes(piece));
    driver.step(now);
    require(driver.drive({0.2, -0.1}) == (driver.status() == robot::RoombaStatus::kReady),
            "wheels turn when the robot is ready, and only then");
    now += robot::kTick;
  }
  driver.shut_down();
  oi::CommandDecoder decoder{sci ? oi::kSerialCommandInterface : oi::kOpenInterface};
  for (const std::uint8_t byte : link.heard()) {
    const auto command = decoder.push(byte);
    require(!command || (*command && oi::in_range(**command)), "a driver says commands in their ranges");
  }
  require(!decoder.waiting(), "a driver says whole commands");
}

}  // namespace sensotwin::fuzz
