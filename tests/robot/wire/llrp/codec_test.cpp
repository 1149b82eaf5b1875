// SPDX-License-Identifier: MIT
#include "robot/wire/llrp/codec.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <set>

#include "tests/robot/wire/llrp/random_message.hpp"

namespace sensotwin::robot::llrp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Decodes a body given as bytes behind a header of that type.
[[nodiscard]] DecodeError error_of(MessageType type, const Bytes& body) {
  const auto message = decode({{kVersion, static_cast<std::uint16_t>(type), 1}, body});
  EXPECT_FALSE(message);
  return message ? DecodeError{} : message.error();
}

[[nodiscard]] std::vector<std::uint16_t> path_of(const DecodeError& error) {
  return {error.path.begin(), error.path.begin() + static_cast<std::ptrdiff_t>(error.path_size)};
}

TEST(LlrpCodec, GivesBackEveryKindOfMessageFilledAtRandom) {
  const RandomStream random{20070813};  // chosen: the day of LLRP 1.0.1
  for (int round = 0; round < 300; ++round) {
    for (const Message& message : random_messages(random.fork(std::to_string(round)))) {
      const Bytes bytes = encode(message, 0xABCD1234u);
      const Frame frame = frame_of(bytes);
      EXPECT_EQ(frame.header.id, 0xABCD1234u);
      const auto again = decode(frame);
      ASSERT_TRUE(again) << "type " << frame.header.type << ": " << name_of(again.error().fault);
      ASSERT_EQ(*again, message) << "type " << frame.header.type;
    }
  }
}

TEST(LlrpCodec, RefusesEveryMessageThatIsCutShortOrTakesItForAShorterOne) {
  for (const Message& message : random_messages(RandomStream{2})) {
    const Bytes bytes = encode(message, 1);
    const Frame whole = frame_of(bytes);
    for (std::size_t n = 0; n < whole.body.size(); ++n) {
      const auto part = decode({whole.header, whole.body.first(n)});
      EXPECT_TRUE(!part || !(*part == message)) << "type " << whole.header.type << " cut to " << n;
    }
  }
}

TEST(LlrpCodec, NeverCrashesOnCorruptMessagesAndUnderstandsWhatItStillAccepts) {
  RandomStream random{3};
  std::set<Fault> seen;
  int accepted = 0;
  for (int round = 0; round < 60; ++round) {
    for (const Message& message : random_messages(random.fork(std::to_string(round)))) {
      Bytes bytes = encode(message, 1);
      const std::uint32_t hits = 1 + random.below(4);
      for (std::uint32_t i = 0; i < hits && bytes.size() > kHeaderBytes; ++i) {
        bytes[kHeaderBytes + random.below(static_cast<std::uint32_t>(bytes.size() - kHeaderBytes))] =
            static_cast<std::uint8_t>(random.below(256));
      }
      const auto first = decode(frame_of(bytes));
      if (!first) {
        seen.insert(first.error().fault);
        EXPECT_FALSE(status_of(first.error()).ok());
        continue;
      }
      ++accepted;
      const Bytes written = encode(*first, 1);
      const auto second = decode(frame_of(written));
      ASSERT_TRUE(second);
      EXPECT_EQ(*second, *first);
    }
  }
  EXPECT_GT(accepted, 100);
  EXPECT_GE(seen.size(), 8u);
}

TEST(LlrpCodec, NeverCrashesOnRandomBodies) {
  RandomStream random{4};
  for (int round = 0; round < 20000; ++round) {
    Bytes body(random.below(60));
    for (std::uint8_t& byte : body) {
      byte = static_cast<std::uint8_t>(random.below(256));
    }
    const auto type = static_cast<std::uint16_t>(random.chance(0.8) ? random.below(110) : 1023);
    const auto message = decode({{kVersion, type, 1}, body});
    if (message) {
      EXPECT_EQ(static_cast<std::uint16_t>(type_of(*message)), type);
    }
  }
}

TEST(LlrpCodec, TakesParametersInAnyOrder) {
  KeepaliveSpec keepalive{KeepaliveTrigger::kPeriodic, 1000};
  const SetReaderConfig request{.events = EventSpec{{{EventKind::kAntenna, true}}}, .keepalive = keepalive};
  const Bytes bytes = encode(request, 1);
  // Events are 11 bytes (a list of one entry of 7), the keepalive 9; the flag of the message comes before.
  Bytes body(bytes.begin() + kHeaderBytes, bytes.end());
  std::rotate(body.begin() + 1, body.begin() + 1 + 11, body.end());
  const auto message = decode({{kVersion, 3, 1}, body});
  ASSERT_TRUE(message);
  EXPECT_EQ(std::get<SetReaderConfig>(*message), request);
}

TEST(LlrpCodec, NamesWhereAFaultLies) {
  // SET_READER_CONFIG { 244 { 245 kind 99 } }
  const DecodeError error =
      error_of(MessageType::kSetReaderConfig, {0, 0, 244, 0, 11, 0, 245, 0, 7, 0, 99, 0});
  EXPECT_EQ(error.fault, Fault::kBadField);
  EXPECT_THAT(path_of(error), ElementsAre(244, 245));
  EXPECT_EQ(error.field, 1);
}

