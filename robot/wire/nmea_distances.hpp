// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"
#include "robot/wire/nmea.hpp"

/// NMEA 0183 XDR, transducer measurements, of rangefinders:
///
///     $YXXDR,D,1.24,M,S0,D,,M,S1*hh
///
/// Groups of four fields: D for displacement, metres, M, and the transducer's name. An empty number is a
/// rangefinder that hears no echo. Other transducers may stand between them (C a temperature, P a pressure
/// ...). Source: NMEA 0183, 4.x, sentence XDR; the names S0 to S9 are ours, counted from the left of the
/// robot to its right.
namespace sensotwin::robot {

/// The most that one sentence is taken apart for: a group has at least eight characters, D,,M,S0 and a comma.
inline constexpr std::size_t kDistancesPerSentence = 9;

/// S0 to S9.
inline constexpr std::size_t kSonarNames = 10;

/// One rangefinder's word.
struct Distance {
  std::uint8_t sonar{0};           ///< the digit of its name
  std::optional<double> metres{};  ///< none: no echo
};

/// What one sentence says; a plain array, for nothing allocates on the way of bytes.
struct Distances {
  std::array<Distance, kDistancesPerSentence> at{};
  std::size_t count{0};

  [[nodiscard]] std::span<const Distance> all() const { return {at.data(), count}; }
};

enum class DistanceError : std::uint8_t {
  kNoDistances,      ///< another sentence
  kWrongFieldCount,  ///< fields do not come in fours
  kBadNumber,        ///< not digits with at most one point
  kBadUnit,          ///< a displacement of S0 to S9 that is not in metres
};
/// \returns the distances among the sentence's transducers, in its order, perhaps none; or any DistanceError
[[nodiscard]] Result<Distances, DistanceError> decode_distances(const NmeaSentence& sentence);

/// How many distances one sentence of 82 characters holds at "D,4.99,M,S0".
inline constexpr std::size_t kDistancesEncoded = 5;
/// `$YXXDR,D,x.xx,M,Sn,...*hh`, rounded to the centimetre. \pre at most kDistancesEncoded; sonar 0 to 9;
/// metres in [0, 99.995)
[[nodiscard]] Bytes encode_distances(std::span<const Distance> distances);

}  // namespace sensotwin::robot
