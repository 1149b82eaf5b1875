// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "robot/base/epc.hpp"
#include "robot/base/time.hpp"

namespace sensotwin::robot {

/// One reading of one tag through one antenna, as a UHF reader reports it.
struct UhfRead {
  Instant at;  ///< when the tag answered, on the robot's clock
  Epc epc;
  std::uint16_t antenna{1};  ///< port of the reader, 1 the first
  std::uint16_t channel{1};  ///< position in the reader's hop table, 1 the first; not a frequency
  double frequency_hz{0.0};  ///< what the hop table says of that channel
  /// As the reader measured it, in [0, 2 pi); whether it grows or falls with distance is the reader's matter
  /// (data study, 3.2: falls with a Speedway R420).
  double phase_rad{0.0};
  /// False when the reader did not tell a phase (no Impinj extensions): phase_rad is 0 then, and means
  /// nothing.
  bool has_phase{true};
  double rssi_dbm{0.0};
};

}  // namespace sensotwin::robot
