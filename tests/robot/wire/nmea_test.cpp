// SPDX-License-Identifier: MIT
#include "robot/wire/nmea.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/base/random.hpp"

namespace sensotwin::robot {
namespace {

/// What a decoder said to a text, in order.
struct Heard {
  std::vector<std::string> bodies;
  std::vector<NmeaError> errors;
};
void feed(NmeaDecoder& decoder, std::string_view text, Heard& heard) {
  for (const char c : text) {
    if (const auto said = decoder.push(static_cast<std::uint8_t>(c))) {
      if (*said) {
        heard.bodies.emplace_back((*said)->body);
      } else {
        heard.errors.push_back(said->error());
      }
    }
  }
}
Heard listen(std::string_view text) {
  NmeaDecoder decoder;
  Heard heard;
  feed(decoder, text, heard);
  return heard;
}
std::string text_of(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}
using Bodies = std::vector<std::string>;
using Errors = std::vector<NmeaError>;

// The two examples that compass manuals and gpsd's protocol page share.
TEST(NmeaDecoder, AcceptsPublishedSentences) {
  EXPECT_EQ(listen("$HCHDG,98.3,0.0,E,12.6,W*57\r\n").bodies, Bodies{"HCHDG,98.3,0.0,E,12.6,W"});
  EXPECT_EQ(listen("$HCHDG,101.1,,,7.1,W*3C\r\n").bodies, Bodies{"HCHDG,101.1,,,7.1,W"});
}

TEST(NmeaDecoder, SplitsTheAddressInTalkerAndFormatter) {
  const NmeaSentence sentence{"HCHDM,1.0,M"};
  EXPECT_EQ(sentence.talker(), "HC");
  EXPECT_EQ(sentence.formatter(), "HDM");
  EXPECT_EQ(NmeaSentence{"PGRME,1"}.talker(), "PG");
  EXPECT_EQ(NmeaSentence{"HDM,1"}.formatter(), "");
}

TEST(NmeaDecoder, AcceptsLowerCaseChecksumDigits) {
  EXPECT_EQ(listen("$HCHDG,101.1,,,7.1,W*3c\r\n").bodies.size(), 1u);
}

TEST(NmeaDecoder, NamesEachMistakeAndDecodesTheNextSentence) {
  const std::string good = text_of(encode_nmea("HCHDM,90.0,M"));
  const std::vector<std::pair<std::string, NmeaError>> mistakes{
      {"$HCHDM,90.0,M*00\r\n", NmeaError::kBadChecksum},
      {"$HCHDM,90.0,M\r\n", NmeaError::kMissingChecksum},
      {"$HCHDM,90.0,M*\r\n", NmeaError::kMissingChecksum},
      {"$HCHDM,90.0,M*1\r\n", NmeaError::kMissingChecksum},
      {"$HCHDM,90.0,M*G1\r\n", NmeaError::kBadChecksumDigit},
      {good.substr(0, good.size() - 2) + "\n", NmeaError::kBadLineEnd},
      {good.substr(0, good.size() - 1) + "x", NmeaError::kBadLineEnd},
      {"$HCHDM,9\x01", NmeaError::kBadCharacter},
      {"$HCHDM,9\xC3\xA4", NmeaError::kBadCharacter},
      {"$HCHDM,90", NmeaError::kInterrupted},
      {"$" + std::string(77, 'A'), NmeaError::kTooLong},
  };
  for (const auto& [text, error] : mistakes) {
    const Heard heard = listen(text + good);
    EXPECT_EQ(heard.errors, Errors{error}) << text;
    EXPECT_EQ(heard.bodies, Bodies{"HCHDM,90.0,M"}) << text;
  }
}

TEST(NmeaDecoder, AcceptsEightyTwoCharactersAndNotOneMore) {
  const std::string longest(76, 'A');
  EXPECT_EQ(encode_nmea(longest).size(), kNmeaMaxCharacters);
  EXPECT_EQ(listen(text_of(encode_nmea(longest))).bodies, Bodies{longest});
  EXPECT_EQ(listen("$" + longest + "A*41\r\n").errors, Errors{NmeaError::kTooLong});
}

TEST(NmeaDecoder, IgnoresNoiseBetweenSentences) {
  const std::string good = text_of(encode_nmea("HCHDM,90.0,M"));
  const Heard heard = listen("\x02\xFFGARBAGE*12\r\n" + good + "\r\n\n*" + good);
  EXPECT_EQ(heard.bodies.size(), 2u);
  EXPECT_TRUE(heard.errors.empty());
}

TEST(NmeaDecoder, EverySingleFlippedBitOfASentenceIsNoticed) {
  const Bytes good = encode_nmea("HCHDM,238.5,M");
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    Bytes bad = good;
    bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ (1u << (bit % 8)));
    for (const std::string& body : listen(text_of(bad)).bodies) {
      // The case of a checksum digit is the one bit that says nothing.
      EXPECT_EQ(body, "HCHDM,238.5,M") << bit;
      EXPECT_GE(bit / 8, good.size() - 4);
    }
  }
}

