// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "robot/base/bytes.hpp"

/// Settings of a reader that are parameters of their own (LLRP 1.0.1, 12.2).
namespace sensotwin::robot::llrp {

struct ConfigurationState {
  static constexpr std::uint16_t kType = 217;
  std::uint32_t value{0};
  bool operator==(const ConfigurationState&) const = default;
};
struct Identification {
  static constexpr std::uint16_t kType = 218;
  std::uint8_t kind{0};  ///< 0 MAC address (EUI-64), 1 EPC
  Bytes id{};
  bool operator==(const Identification&) const = default;
};
struct GpoWrite {
  static constexpr std::uint16_t kType = 219;
  std::uint16_t port{0};
  bool high{false};
  bool operator==(const GpoWrite&) const = default;
};
enum class KeepaliveTrigger : std::uint8_t { kNull, kPeriodic };
struct KeepaliveSpec {
  static constexpr std::uint16_t kType = 220;
  KeepaliveTrigger trigger{};
  std::uint32_t period_ms{0};
  bool operator==(const KeepaliveSpec&) const = default;
};
struct AntennaProperties {
  static constexpr std::uint16_t kType = 221;
  bool connected{false};
  std::uint16_t antenna{0};
  std::int16_t gain_centi_dbi{0};
  bool operator==(const AntennaProperties&) const = default;
};
enum class GpiState : std::uint8_t { kLow, kHigh, kUnknown };
struct GpiPortState {
  static constexpr std::uint16_t kType = 225;
  std::uint16_t port{0};
  bool enabled{false};
  GpiState state{};
  bool operator==(const GpiPortState&) const = default;
};
struct EventsAndReports {
  static constexpr std::uint16_t kType = 226;
  bool hold_upon_reconnect{false};
  bool operator==(const EventsAndReports&) const = default;
};

}  // namespace sensotwin::robot::llrp
