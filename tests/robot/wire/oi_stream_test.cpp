// SPDX-License-Identifier: MIT
#include "robot/wire/oi_stream.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "robot/base/random.hpp"

namespace sensotwin::robot::oi {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Page 22, worked example for the request 148 2 29 13. Errata: the prose calls packet 29 the left cliff
// signal (it is the front left one) and decimal bytes 2 25 "549 (0x0225)"; they are 537 (0x0219).
const Bytes kManualFrame{19, 5, 29, 2, 25, 13, 0, 163};

struct Decoded {
  std::vector<Bytes> payloads;
  std::vector<StreamError> errors;
};

void drain(StreamDecoder& decoder, Decoded& out) {
  while (const auto result = decoder.next()) {
    if (*result) {
      out.payloads.emplace_back((*result)->begin(), (*result)->end());
    } else {
      out.errors.push_back(result->error());
    }
  }
}

/// Feeds `bytes` in pieces of `chunk`.
[[nodiscard]] Decoded decode(ByteView bytes, std::size_t chunk = 1, StreamDecoder decoder = StreamDecoder{}) {
  Decoded out;
  while (!bytes.empty()) {
    const auto room = decoder.room();
    const std::size_t count = std::min({chunk, bytes.size(), room.size()});
    std::copy_n(bytes.begin(), count, room.begin());
    decoder.received(count);
    bytes = bytes.subspan(count);
    drain(decoder, out);
  }
  return out;
}

void append(Bytes& to, const Bytes& bytes) {
  to.insert(to.end(), bytes.begin(), bytes.end());
}

[[nodiscard]] Bytes frame_of(ByteView ids, const SensorValues& values) {
  Bytes bytes(300);
  bytes.resize(*encode_frame(ids, values, bytes));
  return bytes;
}

TEST(StreamDecoder, AcceptsTheWorkedExampleOfTheManual) {
  const Decoded decoded = decode(kManualFrame);
  ASSERT_THAT(decoded.payloads, SizeIs(1));
  SensorValues values;
  EXPECT_EQ(*decode_payload(decoded.payloads[0], values), 2u);
  EXPECT_EQ(values[PacketId::kCliffFrontLeftSignal], 537);
  EXPECT_EQ(values[PacketId::kVirtualWall], 0);
}

TEST(StreamFrame, IsWrittenAsInTheWorkedExampleOfTheManual) {
  SensorValues values;
  values[PacketId::kCliffFrontLeftSignal] = 537;
  EXPECT_EQ(frame_of(Bytes{29, 13}, values), kManualFrame);
}

// The Create 1 manual (page 14) prints 182 for the same frame: it leaves the header out of the sum.
TEST(StreamDecoder, RefusesTheChecksumOfTheCreate1Manual) {
  Bytes frame = kManualFrame;
  frame.back() = 182;
  EXPECT_THAT(decode(frame).errors, ElementsAre(StreamError::kBadChecksum));
}

TEST(StreamDecoder, ReportsOneFlippedBitAsBadChecksum) {
  for (std::size_t i = 2; i < kManualFrame.size(); ++i) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      Bytes frame = kManualFrame;
      frame[i] = static_cast<std::uint8_t>(frame[i] ^ (1u << bit));
      const Decoded decoded = decode(frame);
      EXPECT_THAT(decoded.payloads, IsEmpty());
      EXPECT_THAT(decoded.errors, ElementsAre(StreamError::kBadChecksum)) << "byte " << i << " bit " << bit;
    }
  }
}

TEST(StreamDecoder, DecodesTheNextFrameAfterNoise) {
  for (std::size_t chunk = 1; chunk < 20; ++chunk) {
    Bytes bytes{1, 2, 3, 19, 200, 19, 19, 19, 5, 7};
    // 19 19 in the noise announces 19 bytes: the verdict on it falls within the third frame.
    append(bytes, kManualFrame);
    append(bytes, kManualFrame);
    append(bytes, kManualFrame);
    EXPECT_THAT(decode(bytes, chunk).payloads, SizeIs(3)) << "chunk " << chunk;
  }
}

TEST(StreamDecoder, LosesNoGoodFrameBehindACorruptOne) {
  SensorValues values;
  for (std::uint8_t id = kFirstPacket; id <= kLastPacket; ++id) {
    values[static_cast<PacketId>(id)] = 19;  // headers everywhere
  }
  const Bytes ids{7, 43, 44, 22, 25, 46, 47};
  const Bytes good = frame_of(ids, values);
  for (std::size_t lost = 0; lost < good.size(); ++lost) {
    Bytes bytes = good;
    bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(lost));
    append(bytes, good);
    append(bytes, good);
    append(bytes, good);
    const auto n = static_cast<std::uint8_t>(payload_bytes(ids));
    EXPECT_THAT(decode(bytes, 7, StreamDecoder{n}).payloads, SizeIs(3)) << "without byte " << lost;
  }
}

