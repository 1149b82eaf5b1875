// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace sensotwin::world {

/// One read of one ceiling tag, as the reader's chip measured it. Indices count from 0.
struct RadioRead {
  double time_s{0.0};        ///< when the tag answered
  std::uint32_t tag{0};      ///< in RadioWorld::tags
  std::uint16_t antenna{0};  ///< in RadioWorld::antennas; the reader's port is one more
  std::uint16_t channel{0};  ///< in RadioDescription::channels_hz; LLRP's ChannelIndex is one more
  double phase_rad{0.0};     ///< as reported, in [0, 2 pi): sign, flips and steps are the reader's
  double rssi_dbm{0.0};
  double doppler_hz{0.0};
  double distance_m{0.0};  ///< truth: from the antenna to the tag
  double error_rad{0.0};   ///< truth: what is not the way of the wave: noise, drift, echoes, flips
};

}  // namespace sensotwin::world
