// SPDX-License-Identifier: MIT
#include "twin/devices/emulated_sensor_board.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

#include "robot/wire/nmea.hpp"
#include "robot/wire/nmea_distances.hpp"

namespace sensotwin::twin {

EmulatedSensorBoard::EmulatedSensorBoard(const world::CompassDescription& description)
    : rate_hz_(description.rate_hz), due_(due()) {
  assert(rate_hz_ > 0.0);
}

robot::Instant EmulatedSensorBoard::due() const {
  // From the count, not by adding periods: rounding does not pile up.
  return robot::Instant{robot::from_s(static_cast<double>(sentences_ + 1) / rate_hz_)};
}

void EmulatedSensorBoard::step(robot::Instant now, double yaw_from_north_rad,
                               std::span<const std::optional<double>> ranges_m) {
  if (now < due_) {
    return;
  }
  while (due_ <= now) {
    ++sentences_;
    due_ = due();
  }
  if (!plugged_) {
    return;
  }
  say(robot::encode_hdm({robot::heading_deg_from_yaw_rad(yaw_from_north_rad)}));
  say_distances(ranges_m);
}

void EmulatedSensorBoard::say_distances(std::span<const std::optional<double>> ranges_m) {
  std::vector<robot::Distance> said;
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    said.push_back({static_cast<std::uint8_t>(i), ranges_m[i]});
    if (said.size() == robot::kDistancesEncoded || i + 1 == ranges_m.size()) {
      say(robot::encode_distances(said));
      said.clear();
    }
  }
}

void EmulatedSensorBoard::say(robot::ByteView sentence) {
  for (const std::uint8_t byte : sentence) {
    buffer_[(first_ + size_) % kBufferBytes] = byte;
    if (size_ == kBufferBytes) {
      first_ = (first_ + 1) % kBufferBytes;
    } else {
      ++size_;
    }
  }
}

void EmulatedSensorBoard::unplug() {
  plugged_ = false;
  size_ = 0;
}

bool EmulatedSensorBoard::do_write(robot::ByteView /*bytes*/) {
  return plugged_;  // the board takes no commands
}

std::size_t EmulatedSensorBoard::do_read(std::span<std::uint8_t> into) {
  const std::size_t n = std::min(into.size(), size_);
  for (std::size_t i = 0; i < n; ++i) {
    into[i] = buffer_[(first_ + i) % kBufferBytes];
  }
  first_ = (first_ + n) % kBufferBytes;
  size_ -= n;
  return n;
}

}  // namespace sensotwin::twin
