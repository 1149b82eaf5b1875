// SPDX-License-Identifier: MIT
#include <array>
#include <chrono>
#include <vector>

#include "robot/base/random.hpp"
#include "robot/wire/llrp/codec.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/llrp_parts.hpp"
#include "twin/devices/emulated_uhf_reader.hpp"

namespace sensotwin::fuzz {
namespace {

namespace llrp = robot::llrp;
using robot::Bytes;
using robot::ByteView;

constexpr std::size_t kBufferBytes = 16 * 1024;

[[nodiscard]] Bytes sent_by(twin::EmulatedUhfReader& reader) {
  Bytes sent;
  std::array<std::uint8_t, 997> chunk{};
  while (const std::size_t count = reader.send(chunk)) {
    sent.insert(sent.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return sent;
}

/// What a client hears is whole messages, each of which reads and is written alike.
void check_sent(const Bytes& sent) {
  std::size_t accounted = 0;
  llrp::FrameDecoder decoder;
  feed(decoder, sent, sent.size(), [&accounted](const auto& frame) {
    require(frame.has_value(), "a reader sends sound frames");
    accounted += frame->body.size() + llrp::kHeaderBytes;
    if (frame->header.version != llrp::kVersion) {
      return;  // the refusal of a version, told in that version
    }
    const auto message = llrp::decode(*frame);
    require(message.has_value(), "a reader sends sound messages");
    const Bytes again = llrp::encode(*message, frame->header.id);
    require(
        std::equal(again.begin() + llrp::kHeaderBytes, again.end(), frame->body.begin(), frame->body.end()),
        "a reader's message is encoded as it came");
  });
  require(accounted == sent.size(), "a reader sends whole messages");
}

}  // namespace

void llrp_reader(ByteView input, std::size_t piece, std::uint64_t seed) {
  std::array<std::uint16_t, 8> user_bank{};
  twin::UhfReaderSettings settings;
  settings.buffer_bytes = kBufferBytes;
  twin::EmulatedUhfReader reader{settings, [&user_bank](const robot::Epc&) { return std::span{user_bank}; }};
  robot::RandomStream random{seed};
  robot::Instant now{};
  const bool reads = seed % 4 != 0;  // some clients never read
  bool connected = reader.connect();
  require(connected && !reader.connect(), "one client at a time");
  check_sent(reader.refusal());
  Bytes sent;
  for (Script script{input}; !script.empty();) {
    reader.receive(script.bytes(piece));
    now += std::chrono::milliseconds{random.below(400)};
    for (std::uint32_t tags = random.below(3); tags > 0; --tags) {
      twin::RadioReading reading;
      reading.at = now;
      reading.epc.bytes[0] = static_cast<std::uint8_t>(random.below(2));
      reading.antenna = static_cast<std::uint16_t>(random.below(6));
      reading.phase_rad = random.uniform(-100.0, 100.0);
      reading.rssi_dbm = random.uniform(-200.0, 50.0);
      reading.doppler_hz = random.uniform(-1e4, 1e4);
      static_cast<void>(reader.report(reading));
    }
    reader.step(now);
    if (reads) {
      const Bytes more = sent_by(reader);
      sent.insert(sent.end(), more.begin(), more.end());
    }
    if (!reader.is_connected() || random.below(64) == 0) {
      check_sent(sent);
      sent.clear();
      reader.disconnect();
      require(reader.connect(), "who is gone makes room");
    }
  }
  now += std::chrono::seconds{1};
  reader.step(now);
  const Bytes rest = sent_by(reader);
  // Twice the buffer throws the client out; the answers to one more piece may lie behind it.
  require(rest.size() <= 2 * kBufferBytes + llrp::kDefaultMaxFrameBytes, "what nobody takes is bounded");
  sent.insert(sent.end(), rest.begin(), rest.end());
  check_sent(sent);
}

}  // namespace sensotwin::fuzz
