// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "robot/drivers/uhf_reader.hpp"
#include "robot/wire/llrp/codec.hpp"
#include "tests/fuzz/fuzzers.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/llrp_parts.hpp"

namespace sensotwin::fuzz {
namespace {

namespace llrp = robot::llrp;
using robot::Bytes;
using robot::ByteView;

/// Small, so that inputs of a fuzzer's size reach the limit.
constexpr std::size_t kMaxFrameBytes = 2048;

struct Heard {
  std::vector<llrp::FrameHeader> headers;
  std::vector<Bytes> bodies;
  std::vector<llrp::FrameError> errors;
  std::uint64_t skipped{0};
  std::size_t held{0};
  bool operator==(const Heard&) const = default;
};

[[nodiscard]] Heard hear(ByteView input, std::size_t piece) {
  llrp::FrameDecoder decoder{kMaxFrameBytes};
  Heard heard;
  feed(decoder, input, piece, [&](const auto& outcome) {
    if (outcome) {
      heard.headers.push_back(outcome->header);
      heard.bodies.emplace_back(outcome->body.begin(), outcome->body.end());
    } else {
      heard.errors.push_back(outcome.error());
    }
  });
  heard.skipped = decoder.bytes_skipped();
  heard.held = decoder.held();
  return heard;
}

/// A message that was read is written in as many bytes, and reads the same again.
void message(const llrp::Frame& frame) {
  const auto decoded = llrp::decode(frame);
  if (!decoded) {
    const llrp::DecodeError& error = decoded.error();
    require(error.path_size <= llrp::DecodeError::kMaxPath && error.position <= frame.body.size(),
            "a fault lies in its message");
    require(!llrp::status_of(error).ok() && !llrp::name_of(error.fault).empty(),
            "a fault has a status and a name");
    return;
  }
  const Bytes written = llrp::encode(*decoded, frame.header.id);
  require(written.size() == frame.body.size() + llrp::kHeaderBytes, "a message is written in as many bytes");
  const ByteView body = ByteView{written}.subspan(llrp::kHeaderBytes);
  const auto again = llrp::decode({frame.header, body});
  require(again && *again == *decoded, "a message read, written and read is the same");
  require(llrp::encode(*again, frame.header.id) == written, "a message is always written alike");
}

void frames(ByteView input, std::size_t piece) {
  const Heard whole = hear(input, input.size());
  require(whole == hear(input, piece), "a torn stream gives the messages of a whole one");
  std::size_t accounted = whole.skipped + whole.held;
  for (std::size_t i = 0; i < whole.bodies.size(); ++i) {
    accounted += whole.bodies[i].size() + llrp::kHeaderBytes;
    message({whole.headers[i], whole.bodies[i]});
  }
  require(accounted == input.size(), "every byte is in a message, skipped or held");
}

/// The driver of a reader that may say anything; it says whole, sound messages.
void driver(ByteView input, std::size_t piece) {
  ScriptedLink link;
  robot::UhfReader reader{link, {}};
  Script script{input};
  robot::Instant now{};
  while (!script.empty()) {
    link.say(script.bytes(piece));
    reader.step(now);
    require(reader.status() != robot::UhfReaderStatus::kReading || !reader.channels_hz().empty(),
            "a reader that reads has told its channels");
    if (reader.begin_memory_read({}, 0, 2)) {
      require(reader.status() == robot::UhfReaderStatus::kReading,
              "memory is asked for of a reader that reads");
    }
    static_cast<void>(reader.poll_memory());
    now += 40 * robot::kTick;  // so that pauses and time-outs pass
  }
  reader.shut_down();
  const Heard said = hear(link.heard(), link.heard().size());
  require(said.errors.empty() && said.held == 0, "a driver says whole messages");
  for (std::size_t i = 0; i < said.bodies.size(); ++i) {
    require(llrp::decode({said.headers[i], said.bodies[i]}).has_value(), "a driver says sound messages");
  }
}

}  // namespace

void llrp(ByteView input) {
  Script script{input};
  const std::size_t piece = 1u + script.byte();
  const std::uint8_t seed = script.byte();
  const ByteView bytes = script.rest();
  frames(bytes, piece);
  if (bytes.size() >= 2) {
    // The same bytes as one message with its length put right, so that mutations reach the parameters.
    const auto type = static_cast<std::uint16_t>(robot::u16_from_be(bytes[0], bytes[1]) & 0x3FFu);
    const std::size_t header = std::min(bytes.size(), llrp::kHeaderBytes);
    message({{llrp::kVersion, type, seed}, bytes.subspan(header)});
  }
  driver(bytes, piece);
  llrp_reader(bytes, piece, seed);
}

}  // namespace sensotwin::fuzz
