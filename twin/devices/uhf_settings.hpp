// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robot/base/time.hpp"
#include "robot/wire/llrp/messages.hpp"

namespace sensotwin::twin {

/// What an emulated reader is. The defaults are an Impinj Speedway R420, FCC, on PoE (protocols study, 2.4).
struct UhfReaderSettings {
  /// Published hop table, in the order of hopping. Readers differ in theirs: give it the one of the radio.
  std::vector<double> channels_hz{915.25e6};
  std::uint16_t antennas{4};
  bool impinj_extensions{true};  ///< false: a reader that has never heard of Impinj
  /// Every ADD_ROSPEC is answered by a device error, as by a reader with a fault (an injected one).
  bool refuse_ro_specs{false};
  /// The reader's UTC clock when the robot's clock shows 0. Chosen: any date will do, nobody may rely on it.
  std::uint64_t utc_at_start_us{1'700'000'000'000'000};
  double clock_drift_ppm{0.0};  ///< its clock runs faster than the robot's by this
  /// From the reading that completes a report to its first byte on the wire.
  robot::Duration report_latency{};
  /// RSSI comes in such steps (protocols study, 2.6).
  double rssi_step_db{0.5};
  /// What the reader keeps for a client that does not take it; more reports than that are lost. Chosen: a
  /// minute of one tag at 70 reads a second.
  std::size_t buffer_bytes{512 * 1024};
  /// In-memory link: how long after a closed connection the client dials again. Chosen.
  robot::Duration redial_after{std::chrono::milliseconds{500}};
};

/// The answer to GET_READER_CAPABILITIES about everything, values of a recorded R420 (firmware 5.14.0.240)
/// with the hop table of the settings.
[[nodiscard]] robot::llrp::GetReaderCapabilitiesResponse uhf_capabilities(const UhfReaderSettings& settings);

/// The answer to GET_READER_CONFIG about everything, as of a reader fresh from the factory (recorded R420).
[[nodiscard]] robot::llrp::GetReaderConfigResponse uhf_factory_configuration(
    const UhfReaderSettings& settings);

}  // namespace sensotwin::twin
