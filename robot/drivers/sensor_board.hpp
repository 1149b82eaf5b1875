// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "robot/base/time.hpp"
#include "robot/hal/byte_link.hpp"
#include "robot/wire/nmea.hpp"
#include "robot/wire/nmea_distances.hpp"

namespace sensotwin::robot {

struct SensorBoardConfig {
  /// A reading older than this is no longer given. Chosen: five sentences missed at 10 Hz.
  Duration stale_after{std::chrono::milliseconds{500}};
  /// The rangefinder whose distance ends a round; the paper's robot has seven (Tsukiyama, section 4).
  std::uint8_t last_sonar{6};
};

struct CompassReading {
  /// Where the robot's forward axis points, counter-clockwise from magnetic north as seen from above, in
  /// (-pi, pi]: a REP-103 yaw in a frame whose x axis points north. NMEA's clockwise degrees end at the
  /// codec.
  double yaw_from_north_rad{0.0};
  Instant stamp{};  ///< step in which the sentence was complete
  Duration age{};   ///< at the last step
};

/// One round of the rangefinders that stand on the same board.
struct SonarRound {
  /// By the digit of their names, m; nothing: no echo, or not heard of for longer than a reading may be old.
  std::array<std::optional<double>, kSonarNames> range_m{};
  Instant stamp{};  ///< step in which the last of them was told
};

/// Counters since construction.
struct SensorBoardHealth {
  std::uint32_t headings{0};  ///< magnetic headings taken (HDM, HDG)
  std::uint32_t bad_checksum{0};
  std::uint32_t bad_frame{0};    ///< every other NmeaError
  std::uint32_t bad_heading{0};  ///< whole sentence, but no usable heading in it
  std::uint32_t not_ready{0};    ///< heading sentence with an empty heading
  std::uint32_t sonar_rounds{0};
  std::uint32_t bad_distances{0};  ///< whole sentence of distances, but not to be understood
  std::uint32_t other{0};       ///< sound sentences of other kinds (HDT: true north is not what we ask for)
  std::uint32_t went_stale{0};  ///< times a reading or a round grew too old
  std::uint32_t link_lost{0};
};

/// A board that talks NMEA 0183: a compass, and rangefinders where it has any.
class SensorBoard {
 public:
  /// `link` has to outlive the board.
  explicit SensorBoard(ByteLink& link, SensorBoardConfig config = {}) : link_(link), config_(config) {}

  /// Takes what has arrived; every 15 ms. \param now  never earlier than before
  void step(Instant now);
  /// The last heading; nothing before the first, and when it is stale.
  [[nodiscard]] const std::optional<CompassReading>& compass() const { return compass_; }
  /// The last round; nothing before the first, and when it is stale.
  [[nodiscard]] const std::optional<SonarRound>& sonars() const { return sonars_; }
  [[nodiscard]] const SensorBoardHealth& health() const { return health_; }

 private:
  void take(std::uint8_t byte);
  void take(const NmeaSentence& sentence);
  void take(const Distances& distances);

  ByteLink& link_;
  SensorBoardConfig config_;
  NmeaDecoder decoder_;
  Instant now_{};
  std::optional<CompassReading> compass_;
  std::array<std::optional<double>, kSonarNames> range_m_{};
  std::array<Instant, kSonarNames> ranged_at_{};
  std::optional<SonarRound> sonars_;
  bool was_up_{true};
  SensorBoardHealth health_;
};

}  // namespace sensotwin::robot