TEST(NmeaDecoder, NeverCrashesOnAMillionRandomBytesAndFindsTheSentenceBehindThem) {
  RandomStream random{183};
  NmeaDecoder decoder;
  constexpr std::string_view kLikely = "$*,.HCDMGT0123456789ABCDEF\r\n";
  for (int i = 0; i < 1'000'000; ++i) {
    const bool likely = random.chance(0.9);
    (void)decoder.push(likely ? static_cast<std::uint8_t>(kLikely[random.below(kLikely.size())])
                              : static_cast<std::uint8_t>(random.below(256)));
  }
  Heard heard;
  feed(decoder, "\r\n" + text_of(encode_nmea("HCHDM,1.0,M")), heard);
  EXPECT_EQ(heard.bodies, Bodies{"HCHDM,1.0,M"});
}

TEST(NmeaHeading, HdmIsWrittenWithOneDecimal) {
  EXPECT_EQ(text_of(encode_hdm({238.5})), "$HCHDM,238.5,M*25\r\n");
  EXPECT_EQ(text_of(encode_hdm({0.0})).substr(0, 12), "$HCHDM,0.0,M");
  EXPECT_EQ(text_of(encode_hdm({7.04})).substr(0, 12), "$HCHDM,7.0,M");
}

TEST(NmeaHeading, HdmNeverSaysThreeHundredAndSixty) {
  EXPECT_EQ(text_of(encode_hdm({359.96})).substr(0, 12), "$HCHDM,0.0,M");
  EXPECT_EQ(text_of(encode_hdm({360.0})).substr(0, 12), "$HCHDM,0.0,M");
  EXPECT_EQ(text_of(encode_hdm({-1e-20})).substr(0, 12), "$HCHDM,0.0,M");
  EXPECT_EQ(text_of(encode_hdm({-0.1})).substr(0, 14), "$HCHDM,359.9,M");
}

TEST(NmeaHeading, EveryTenthOfADegreeComesBack) {
  NmeaDecoder decoder;
  for (int tenths = 0; tenths < 3600; ++tenths) {
    for (const std::uint8_t byte : encode_hdm({tenths / 10.0})) {
      if (const auto said = decoder.push(byte)) {
        ASSERT_TRUE(*said);
        const auto heading = decode_heading(**said);
        ASSERT_TRUE(heading);
        EXPECT_DOUBLE_EQ(std::get<Hdm>(*heading).magnetic_deg, tenths / 10.0);
      }
    }
  }
}

