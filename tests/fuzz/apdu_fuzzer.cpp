// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>

#include "robot/base/random.hpp"
#include "robot/drivers/tag_reader.hpp"
#include "robot/wire/storage_card.hpp"
#include "robot/wire/tag_record.hpp"
#include "tests/fuzz/fuzzers.hpp"
#include "tests/fuzz/harness.hpp"
#include "twin/devices/emulated_card_reader.hpp"

namespace sensotwin::fuzz {
namespace {

using robot::Bytes;
using robot::ByteView;

/// Commands, responses, UIDs and carpet records are encoded to the bytes that they were decoded from.
void codec(ByteView input) {
  if (const auto command = robot::decode_command(input)) {
    require(std::ranges::equal(robot::encode(*command), input), "a command is encoded as it came");
  } else {
    require(!robot::status_word(command.error()).ok(), "a bad command is not answered by 9000");
  }
  if (const auto response = robot::decode_response(input)) {
    require(std::ranges::equal(robot::encode(*response), input), "a response is encoded as it came");
    require(!robot::to_text(response->status.meaning()).empty(), "a status word has a text");
  }
  for (const robot::UidOrder order : {robot::UidOrder::kMsbFirst, robot::UidOrder::kLsbFirst}) {
    if (const auto uid = robot::decode_uid(input, order)) {
      require(std::ranges::equal(robot::encode_uid(*uid, order), input), "a UID is encoded as it came");
    }
  }
  const auto record = robot::decode_tag_record(input);
  if (!record) {
    return;
  }
  const auto again =
      std::visit([](const auto& one) { return robot::decode_tag_record(robot::encode(one)); }, *record);
  require(again && *again == *record, "a record read, written and read is the same");
}

/// The same bytes as a carpet record with the right sum.
void with_crc(ByteView input) {
  if (input.size() < 8) {
    return;
  }
  const robot::CarpetRecord record{static_cast<std::uint32_t>(input[0] << 16 | input[1] << 8 | input[2]),
                                   robot::s16_from_be(input[4], input[5]),
                                   robot::s16_from_be(input[6], input[7])};
  codec(robot::encode(record));
}

[[nodiscard]] world::TagMemory tag_of(std::uint64_t serial) {
  world::TagMemory tag;
  tag.uid = world::icode_sli_uid(serial);
  tag.locked.set(3);
  tag.blocks[3] = {1, 2, 3, 4};
  return tag;
}

/// A reader answers any command with a status word, when there is a tag that stays; nothing changes a locked
/// block.
void reader(ByteView input, std::uint64_t seed) {
  robot::RandomStream random{seed};
  twin::CardReaderSettings settings;
  settings.exchange = std::chrono::milliseconds{seed % 4 * 10};
  settings.torn_write_probability = 0.5;
  twin::EmulatedCardReader emulated{settings, random.fork("reader")};
  world::TagMemory first = tag_of(1);
  world::TagMemory second = tag_of(2);
  world::TagMemory* const fields[] = {nullptr, &second, &first, &first, &first, &first, &first, &first};
  robot::Instant now{};
  emulated.step(now, &first);
  for (Script script{input}; !script.empty();) {
    const std::size_t size = script.byte() % 64u;
    const ByteView command = script.bytes(size);
    const bool begun = emulated.begin(command);
    require(!begun || emulated.presence() == robot::CardPresence::kPresent, "a command needs a tag");
    if (random.below(16) == 0) {
      emulated.unplug();
    }
    for (int step = 0; step < 3; ++step) {
      now += robot::kTick;
      emulated.step(now, fields[random.below(8)]);
    }
    emulated.replug();
    if (const auto answer = emulated.poll()) {
      require(begun, "there is an answer when there was a command");
      require(!*answer || robot::decode_response(**answer).has_value(), "an answer has a status word");
    }
    const world::TagMemory::Block locked{1, 2, 3, 4};
    require(first.blocks[3] == locked && second.blocks[3] == locked, "a locked block is never changed");
    if (random.below(4) == 0) {  // an answer left lying does not block the reader for ever
      now += std::chrono::seconds{2};
      emulated.step(now, &first);
      static_cast<void>(emulated.poll());
    }
  }
}

/// A card that answers anything.
class WildCard final : public robot::CardLink {
 public:
  WildCard(ByteView answers, std::uint64_t seed) : answers_(answers), random_(seed) {}
  [[nodiscard]] bool done() const { return answers_.empty(); }

 private:
  robot::CardPresence do_presence() override {
    const std::uint32_t what = random_.below(32);
    return what == 0   ? robot::CardPresence::kNoReader
           : what == 1 ? robot::CardPresence::kEmpty
                       : robot::CardPresence::kPresent;
  }
  bool do_begin(ByteView command) override {
    require(robot::decode_command(command).has_value(), "a driver sends sound commands");
    waiting_ = true;
    return random_.below(16) != 0;
  }
  std::optional<robot::Result<Bytes, robot::CardError>> do_poll() override {
    if (!waiting_ || random_.below(4) == 0) {
      return std::nullopt;
    }
    waiting_ = false;
    const std::uint8_t size = answers_.byte();
    if (size > 250) {
      return robot::Unexpected{static_cast<robot::CardError>(size % 3)};
    }
    const ByteView answer = answers_.bytes(size % 20u);
    return Bytes(answer.begin(), answer.end());
  }

  Script answers_;
  robot::RandomStream random_;
  bool waiting_{false};
};

/// A driver takes any answer, and ends every write that it began.
void driver(ByteView input, std::uint64_t seed) {
  WildCard card{input, seed};
  robot::TagReader tags{card};
  robot::Instant now{};
  int writes_begun = 0;
  int writes_ended = 0;
  const Bytes data(12, 0x58);
  for (int step = 0; step < 400 && !card.done(); ++step, now += robot::kTick) {
    tags.step(now);
    while (const auto event = tags.next_event()) {
      writes_ended += std::holds_alternative<robot::WriteOutcome>(*event) ? 1 : 0;
    }
    if (tags.tag()) {
      require(!tags.tag()->data || tags.tag()->data->size() % robot::kBlockBytes == 0,
              "a tag's data is whole blocks");
      writes_begun += tags.write(tags.tag()->uid, 0, data) ? 1 : 0;
    }
    require(writes_begun == writes_ended + (tags.writing() ? 1 : 0), "each write has one end");
  }
}

}  // namespace

void apdu(ByteView input) {
  Script script{input};
  const std::uint8_t seed = script.byte();
  codec(script.rest());
  with_crc(script.rest());
  reader(script.rest(), seed);
  driver(script.rest(), seed);
}

}  // namespace sensotwin::fuzz
