// SPDX-License-Identifier: MIT
#include "robot/output/text_format.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace sensotwin::robot {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <int Decimals>
std::string fixed(double value) {
  std::string text(24, '?');
  text.resize(static_cast<std::size_t>(put_fixed<Decimals>(text.data(), value) - text.data()));
  return text;
}

TEST(FixedPoint, RoundsToTheNearestDigit) {
  EXPECT_EQ(fixed<3>(1.2344999), "1.234");
  EXPECT_EQ(fixed<3>(1.2346), "1.235");
  EXPECT_EQ(fixed<3>(-1.2346), "-1.235");
  EXPECT_EQ(fixed<0>(2.0), "2");
  EXPECT_EQ(fixed<2>(1234567.891), "1234567.89");
}

TEST(FixedPoint, KeepsTheZerosBehindThePoint) {
  EXPECT_EQ(fixed<5>(0.00012), "0.00012");
  EXPECT_EQ(fixed<5>(3.0), "3.00000");
}

TEST(FixedPoint, NeverWritesMinusZero) {
  EXPECT_EQ(fixed<2>(-0.0), "0.00");
  EXPECT_EQ(fixed<2>(-0.004), "0.00");
}

TEST(FixedPoint, WritesNothingForWhatIsNoNumberOrTooLarge) {
  EXPECT_EQ(fixed<5>(kNan), "");
  EXPECT_EQ(fixed<5>(-std::numeric_limits<double>::infinity()), "");
  EXPECT_EQ(fixed<5>(1e12), "");
}

TEST(JsonString, EscapesWhatJsonReserves) {
  std::string text;
  append_json_string(text, "a\"b\\c\n\t\x01 \xC3\xBC");
  EXPECT_EQ(text, "\"a\\\"b\\\\c\\n\\t\\u0001 \xC3\xBC\"");
}

TEST(JsonString, ReplacesBytesThatAreNoUtf8) {
  for (const std::string bad :
       {"\xFF", "\xC3", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xC0\xAF"}) {
    std::string text;
    append_json_string(text, bad);
    EXPECT_TRUE(nlohmann::json::accept(text)) << text;
    EXPECT_THAT(text, ::testing::HasSubstr("\xEF\xBF\xBD"));
  }
}

TEST(XmlText, EscapesWhatXmlReservesAndReplacesWhatItForbids) {
  std::string text;
  append_xml_text(text, "<a b=\"c\">'R&D'\n\xC3\xBC\x01\xFF\xEF\xBF\xBE");
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(text, "&lt;a b=&quot;c&quot;&gt;&apos;R&amp;D&apos;\n\xC3\xBC" + replaced + replaced + replaced);
}

}  // namespace
}  // namespace sensotwin::robot
