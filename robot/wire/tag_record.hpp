// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <variant>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"

/// What SensoBot finds and writes in the memory of a tag.
///
///     carpet tag (ours)     block 0: 58 | 01 version | map id, bits 31..16    all numbers big-endian
///                           block 1: column s16      | row s16
///                           block 2: map id, 15..0   | CRC-16 of the ten bytes before it
///     wall-base tag         block 0: Table 1, two bytes | not used
///     tag on furniture      block 0: FF                 | not used
///                           block 1: category | length | width | colour
///
/// Source of the last two: SensoBot, section III.B, Tables 1 and 2 (units of length and width and the codes
/// of categories and colours are not given there; they stay numbers). The paper does not print the layout of
/// a carpet tag; ours is chosen so that
/// - no code of Table 1 begins with 58, nor does any bitwise mixture of a blank tag (zeros) and 58: its three
/// low
///   bits are clear, while each landmark code has one of them set. A torn first write never looks like a
///   door;
/// - the map id tells this run's coordinates from those of an older one;
/// - the CRC (ISO/IEC 13239, the one of ISO/IEC 15693-3 annex C: X.25, residue F0B8) finds what a cut-off
/// left.
namespace sensotwin::robot {

struct CarpetRecord {
  std::uint32_t map_id{0};  ///< one for each mapping session
  std::int16_t column{0};   ///< tile of the robot's own map M
  std::int16_t row{0};
  bool operator==(const CarpetRecord&) const = default;
};

/// SensoBot, Table 1. Left and right, opening and fixed side as seen from inside the room.
enum class LandmarkKind : std::uint8_t {
  kDoorOpeningSide,
  kDoorFixedSide,
  kFrontDoorOpeningSide,
  kFrontDoorFixedSide,
  kWindowLeft,
  kWindowRight,
  kPowerOutlet,
  kClosetLeft,
  kClosetRight,
};
struct LandmarkRecord {
  LandmarkKind kind{LandmarkKind::kPowerOutlet};
  bool operator==(const LandmarkRecord&) const = default;
};

/// SensoBot, Table 2 ("Dynamic Landmark").
struct ObjectRecord {
  std::uint8_t category{0};
  std::uint8_t length{0};
  std::uint8_t width{0};
  std::uint8_t color{0};
  bool operator==(const ObjectRecord&) const = default;
};

using TagRecord = std::variant<CarpetRecord, LandmarkRecord, ObjectRecord>;

/// Every record begins at block 0.
inline constexpr std::size_t kCarpetRecordBytes = 12;
inline constexpr std::size_t kLandmarkRecordBytes = 4;
inline constexpr std::size_t kObjectRecordBytes = 8;

enum class TagRecordError : std::uint8_t {
  kTooShort,         ///< fewer bytes than the record that the first byte announces
  kBlank,            ///< all zero: nobody has written here
  kUnknownFormat,    ///< the first byte is no code of ours or of Table 1
  kUnknownVersion,   ///< a carpet tag of a format that this program does not know
  kBadCrc,           ///< a carpet tag, but torn or altered
  kUnknownLandmark,  ///< first byte of Table 1, second byte not
};

/// \param memory  the tag's bytes from block 0 on; more than the record needs is allowed, and ignored
/// \returns the record or any TagRecordError
[[nodiscard]] Result<TagRecord, TagRecordError> decode_tag_record(ByteView memory);

[[nodiscard]] std::array<std::uint8_t, kCarpetRecordBytes> encode(const CarpetRecord& record);
[[nodiscard]] std::array<std::uint8_t, kLandmarkRecordBytes> encode(const LandmarkRecord& record);
[[nodiscard]] std::array<std::uint8_t, kObjectRecordBytes> encode(const ObjectRecord& record);

/// CRC-16 of ISO/IEC 13239: polynomial 8408 (reflected 1021), start FFFF, complemented; "123456789" gives
/// 906E.
[[nodiscard]] std::uint16_t crc16_iso13239(ByteView bytes);

}  // namespace sensotwin::robot
