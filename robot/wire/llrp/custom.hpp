// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "robot/base/bytes.hpp"

namespace sensotwin::robot::llrp {

/// Impinj's enterprise number (IANA), the vendor of its parameters and messages.
inline constexpr std::uint32_t kImpinj = 25882;

/// A parameter 1023 that the codec has no name for, kept as it came.
struct CustomParameter {
  static constexpr std::uint16_t kType = 1023;
  std::uint32_t vendor{0};
  std::uint32_t subtype{0};
  Bytes value{};
  bool operator==(const CustomParameter&) const = default;
};

/// What an Impinj parameter of one 16-bit number carries. `Subtype`: number in Impinj's definitions
/// (protocols study, 2.4 and 2.6).
template <std::uint32_t Subtype, class Number>
struct ImpinjNumber {
  static constexpr std::uint16_t kType = 1023;
  static constexpr std::uint32_t kImpinjSubtype = Subtype;
  Number value{0};
  bool operator==(const ImpinjNumber&) const = default;
};

using ImpinjSearchMode = ImpinjNumber<23, std::uint16_t>;  ///< 1 single target, 2 dual target, 3 TagFocus
using ImpinjEnableSerializedTid = ImpinjNumber<51, std::uint16_t>;  ///< 0 off, 1 on
using ImpinjEnablePhaseAngle = ImpinjNumber<52, std::uint16_t>;     ///< 0 off, 1 on
using ImpinjEnablePeakRssi = ImpinjNumber<53, std::uint16_t>;       ///< 0 off, 1 on
using ImpinjEnableDoppler = ImpinjNumber<67, std::uint16_t>;        ///< 0 off, 1 on
using ImpinjPhaseAngle = ImpinjNumber<56, std::uint16_t>;           ///< 0 to 4095: 4096 a turn
using ImpinjPeakRssi = ImpinjNumber<57, std::int16_t>;              ///< hundredths of a dBm
using ImpinjDopplerFrequency = ImpinjNumber<68, std::int16_t>;      ///< sixteenths of a hertz

}  // namespace sensotwin::robot::llrp