TEST(NmeaHeading, HdgAddsEasterlyDeviationAndKeepsVariationApart) {
  const auto decoded = decode_heading({"HCHDG,350.0,15.0,E,7.5,W"});
  ASSERT_TRUE(decoded);
  const auto& hdg = std::get<Hdg>(*decoded);
  EXPECT_DOUBLE_EQ(hdg.magnetic_deg(), 5.0);
  EXPECT_DOUBLE_EQ(*hdg.deviation_east_deg, 15.0);
  EXPECT_DOUBLE_EQ(*hdg.variation_east_deg, -7.5);
}

TEST(NmeaHeading, HdgMayLeaveDeviationAndVariationEmpty) {
  const auto decoded = decode_heading({"HCHDG,238.5,,,,"});
  ASSERT_TRUE(decoded);
  EXPECT_DOUBLE_EQ(std::get<Hdg>(*decoded).magnetic_deg(), 238.5);
  EXPECT_FALSE(std::get<Hdg>(*decoded).variation_east_deg);
}

TEST(NmeaHeading, HdtIsTrueNorth) {
  const auto decoded = decode_heading({"HEHDT,274.07,T"});
  ASSERT_TRUE(decoded);
  EXPECT_DOUBLE_EQ(std::get<Hdt>(*decoded).true_deg, 274.07);
}

TEST(NmeaHeading, NamesEachMistake) {
  const auto error = [](std::string_view body) { return decode_heading({body}).error(); };
  EXPECT_EQ(error("GPGGA,1,2"), HeadingError::kNotAHeading);
  EXPECT_EQ(error(""), HeadingError::kNotAHeading);
  EXPECT_EQ(error("HCHDM,1.0"), HeadingError::kWrongFieldCount);
  EXPECT_EQ(error("HCHDM,1.0,M,"), HeadingError::kWrongFieldCount);
  EXPECT_EQ(error("HCHDG,1.0,,,,,,,,,"), HeadingError::kWrongFieldCount);
  EXPECT_EQ(error("HCHDM,,M"), HeadingError::kNoHeading);
  EXPECT_EQ(error("HCHDM,1e2,M"), HeadingError::kBadNumber);
  EXPECT_EQ(error("HCHDM,-1.0,M"), HeadingError::kBadNumber);
  EXPECT_EQ(error("HCHDM,1.2.3,M"), HeadingError::kBadNumber);
  EXPECT_EQ(error("HCHDM,.,M"), HeadingError::kBadNumber);
  EXPECT_EQ(error("HCHDM,nan,M"), HeadingError::kBadNumber);
  EXPECT_EQ(error("HCHDM,360.0,M"), HeadingError::kOutOfRange);
  EXPECT_EQ(error("HCHDM,1.0,T"), HeadingError::kBadReference);
  EXPECT_EQ(error("HEHDT,1.0,M"), HeadingError::kBadReference);
  EXPECT_EQ(error("HCHDG,1.0,2.0,,,"), HeadingError::kBadReference);
  EXPECT_EQ(error("HCHDG,1.0,,,200.0,E"), HeadingError::kOutOfRange);
  EXPECT_EQ(error("HCHDG,1.0,x,E,,"), HeadingError::kBadNumber);
}

TEST(NmeaHeading, ClockwiseFromNorthBecomesCounterClockwise) {
  EXPECT_DOUBLE_EQ(yaw_rad_from_heading_deg(0.0), 0.0);
  EXPECT_DOUBLE_EQ(yaw_rad_from_heading_deg(90.0), -kPi / 2);  // east is a quarter turn to the right of north
  EXPECT_DOUBLE_EQ(yaw_rad_from_heading_deg(270.0), kPi / 2);
  EXPECT_DOUBLE_EQ(yaw_rad_from_heading_deg(180.0), kPi);  // (-pi, pi]
  for (int deg = 0; deg < 360; ++deg) {
    EXPECT_NEAR(heading_deg_from_yaw_rad(yaw_rad_from_heading_deg(deg)), deg, 1e-9);
  }
}

}  // namespace
}  // namespace sensotwin::robot
