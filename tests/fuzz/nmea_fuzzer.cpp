// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include "robot/base/geometry.hpp"
#include "robot/drivers/sensor_board.hpp"
#include "robot/wire/nmea.hpp"
#include "robot/wire/nmea_distances.hpp"
#include "tests/fuzz/fuzzers.hpp"
#include "tests/fuzz/harness.hpp"

namespace sensotwin::fuzz {
namespace {

using robot::Bytes;
using robot::ByteView;

/// What `$` to LF may hold between `$` and `*`.
constexpr std::size_t kMostBody = robot::kNmeaMaxCharacters - 6;

[[nodiscard]] bool is_heading(double deg) {
  return deg >= 0.0 && deg < 360.0;
}

void heading(const robot::NmeaSentence& sentence) {
  const auto decoded = robot::decode_heading(sentence);
  if (!decoded) {
    return;
  }
  double deg = 0.0;
  if (const auto* hdg = std::get_if<robot::Hdg>(&*decoded)) {
    require(is_heading(hdg->sensor_deg), "a heading lies in [0, 360)");
    require(std::abs(hdg->deviation_east_deg.value_or(0.0)) <= 180.0 &&
                std::abs(hdg->variation_east_deg.value_or(0.0)) <= 180.0,
            "deviation and variation lie within half a turn");
    deg = hdg->magnetic_deg();
  } else if (const auto* hdm = std::get_if<robot::Hdm>(&*decoded)) {
    deg = hdm->magnetic_deg;
  } else {
    deg = std::get<robot::Hdt>(*decoded).true_deg;
  }
  require(is_heading(deg), "a heading lies in [0, 360)");
  const double yaw_rad = robot::yaw_rad_from_heading_deg(deg);
  require(std::abs(yaw_rad) <= robot::kPi, "a yaw lies within half a turn");
  const double back_deg = robot::heading_deg_from_yaw_rad(yaw_rad);
  require(is_heading(back_deg) && std::abs(std::remainder(back_deg - deg, 360.0)) < 1e-9,
          "a heading made a yaw and back is the same");

  const Bytes written = robot::encode_hdm({deg});
  robot::NmeaDecoder decoder;
  bool heard = false;
  for (const std::uint8_t byte : written) {
    if (const auto outcome = decoder.push(byte)) {
      require(outcome->has_value(), "a heading that was written is heard");
      const auto again = robot::decode_heading(**outcome);
      require(
          again && std::abs(std::remainder(std::get<robot::Hdm>(*again).magnetic_deg - deg, 360.0)) < 0.0501,
          "a heading is written to a tenth of a degree");
      heard = true;
    }
  }
  require(heard, "a heading that was written is heard");
}

void distances(const robot::NmeaSentence& sentence) {
  const auto decoded = robot::decode_distances(sentence);
  if (!decoded) {
    return;
  }
  for (const robot::Distance& each : decoded->all()) {
    require(each.sonar < robot::kSonarNames, "a rangefinder has one of ten names");
    require(!each.metres || (*each.metres >= 0.0 && std::isfinite(*each.metres)), "a distance is a distance");
    if (each.metres && *each.metres >= 99.995) {
      continue;
    }
    const Bytes written = robot::encode_distances({&each, 1});
    const std::string body(written.begin() + 1, written.end() - 5);
    const auto again = robot::decode_distances({body});
    require(again && again->count == 1 && again->at[0].sonar == each.sonar &&
                again->at[0].metres.has_value() == each.metres.has_value() &&
                (!each.metres || std::abs(*again->at[0].metres - *each.metres) < 0.00501),
            "a distance is written to the centimetre");
  }
}

/// A sentence that was heard is written to one that is heard alike.
void sentences(ByteView input) {
  robot::NmeaDecoder decoder;
  for (const std::uint8_t byte : input) {
    const auto outcome = decoder.push(byte);
    if (!outcome || !*outcome) {
      continue;
    }
    const std::string body{(*outcome)->body};
    require(body.size() <= kMostBody, "a sentence has 82 characters at most");
    const Bytes written = robot::encode_nmea(body);
    robot::NmeaDecoder second;
    std::size_t heard = 0;
    for (const std::uint8_t again : written) {
      const auto one = second.push(again);
      heard += one && *one && (*one)->body == body ? 1u : 0u;
    }
    require(heard == 1, "a sentence heard, written and heard is the same");
    heading({body});
    distances({body});
  }
}

/// The same bytes as the body of a sentence with the right sum, so that mutations reach the fields.
void as_body(ByteView input) {
  std::string body;
  for (const std::uint8_t byte : input.first(std::min(input.size(), kMostBody))) {
    const bool may_stand = byte >= 0x20 && byte <= 0x7E && byte != '$' && byte != '*';
    body += may_stand ? static_cast<char>(byte) : ',';
  }
  heading({body});
  distances({body});
  sentences(robot::encode_nmea(body));
}

void driver(ByteView input, std::size_t piece) {
  ScriptedLink link;
  robot::SensorBoard board{link};
  robot::Instant now{};
  for (Script script{input}; !script.empty(); now += robot::kTick) {
    link.say(script.bytes(piece));
    board.step(now);
    require(!board.compass() || std::abs(board.compass()->yaw_from_north_rad) <= robot::kPi,
            "a reading is an angle");
  }
  require(link.heard().empty(), "nothing is said to a sensor board");
}

}  // namespace

void nmea(ByteView input) {
  Script script{input};
  const std::size_t piece = 1u + script.byte() % 128u;
  sentences(script.rest());
  as_body(script.rest());
  driver(script.rest(), piece);
}

}  // namespace sensotwin::fuzz
