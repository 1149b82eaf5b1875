// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "robot/base/time.hpp"
#include "robot/wire/llrp/messages.hpp"

namespace sensotwin::robot {

struct UhfReaderConfig {
  /// Ports to read through, in the order of their turns, 1 the first; not empty.
  std::vector<std::uint16_t> antennas{1};
  /// 1: each read is reported by itself, at once. N: reports of N entries, or of what there is after
  /// `report_within`; reads of one tag through one antenna merge in them, and the channel told is that of the
  /// first while phase and time are of the last (data study, 3.9: 15.6 % wrong channels).
  std::uint16_t report_every{1};
  /// Only with report_every above 1. Chosen: two cycles of four antennas and the 50 channels' dwell (data
  /// study, 3.8).
  Duration report_within{std::chrono::milliseconds{200}};
  /// A reader without Impinj's extensions tells no phase. True: it is refused (kNoExtensions); false: its
  /// reads come with has_phase false.
  bool demand_impinj_extensions{true};
  std::optional<std::uint16_t> transmit_power_index{};  ///< row of the reader's table; none: its own default
  std::optional<std::uint16_t> rf_mode{};               ///< id of the reader's table; none: its own default
  std::optional<std::uint16_t> search_mode{};           ///< Impinj's; none: the reader's own
  /// C1G2 session and expected tags: what sllurp sends, and so what the logs of the data study were made
  /// with (protocols study, 2.9).
  std::uint8_t session{2};
  std::uint16_t tag_population{4};
  /// The reader is asked to say that it lives this often. Chosen.
  double keepalive_s{1.0};
  /// Silence for so many keepalives is a fault. Chosen: two may be lost.
  double silent_after_keepalives{2.5};
  /// How long a connected reader may take to greet. A real one does it at once (protocols study, 2.2); the
  /// set-up begins without a greeting then, as its sending may have been missed.
  Duration greeting_timeout{std::chrono::seconds{2}};
  /// sllurp and pyllrp wait 5 and 6 s (protocols study, 2.9).
  Duration request_timeout{std::chrono::seconds{5}};
  /// After a fault the set-up is tried again this much later, then twice as much later ... Chosen.
  Duration first_retry{std::chrono::milliseconds{500}};
  Duration last_retry{std::chrono::seconds{8}};
  /// A tag whose memory is wanted has to be read within this. Chosen: a cycle of 50 channels takes 10 s, but
  /// a tag in sight answers every 14 to 100 ms (data study, 3.8).
  Duration memory_timeout{std::chrono::seconds{2}};
};

/// The ids the driver gives to its ROSpec and AccessSpecs. Chosen.
inline constexpr std::uint32_t kRoSpecId = 1;
inline constexpr std::uint32_t kAccessSpecId = 1;

/// Reads through all antennas until it is deleted; starts by itself when it is enabled.
[[nodiscard]] llrp::RoSpec inventory_spec(const UhfReaderConfig& config, bool with_impinj);
/// Keepalives, and word of a ROSpec that ends.
[[nodiscard]] llrp::SetReaderConfig reader_settings(const UhfReaderConfig& config);
/// One operation, once, on the one tag with that EPC, told at once.
[[nodiscard]] llrp::AccessSpec memory_spec(const Epc& epc, const llrp::C1G2OpSpec& operation);
/// Frequencies by channel index, the first of index 1: of the first hop table, or of the fixed table of a
/// reader that does not hop. Empty when the capabilities tell none.
[[nodiscard]] std::vector<double> channels_hz(const llrp::GetReaderCapabilitiesResponse& capabilities);

}  // namespace sensotwin::robot
