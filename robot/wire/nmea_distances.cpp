// SPDX-License-Identifier: MIT
#include "robot/wire/nmea_distances.hpp"

#include <cassert>
#include <cmath>
#include <string>

#include "robot/wire/nmea_fields.hpp"

namespace sensotwin::robot {
namespace {

constexpr std::size_t kGroup = 4;

std::optional<std::uint8_t> sonar_from(std::string_view name) {
  if (name.size() != 2 || name[0] != 'S' || name[1] < '0' || name[1] > '9') {
    return std::nullopt;
  }
  return static_cast<std::uint8_t>(name[1] - '0');
}

}  // namespace

Result<Distances, DistanceError> decode_distances(const NmeaSentence& sentence) {
  if (sentence.formatter() != "XDR") {
    return Unexpected{DistanceError::kNoDistances};
  }
  const NmeaFields fields = nmea_fields(sentence.body);
  if (fields.count < 1 + kGroup || (fields.count - 1) % kGroup != 0) {
    return Unexpected{DistanceError::kWrongFieldCount};
  }
  Distances found;
  for (std::size_t i = 1; i < fields.count; i += kGroup) {
    const std::optional<std::uint8_t> sonar = sonar_from(fields.at[i + 3]);
    if (fields.at[i] != "D" || !sonar || found.count == found.at.size()) {
      continue;
    }
    if (fields.at[i + 2] != "M") {
      return Unexpected{DistanceError::kBadUnit};
    }
    Distance distance{*sonar, std::nullopt};
    if (!fields.at[i + 1].empty()) {
      distance.metres = nmea_number(fields.at[i + 1]);
      if (!distance.metres) {
        return Unexpected{DistanceError::kBadNumber};
      }
    }
    found.at[found.count++] = distance;
  }
  return found;
}

Bytes encode_distances(std::span<const Distance> distances) {
  assert(distances.size() <= kDistancesEncoded);
  std::string body = "YXXDR";
  for (const Distance& distance : distances) {
    assert(distance.sonar <= 9);
    body += ",D,";
    if (distance.metres) {
      assert(*distance.metres >= 0.0 && *distance.metres < 99.995);
      const auto centimetres = static_cast<int>(std::lround(*distance.metres * 100.0));
      body += std::to_string(centimetres / 100) + "." + static_cast<char>('0' + centimetres / 10 % 10) +
              static_cast<char>('0' + centimetres % 10);
    }
    body += std::string(",M,S") + static_cast<char>('0' + distance.sonar);
  }
  return encode_nmea(body);
}

}  // namespace sensotwin::robot