TEST(LlrpCodec, TellsAFaultInsideParametersAsAChainOfParameterErrors) {
  const LlrpStatus status =
      status_of(error_of(MessageType::kSetReaderConfig, {0, 0, 244, 0, 11, 0, 245, 0, 7, 0, 99, 0}));
  EXPECT_EQ(status.code, StatusCode::kParameterError);
  EXPECT_EQ(status.parameter_error->parameter, 244);
  EXPECT_EQ(status.parameter_error->code, StatusCode::kInParameterError);
  const ParameterError& inner = status.parameter_error->inner.at(0);
  EXPECT_EQ(inner.parameter, 245);
  EXPECT_EQ(inner.code, StatusCode::kInFieldError);
  EXPECT_EQ(inner.field_error, (FieldError{1, StatusCode::kInvalidField}));
}

TEST(LlrpCodec, TellsEachWayAParameterHeaderCanLie) {
  const auto fault = [](const Bytes& body) { return error_of(MessageType::kRoAccessReport, body).fault; };
  EXPECT_EQ(fault({0, 240, 0, 3}), Fault::kBadParameterLength);
  EXPECT_EQ(fault({0, 240, 0, 5}), Fault::kBadParameterLength);
  EXPECT_EQ(fault({0, 240, 0}), Fault::kTrailingBytes);
  EXPECT_EQ(fault({0x04, 240, 0, 4}), Fault::kBadParameterHeader) << "a reserved bit";
  EXPECT_EQ(fault({0, 13, 0, 4}), Fault::kBadParameterHeader) << "a TV number in a TLV header";
  EXPECT_EQ(fault({0, 240, 0, 6, 0xFF, 0}), Fault::kUnknownParameter) << "TV 127";
  EXPECT_EQ(fault({0, 240, 0, 6, 0x8D, 1}), Fault::kTruncated) << "EPC-96 of one byte";
  EXPECT_EQ(fault({0, 240, 0, 7, 0x81, 0, 1}), Fault::kMissingParameter) << "no EPC";
  EXPECT_EQ(fault({0, 242, 0, 4}), Fault::kUnsupportedParameter) << "RF survey";
  EXPECT_EQ(fault({1, 144, 0, 4}), Fault::kUnknownParameter) << "type 400";
  EXPECT_EQ(fault({0x03, 0xFF, 0, 8, 0, 0, 0x65, 0x1A}), Fault::kBadParameterLength) << "custom, no subtype";
}

TEST(LlrpCodec, RefusesErrorsNestedDeeperThanAnyMessageIs) {
  LlrpStatus status{.code = StatusCode::kParameterError};
  ParameterError* innermost = &status.parameter_error.emplace();
  for (int i = 0; i < 20; ++i) {
    innermost = &innermost->inner.emplace_back();
  }
  const Bytes bytes = encode(ErrorMessage{status}, 1);
  const auto message = decode(frame_of(bytes));
  ASSERT_FALSE(message);
  EXPECT_EQ(message.error().fault, Fault::kTooDeep);
}

TEST(LlrpCodec, KeepsForeignCustomParametersAsTheyCame) {
  GetReaderCapabilities request;
  request.customs = {{kImpinj, 21, {0, 0, 7, 208}}, {99, 1, {}}};
  const Bytes bytes = encode(request, 1);
  const auto message = decode(frame_of(bytes));
  ASSERT_TRUE(message);
  EXPECT_EQ(std::get<GetReaderCapabilities>(*message), request);
}

TEST(LlrpCodec, WritesAnErrorInTheVersionOfTheOneWhoAsked) {
  const Bytes bytes = encode(ErrorMessage{{.code = StatusCode::kUnsupportedVersion}}, 7, 2);
  EXPECT_THAT(Bytes(bytes.begin(), bytes.begin() + 2), ElementsAre(0x08, 100));
}

// Not a bound on anything: prints what the decoding of a report costs on this machine.
TEST(LlrpCodec, DecodesAReportWithPhaseInWellUnderATenthOfAMillisecond) {
  TagReport tag;
  tag.epc_96 = Epc{};
  tag.antenna_id = 1;
  tag.peak_rssi_dbm = std::int8_t{-52};
  tag.channel_index = 6;
  tag.first_seen_utc_us = tag.last_seen_utc_us = 1795312911062070u;
  tag.phase_angle = ImpinjPhaseAngle{2162};
  tag.impinj_rssi = ImpinjPeakRssi{-5221};
  const Bytes bytes = encode(RoAccessReport{{tag}, {}}, 1);
  const Frame frame = frame_of(bytes);
  constexpr int kRounds = 20000;
  const auto start = std::chrono::steady_clock::now();
  int good = 0;
  for (int i = 0; i < kRounds; ++i) {
    good += decode(frame).has_value() ? 1 : 0;
  }
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
  std::cout << bytes.size() << " bytes, " << took.count() / kRounds << " ns a report\n";
  EXPECT_EQ(good, kRounds);
  EXPECT_LT(took.count() / kRounds, 100e3);
}

}  // namespace
}  // namespace sensotwin::robot::llrp
