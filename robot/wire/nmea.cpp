// SPDX-License-Identifier: MIT
#include "robot/wire/nmea.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

#include "robot/base/geometry.hpp"
#include "robot/wire/nmea_fields.hpp"

namespace sensotwin::robot {
namespace {

/// `$`, `*`, two digits, CR, LF.
constexpr std::size_t kFrameCharacters = 6;
constexpr std::size_t kMaxBody = kNmeaMaxCharacters - kFrameCharacters;
constexpr std::string_view kHexDigits = "0123456789ABCDEF";

std::optional<std::uint8_t> hex_digit(std::uint8_t c) {
  if (c >= '0' && c <= '9') {
    return static_cast<std::uint8_t>(c - '0');
  }
  // Upper case by the standard; lower case is common, and not ambiguous.
  if (c >= 'A' && c <= 'F') {
    return static_cast<std::uint8_t>(c - 'A' + 10);
  }
  if (c >= 'a' && c <= 'f') {
    return static_cast<std::uint8_t>(c - 'a' + 10);
  }
  return std::nullopt;
}

double in_full_circle(double deg) {
  const double wrapped = std::fmod(deg, 360.0);
  const double positive = wrapped < 0.0 ? wrapped + 360.0 : wrapped;
  return positive >= 360.0 ? 0.0 : positive;  // -1e-20 + 360 rounds to 360
}

Result<double, HeadingError> parse_heading(std::string_view text) {
  if (text.empty()) {
    return Unexpected{HeadingError::kNoHeading};
  }
  const std::optional<double> value = nmea_number(text);
  if (!value) {
    return Unexpected{HeadingError::kBadNumber};
  }
  if (*value >= 360.0) {
    return Unexpected{HeadingError::kOutOfRange};
  }
  return *value;
}

/// A magnitude and its side. Both empty: not known.
Result<std::optional<double>, HeadingError> parse_east(std::string_view magnitude, std::string_view side) {
  // Compasses without a variation send "..,,E" as well as "..,,": with no number the side says nothing.
  if (magnitude.empty() && (side.empty() || side == "E" || side == "W")) {
    return std::optional<double>{};
  }
  const std::optional<double> value = nmea_number(magnitude);
  if (!value) {
    return Unexpected{HeadingError::kBadNumber};
  }
  if (*value > 180.0) {
    return Unexpected{HeadingError::kOutOfRange};
  }
  if (side != "E" && side != "W") {
    return Unexpected{HeadingError::kBadReference};
  }
  return std::optional{side == "E" ? *value : -*value};
}

Result<HeadingSentence, HeadingError> decode_hdg(const NmeaFields& fields) {
  if (fields.count != 6) {
    return Unexpected{HeadingError::kWrongFieldCount};
  }
  const auto heading = parse_heading(fields.at[1]);
  if (!heading) {
    return Unexpected{heading.error()};
  }
  const auto deviation = parse_east(fields.at[2], fields.at[3]);
  if (!deviation) {
    return Unexpected{deviation.error()};
  }
  const auto variation = parse_east(fields.at[4], fields.at[5]);
  if (!variation) {
    return Unexpected{variation.error()};
  }
  return HeadingSentence{Hdg{*heading, *deviation, *variation}};
}

}  // namespace

std::string_view NmeaSentence::talker() const {
  const std::string_view address = body.substr(0, body.find(','));
  return address.size() == 5 ? address.substr(0, 2) : std::string_view{};
}

std::string_view NmeaSentence::formatter() const {
  const std::string_view address = body.substr(0, body.find(','));
  return address.size() == 5 ? address.substr(2) : std::string_view{};
}

std::optional<Result<NmeaSentence, NmeaError>> NmeaDecoder::drop(NmeaError error) {
  state_ = State::kHunting;
  return Unexpected{error};
}

std::optional<Result<NmeaSentence, NmeaError>> NmeaDecoder::push(std::uint8_t byte) {
  if (byte == '$') {
    const bool interrupted = state_ != State::kHunting;
    state_ = State::kBody;
    size_ = 0;
    sum_ = 0;
    if (interrupted) {
      return Unexpected{NmeaError::kInterrupted};
    }
    return std::nullopt;
  }
  switch (state_) {
    case State::kHunting:
      return std::nullopt;
    case State::kBody:
      return in_body(byte);
    case State::kChecksumHigh:
    case State::kChecksumLow:
      return in_checksum(byte);
    case State::kCarriageReturn:
    case State::kLineFeed:
      break;
  }
  return at_line_end(byte);
}

std::optional<Result<NmeaSentence, NmeaError>> NmeaDecoder::in_body(std::uint8_t byte) {
  if (byte == '*') {
    state_ = State::kChecksumHigh;
    return std::nullopt;
  }
  if (byte == '\r' || byte == '\n') {
    return drop(NmeaError::kMissingChecksum);
  }
  if (byte < 0x20 || byte > 0x7E) {
    return drop(NmeaError::kBadCharacter);
  }
  if (size_ == kMaxBody) {
    return drop(NmeaError::kTooLong);
  }
  body_[size_++] = static_cast<char>(byte);
  sum_ = static_cast<std::uint8_t>(sum_ ^ byte);
  return std::nullopt;
}

std::optional<Result<NmeaSentence, NmeaError>> NmeaDecoder::in_checksum(std::uint8_t byte) {
  if (byte == '\r' || byte == '\n') {
    return drop(NmeaError::kMissingChecksum);
  }
  const std::optional<std::uint8_t> digit = hex_digit(byte);
  if (!digit) {
    return drop(NmeaError::kBadChecksumDigit);
  }
  if (state_ == State::kChecksumHigh) {
    stated_sum_ = static_cast<std::uint8_t>(*digit << 4);
    state_ = State::kChecksumLow;
  } else {
    stated_sum_ = static_cast<std::uint8_t>(stated_sum_ | *digit);
    state_ = State::kCarriageReturn;
  }
  return std::nullopt;
}

std::optional<Result<NmeaSentence, NmeaError>> NmeaDecoder::at_line_end(std::uint8_t byte) {
  if (state_ == State::kCarriageReturn) {
    if (byte != '\r') {
      return drop(NmeaError::kBadLineEnd);
    }
    state_ = State::kLineFeed;
    return std::nullopt;
  }
  if (byte != '\n') {
    return drop(NmeaError::kBadLineEnd);
  }
  if (sum_ != stated_sum_) {
    return drop(NmeaError::kBadChecksum);
  }
  state_ = State::kHunting;
  return NmeaSentence{std::string_view{body_.data(), size_}};
}

Bytes encode_nmea(std::string_view body) {
  assert(body.size() <= kMaxBody);
  Bytes sentence;
  sentence.reserve(body.size() + kFrameCharacters);
  sentence.push_back('$');
  std::uint8_t sum = 0;
  for (const char c : body) {
    assert(c >= 0x20 && c <= 0x7E && c != '$' && c != '*');
    sentence.push_back(static_cast<std::uint8_t>(c));
    sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
  }
  const auto high = static_cast<std::uint8_t>(kHexDigits[sum >> 4]);
  const auto low = static_cast<std::uint8_t>(kHexDigits[sum & 0xFu]);
  sentence.insert(sentence.end(), {'*', high, low, '\r', '\n'});
  return sentence;
}

double Hdg::magnetic_deg() const {
  return in_full_circle(sensor_deg + deviation_east_deg.value_or(0.0));
}

Result<HeadingSentence, HeadingError> decode_heading(const NmeaSentence& sentence) {
  const std::string_view formatter = sentence.formatter();
  const NmeaFields fields = nmea_fields(sentence.body);
  if (formatter == "HDG") {
    return decode_hdg(fields);
  }
  if (formatter != "HDM" && formatter != "HDT") {
    return Unexpected{HeadingError::kNotAHeading};
  }
  if (fields.count != 3) {
    return Unexpected{HeadingError::kWrongFieldCount};
  }
  const bool magnetic = formatter == "HDM";
  if (fields.at[2] != (magnetic ? "M" : "T")) {
    return Unexpected{HeadingError::kBadReference};
  }
  const auto heading = parse_heading(fields.at[1]);
  if (!heading) {
    return Unexpected{heading.error()};
  }
  return magnetic ? HeadingSentence{Hdm{*heading}} : HeadingSentence{Hdt{*heading}};
}

Bytes encode_hdm(const Hdm& heading) {
  assert(std::isfinite(heading.magnetic_deg));
  const auto tenths = static_cast<int>(std::lround(in_full_circle(heading.magnetic_deg) * 10.0)) % 3600;
  std::array<char, 24> body{};
  constexpr std::string_view kAddress = "HCHDM,";
  char* end = std::copy(kAddress.begin(), kAddress.end(), body.data());
  end = std::to_chars(end, body.data() + body.size(), tenths / 10).ptr;
  *end++ = '.';
  *end++ = static_cast<char>('0' + tenths % 10);
  *end++ = ',';
  *end++ = 'M';
  return encode_nmea({body.data(), static_cast<std::size_t>(end - body.data())});
}

double yaw_rad_from_heading_deg(double heading_deg) {
  return wrap_angle(-rad_from_deg(heading_deg));
}

double heading_deg_from_yaw_rad(double yaw_rad) {
  return in_full_circle(-deg_from_rad(yaw_rad));
}

}  // namespace sensotwin::robot
