// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "robot/base/time.hpp"
#include "robot/hal/byte_link.hpp"
#include "world/description.hpp"

namespace sensotwin::twin {

/// A sensor board: a compass that says `$HCHDM,x.x,M*hh`, and rangefinders, where it has any, in `$YXXDR`
/// sentences, at a fixed rate, at instants k / rate of virtual time (k = 1, 2 ...), whatever the length of
/// the steps. It rounds to the tenth of a degree of its sentence, and to nothing else. Leaves out: the time
/// the sentence spends on the wire (18 bytes, 37 ms at 4800 baud, 5 ms at 38400).
class EmulatedSensorBoard final : public robot::ByteLink {
 public:
  explicit EmulatedSensorBoard(const world::CompassDescription& description);

  /// Time goes on to `now`. When a sentence has fallen due since the last step, one is sent.
  /// \param now  never earlier than before
  /// \param yaw_from_north_rad  what the sensor element measures now, noise and distortion included:
  ///   counter-clockwise from magnetic north
  /// \param ranges_m  of the rangefinders, left to right, at most ten; nothing inside: no echo
  void step(robot::Instant now, double yaw_from_north_rad,
            std::span<const std::optional<double>> ranges_m = {});

  /// Whether step(now, ...) would send a sentence: a reading need be measured only then.
  [[nodiscard]] bool is_due(robot::Instant now) const { return now >= due_; }

  void unplug();
  void replug() { plugged_ = true; }

 private:
  /// Two seconds of sentences at 10 Hz and more; what nobody reads by then is lost, oldest first.
  static constexpr std::size_t kBufferBytes = 512;

  bool do_write(robot::ByteView bytes) override;
  std::size_t do_read(std::span<std::uint8_t> into) override;
  [[nodiscard]] bool do_is_up() const override { return plugged_; }
  [[nodiscard]] robot::Instant due() const;
  void say(robot::ByteView sentence);
  void say_distances(std::span<const std::optional<double>> ranges_m);

  double rate_hz_;
  std::int64_t sentences_{0};  ///< whose instant has passed
  robot::Instant due_{};
  bool plugged_{true};
  std::array<std::uint8_t, kBufferBytes> buffer_{};  ///< ring
  std::size_t first_{0};
  std::size_t size_{0};
};

}  // namespace sensotwin::twin