TEST(StreamDecoder, ReportsACorruptFrameOnce) {
  SensorValues values;
  values[PacketId::kEncoderLeft] = 19 * 256 + 19;
  const Bytes ids{43, 44, 7};
  Bytes bytes = frame_of(ids, values);
  bytes[6] ^= 1;
  append(bytes, frame_of(ids, values));
  EXPECT_THAT(decode(bytes, 100).errors, ElementsAre(StreamError::kBadChecksum));
}

TEST(StreamDecoder, SkipsFramesThatNobodyAskedFor) {
  Bytes bytes = kManualFrame;
  append(bytes, frame_of(Bytes{43, 44}, SensorValues{}));
  StreamDecoder decoder{std::uint8_t{6}};
  Decoded out;
  std::ranges::copy(bytes, decoder.room().begin());
  decoder.received(bytes.size());
  drain(decoder, out);
  EXPECT_THAT(out.payloads, ElementsAre(Bytes{43, 0, 0, 44, 0, 0}));
  EXPECT_THAT(out.errors, ElementsAre(StreamError::kBadLength));
  EXPECT_EQ(decoder.bytes_skipped(), kManualFrame.size());
}

TEST(StreamDecoder, RefusesLengthsThatDoNotFitIntoATick) {
  EXPECT_THAT(decode(Bytes{19, 170}).errors, ElementsAre(StreamError::kBadLength));
  EXPECT_THAT(decode(Bytes{19, 169}).errors, IsEmpty());
}

TEST(StreamPayload, MayCarryGroups) {
  SensorValues values;
  values[PacketId::kStasis] = 1;
  const Bytes frame = frame_of(Bytes{100, 35}, values);
  EXPECT_EQ(frame.size(), 86u);
  SensorValues back;
  EXPECT_EQ(*decode_payload(ByteView{frame}.subspan(2, 83), back), 2u);
  EXPECT_EQ(back, values);
}

TEST(StreamPayload, NamesWhatIsWrongWithIt) {
  SensorValues values;
  EXPECT_EQ(decode_payload(Bytes{7, 0, 99}, values).error(), StreamError::kUnknownPacket);
  EXPECT_EQ(decode_payload(Bytes{7, 0, 43, 1}, values).error(), StreamError::kTooShort);
  Bytes small(8);
  EXPECT_EQ(encode_frame(Bytes{102}, values, small).error(), StreamError::kUnknownPacket);
  EXPECT_EQ(encode_frame(Bytes{43, 44}, values, small).error(), StreamError::kNoRoom);
  Bytes large(400);
  EXPECT_EQ(encode_frame(Bytes{100, 100, 100, 100}, values, large).error(), StreamError::kNoRoom);
}

// What libcreate asks of a Create 2; it accepts n = 72 only.
TEST(StreamPayload, OfLibcreatesRequestHas72Bytes) {
  const Bytes ids{7,  8,  9,  10, 11, 12, 13, 14, 15, 17, 18, 21, 22, 23, 24,
                  25, 26, 35, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 58};
  EXPECT_EQ(payload_bytes(ids), 72u);
  EXPECT_EQ(frame_of(ids, SensorValues{}).size(), 75u);
  EXPECT_EQ(frame_of(ids, SensorValues{})[1], 72);
}

TEST(StreamDecoder, NeverCrashesOnAMillionRandomBytes) {
  RandomStream random = RandomStream{3}.fork("stream bytes");
  Bytes bytes(1'000'000);
  for (std::uint8_t& byte : bytes) {
    // Headers and short lengths are made frequent, so that all paths are walked.
    byte = random.chance(0.1) ? kStreamHeader
                              : static_cast<std::uint8_t>(random.below(random.chance(0.5) ? 16 : 256));
  }
  const Decoded decoded = decode(bytes, 101);
  for (const Bytes& payload : decoded.payloads) {
    SensorValues values;
    static_cast<void>(decode_payload(payload, values));
  }
  EXPECT_THAT(decoded.payloads, Not(IsEmpty()));
  EXPECT_THAT(decoded.errors, Not(IsEmpty()));
}

RC_GTEST_PROP(StreamDecoder, GivesBackEveryFrameHoweverTheBytesAreCut, (std::vector<std::uint16_t> counts)) {
  const std::size_t chunk = *rc::gen::inRange<std::size_t>(1, 200);
  const Bytes ids{43, 44, 7, 35};
  Bytes bytes;
  for (const std::uint16_t count : counts) {
    SensorValues values;
    values[PacketId::kEncoderLeft] = static_cast<std::int16_t>(count);
    append(bytes, frame_of(ids, values));
  }
  const Decoded decoded = decode(bytes, chunk);
  RC_ASSERT(decoded.errors.empty());
  RC_ASSERT(decoded.payloads.size() == counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    SensorValues values;
    RC_ASSERT(decode_payload(decoded.payloads[i], values).has_value());
    RC_ASSERT(values[PacketId::kEncoderLeft] == static_cast<std::int16_t>(counts[i]));
  }
}

}  // namespace
}  // namespace sensotwin::robot::oi
