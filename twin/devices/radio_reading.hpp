// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "robot/base/epc.hpp"
#include "robot/base/time.hpp"

namespace sensotwin::twin {

/// One answer of one tag as the radio model has it: what an emulated UHF reader is told.
struct RadioReading {
  robot::Instant at;
  robot::Epc epc;
  std::uint16_t antenna{1};  ///< port, 1 the first
  std::uint16_t channel{1};  ///< position in the hop table that the reader publishes, 1 the first
  double phase_rad{0.0};     ///< any turn
  double rssi_dbm{-60.0};
  double doppler_hz{0.0};
};

/// The user bank of a tag, 16-bit words to read and to write; empty when there is no such tag or no such
/// bank. Valid until the next call.
using UserMemory = std::function<std::span<std::uint16_t>(const robot::Epc&)>;

}  // namespace sensotwin::twin
