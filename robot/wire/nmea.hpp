// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"

/// NMEA 0183: sentences, and the three that carry a heading.
///
///     $ | talker, 2 letters | formatter, 3 letters | , field ... | * | checksum, 2 hex digits | CR LF
///
/// The checksum is the exclusive or of the characters between $ and *. At most 82 characters, $ and CR LF
/// included. Headings run clockwise from north in degrees, 0.0 <= x < 360.0; a yaw of REP-103 runs
/// counter-clockwise in radians, and the two functions at the end are the only place where one becomes the
/// other. Source: NMEA 0183, 2.x to 4.x, sections 5.2 and 5.3 and sentences HDG, HDM, HDT.
namespace sensotwin::robot {

/// `$` to LF.
inline constexpr std::size_t kNmeaMaxCharacters = 82;

/// A verified sentence: its characters between $ and *.
struct NmeaSentence {
  std::string_view body;  ///< "HCHDM,238.5,M"

  /// "HC"; empty when the address is shorter than five characters.
  [[nodiscard]] std::string_view talker() const;
  /// "HDM"; empty when the address is not five characters long.
  [[nodiscard]] std::string_view formatter() const;
};

enum class NmeaError : std::uint8_t {
  kTooLong,           ///< no CR LF within 82 characters
  kInterrupted,       ///< a new $ before the end; the new sentence is followed
  kBadCharacter,      ///< not printable ASCII (20 to 7E)
  kMissingChecksum,   ///< line ended without * and two characters
  kBadChecksumDigit,  ///< after * not two hexadecimal digits
  kBadChecksum,       ///< complete but corrupt
  kBadLineEnd,        ///< something else than CR LF behind the checksum
};

/// Rebuilds sentences from single bytes. Never allocates, never blocks; after an error it hunts for the next
/// $.
class NmeaDecoder {
 public:
  /// Feeds one byte.
  /// \returns nothing while hunting or while a sentence is incomplete; else the sentence (valid until the
  /// next push), or why it was dropped: any NmeaError
  [[nodiscard]] std::optional<Result<NmeaSentence, NmeaError>> push(std::uint8_t byte);
  /// Forgets a sentence begun, as after a cut link.
  void reset() { state_ = State::kHunting; }

 private:
  enum class State : std::uint8_t {
    kHunting,
    kBody,
    kChecksumHigh,
    kChecksumLow,
    kCarriageReturn,
    kLineFeed
  };

  std::optional<Result<NmeaSentence, NmeaError>> drop(NmeaError error);
  std::optional<Result<NmeaSentence, NmeaError>> in_body(std::uint8_t byte);
  std::optional<Result<NmeaSentence, NmeaError>> in_checksum(std::uint8_t byte);
  std::optional<Result<NmeaSentence, NmeaError>> at_line_end(std::uint8_t byte);

  State state_{State::kHunting};
  std::array<char, kNmeaMaxCharacters> body_{};
  std::size_t size_{0};
  std::uint8_t sum_{0};
  std::uint8_t stated_sum_{0};
};

/// Frames `body` as a sentence: $ body * checksum CR LF. \pre at most 76 printable characters, no $ or *
[[nodiscard]] Bytes encode_nmea(std::string_view body);

/// Heading to the magnetic north, from a compass that knows nothing of deviation.
struct Hdm {
  double magnetic_deg{0.0};
};
/// What the sensor reads, and what to add. East is positive; empty fields mean "not known".
struct Hdg {
  double sensor_deg{0.0};
  std::optional<double> deviation_east_deg;
  std::optional<double> variation_east_deg;

  /// Sensor heading plus deviation, in [0, 360). An unknown deviation counts as 0.
  [[nodiscard]] double magnetic_deg() const;
};
/// Heading to the true north.
struct Hdt {
  double true_deg{0.0};
};
using HeadingSentence = std::variant<Hdm, Hdg, Hdt>;

enum class HeadingError : std::uint8_t {
  kNotAHeading,      ///< another sentence (or a proprietary one)
  kWrongFieldCount,  ///< HDM and HDT have two fields, HDG five
  kNoHeading,        ///< the heading's field is empty: the compass has none yet
  kBadNumber,        ///< not digits with at most one point
  kOutOfRange,       ///< heading not in [0, 360), deviation or variation above 180
  kBadReference,     ///< not M, T, E or W where it has to be
};
/// \returns the heading, or any HeadingError
[[nodiscard]] Result<HeadingSentence, HeadingError> decode_heading(const NmeaSentence& sentence);

/// `$HCHDM,x.x,M*hh`, rounded to a tenth of a degree; any finite angle is taken into [0, 360).
[[nodiscard]] Bytes encode_hdm(const Hdm& heading);

/// Counter-clockwise from north in (-pi, pi] from clockwise degrees.
[[nodiscard]] double yaw_rad_from_heading_deg(double heading_deg);
/// Clockwise degrees in [0, 360) from counter-clockwise radians.
[[nodiscard]] double heading_deg_from_yaw_rad(double yaw_rad);

}  // namespace sensotwin::robot
