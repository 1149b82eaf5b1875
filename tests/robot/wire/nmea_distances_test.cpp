// SPDX-License-Identifier: MIT
#include "robot/wire/nmea_distances.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "robot/base/random.hpp"

namespace sensotwin::robot {
namespace {

/// "S0 1.24, S1 -": what a sentence says.
std::string said(std::string_view body) {
  const auto found = decode_distances({body});
  if (!found) {
    switch (found.error()) {
      case DistanceError::kNoDistances:
        return "no distances";
      case DistanceError::kWrongFieldCount:
        return "wrong field count";
      case DistanceError::kBadNumber:
        return "bad number";
      case DistanceError::kBadUnit:
        return "bad unit";
    }
  }
  std::string text;
  for (const Distance& distance : found->all()) {
    text += (text.empty() ? "S" : ", S") + std::to_string(distance.sonar) + " " +
            (distance.metres ? std::to_string(*distance.metres).substr(0, 4) : "-");
  }
  return text;
}

TEST(NmeaDistances, AreReadInTheirOrder) {
  EXPECT_EQ(said("YXXDR,D,1.24,M,S0,D,,M,S1,D,0.30,M,S6"), "S0 1.24, S1 -, S6 0.30");
}

TEST(NmeaDistances, StandBesideOtherTransducers) {
  EXPECT_EQ(said("YXXDR,C,19.52,C,TempAir,D,2,M,S3,D,0.5,M,DEPTH"), "S3 2.00");
}

TEST(NmeaDistances, OfBrokenSentencesAreRefusedByName) {
  EXPECT_EQ(said("HCHDM,12.0,M"), "no distances");
  EXPECT_EQ(said("YXXDR"), "wrong field count");
  EXPECT_EQ(said("YXXDR,D,1.24,M"), "wrong field count");
  EXPECT_EQ(said("YXXDR,D,1.24,M,S0,D"), "wrong field count");
  EXPECT_EQ(said("YXXDR,D,-1.2,M,S0"), "bad number");
  EXPECT_EQ(said("YXXDR,D,1.2e3,M,S0"), "bad number");
  EXPECT_EQ(said("YXXDR,D,1.2,f,S0"), "bad unit");
}

TEST(NmeaDistances, ComeBackAsTheyWereSentAndFitIntoASentence) {
  RandomStream random(3);
  for (int round = 0; round < 2000; ++round) {
    std::vector<Distance> sent;
    for (std::uint8_t i = 0; i < kDistancesEncoded; ++i) {
      sent.push_back({static_cast<std::uint8_t>(random.below(10)), std::nullopt});
      if (random.chance(0.8)) {
        sent.back().metres = 0.01 * static_cast<double>(random.below(10000));
      }
    }
    const Bytes bytes = encode_distances(sent);
    ASSERT_LE(bytes.size(), kNmeaMaxCharacters);
    NmeaDecoder decoder;
    std::size_t received = 0;
    for (const std::uint8_t byte : bytes) {
      if (const auto sentence = decoder.push(byte)) {
        ASSERT_TRUE(*sentence);
        const auto found = decode_distances(**sentence);
        ASSERT_TRUE(found);
        for (const Distance& distance : found->all()) {
          EXPECT_EQ(distance.sonar, sent[received].sonar);
          ASSERT_EQ(distance.metres.has_value(), sent[received].metres.has_value());
          EXPECT_NEAR(distance.metres.value_or(0.0), sent[received].metres.value_or(0.0), 1e-9);
          ++received;
        }
      }
    }
    EXPECT_EQ(received, sent.size());
  }
}

TEST(NmeaDistances, OfRandomFieldsNeverBreakTheDecoder) {
  RandomStream random(4);
  constexpr std::string_view kAlphabet = ",,,,D.M0123S9xC";
  for (int round = 0; round < 20000; ++round) {
    std::string body = "YXXDR";
    const std::uint32_t length = random.below(70);
    for (std::uint32_t i = 0; i < length; ++i) {
      body += kAlphabet[random.below(static_cast<std::uint32_t>(kAlphabet.size()))];
    }
    const auto found = decode_distances({body});
    EXPECT_TRUE(!found || found->count <= kDistancesPerSentence);
  }
}

}  // namespace
}  // namespace sensotwin::robot
