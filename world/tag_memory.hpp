// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>

namespace sensotwin::world {

/// The chip of one ISO 15693 tag: what a reader in reach finds in it. Its place is the world's business.
/// Size: ICODE SLI (NXP SL2ICS20 data sheet): 28 blocks of 4 bytes for the user, each lockable for good.
struct TagMemory {
  static constexpr std::size_t kBlocks = 28;
  using Block = std::array<std::uint8_t, 4>;

  std::uint64_t uid{0};  ///< E0 in the most significant byte
  std::array<Block, kBlocks> blocks{};
  std::bitset<kBlocks> locked;  ///< refuses to be written
};

/// UID of the `serial`-th tag of a world: E0, 04 (NXP, ISO/IEC 7816-6), 01 (ICODE SLI), 40-bit serial number.
[[nodiscard]] constexpr std::uint64_t icode_sli_uid(std::uint64_t serial) {
  return 0xE004'0100'0000'0000u | (serial & 0xFF'FFFF'FFFFu);
}

}  // namespace sensotwin::world
