// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <utility>
#include <vector>

#include "robot/wire/llrp/codec.hpp"
#include "twin/devices/emulated_uhf_reader.hpp"

namespace sensotwin::twin {

/// A message of the reader, taken apart.
struct FromReader {
  robot::llrp::FrameHeader header;
  robot::llrp::Message message;
};

/// An emulated reader and somebody who talks to it in messages.
class UhfBench {
 public:
  explicit UhfBench(UhfReaderSettings settings = {}, UserMemory memory = {})
      : reader{std::move(settings), std::move(memory)} {}

  [[nodiscard]] robot::Bytes sent() {
    robot::Bytes out;
    std::array<std::uint8_t, 1000> chunk;
    while (const std::size_t n = reader.send(chunk)) {
      out.insert(out.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(n));
    }
    return out;
  }
  [[nodiscard]] std::vector<FromReader> messages() {
    const robot::Bytes bytes = sent();
    std::vector<FromReader> out;
    robot::llrp::FrameDecoder decoder{std::max<std::size_t>(bytes.size(), 65536)};
    std::copy(bytes.begin(), bytes.end(), decoder.room().begin());
    decoder.received(bytes.size());
    while (const auto frame = decoder.next()) {
      EXPECT_TRUE(*frame);
      if (!*frame) {
        break;
      }
      const auto message = robot::llrp::decode(**frame);
      EXPECT_TRUE(message);
      out.push_back({(*frame)->header, *message});
    }
    return out;
  }
  /// Messages of one kind among those the reader has sent since the last time.
  template <class T>
  [[nodiscard]] std::vector<T> only() {
    std::vector<T> out;
    for (const FromReader& each : messages()) {
      if (const T* message = std::get_if<T>(&each.message)) {
        out.push_back(*message);
      }
    }
    return out;
  }
  void say(const robot::llrp::Message& message) { reader.receive(robot::llrp::encode(message, ++id)); }
  /// Asks, and gives the status of the answer.
  template <class Response>
  [[nodiscard]] robot::llrp::LlrpStatus ask(const robot::llrp::Message& message) {
    static_cast<void>(sent());
    say(message);
    const auto answers = only<Response>();
    EXPECT_EQ(answers.size(), 1u);
    return answers.empty() ? robot::llrp::LlrpStatus{} : answers.front().status;
  }

  EmulatedUhfReader reader;
  std::uint32_t id{100};
};

/// As short as a ROSpec can be: antenna 1, immediate, each read by itself.
[[nodiscard]] inline robot::llrp::RoSpec plain_ro_spec() {
  namespace llrp = robot::llrp;
  llrp::RoSpec spec{.id = 7};
  spec.boundary.start.kind = llrp::RoStart::kImmediate;
  spec.ai_specs = {{.antennas = {1}, .inventory = {{.id = 1}}}};
  spec.report = llrp::RoReportSpec{.trigger = llrp::RoReportTrigger::kTagsOrEndOfAiSpec,
                                   .tags = 1,
                                   .content = {.antenna_id = true,
                                               .channel_index = true,
                                               .first_seen = true,
                                               .last_seen = true,
                                               .tag_seen_count = true,
                                               .access_spec_id = true}};
  return spec;
}

}  // namespace sensotwin::twin
