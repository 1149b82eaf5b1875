// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "robot/base/random.hpp"
#include "robot/base/time.hpp"
#include "twin/devices/emulated_uhf_reader.hpp"
#include "twin/devices/radio_reading.hpp"
#include "twin/scene/scene.hpp"
#include "world/radio/radio.hpp"

namespace sensotwin::twin {

/// What a scene with ceiling tags has besides its Machine: the radio between tags and antennas, and the
/// emulated UHF reader that the antennas are plugged into. Neither copies nor moves.
class CeilingRadio {
 public:
  /// \param random  the run's; everything here forks from it by name  \pre scene.world.radio
  CeilingRadio(const Scene& scene, const robot::RandomStream& random);
  CeilingRadio(const CeilingRadio&) = delete;
  CeilingRadio& operator=(const CeilingRadio&) = delete;

  /// The robot has moved, tags are read on the way.
  void tick_world(const world::RobotMotion& motion);
  /// The reader hears of it, and says through which antennas to read next.
  void tick_devices(robot::Instant now);

  /// The radio of this run, its hop table included.
  [[nodiscard]] const world::RadioWorld& world() const { return radio_world_; }
  /// What the reader reported in the last tick, as the radio made it.
  [[nodiscard]] std::span<const RadioReading> readings() const { return readings_; }
  [[nodiscard]] EmulatedUhfReader& reader() { return reader_; }
  [[nodiscard]] const EmulatedUhfReader& reader() const { return reader_; }

 private:
  void follow_ro_spec(robot::Instant now);
  /// \returns false for one that a fault of the reader swallows
  [[nodiscard]] bool comes_through(RadioReading& reading);

  robot::RandomStream fault_random_;
  world::RadioWorld radio_world_;
  std::vector<std::vector<std::uint16_t>> user_memory_;  ///< of each ceiling tag
  world::Radio radio_;
  std::span<const world::RadioRead> heard_;
  std::vector<RadioReading> readings_;
  std::vector<std::uint16_t> ports_;  ///< that the radio reads through
  EmulatedUhfReader reader_;
};

}  // namespace sensotwin::twin
