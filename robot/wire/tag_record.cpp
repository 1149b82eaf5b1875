// SPDX-License-Identifier: MIT
#include "robot/wire/tag_record.hpp"

#include <algorithm>

namespace sensotwin::robot {
namespace {

constexpr std::uint8_t kCarpetMarker = 0x58;
constexpr std::uint8_t kCarpetVersion = 1;
constexpr std::uint8_t kObjectMarker = 0xFF;

/// A row of Table 1. The outlet's second byte is printed as "-": written as 0, not looked at.
struct LandmarkRow {
  LandmarkKind kind;
  std::uint8_t first;
  std::uint8_t second;
  bool second_matters{true};
};
constexpr std::array<LandmarkRow, 9> kTable1{{
    {LandmarkKind::kDoorOpeningSide, 0x01, 0x01},
    {LandmarkKind::kDoorFixedSide, 0x01, 0x00},
    {LandmarkKind::kFrontDoorOpeningSide, 0x81, 0x01},
    {LandmarkKind::kFrontDoorFixedSide, 0x81, 0x00},
    {LandmarkKind::kWindowLeft, 0x02, 0x01},
    {LandmarkKind::kWindowRight, 0x02, 0x00},
    {LandmarkKind::kPowerOutlet, 0x03, 0x00, false},
    {LandmarkKind::kClosetLeft, 0x04, 0x01},
    {LandmarkKind::kClosetRight, 0x04, 0x00},
}};

Result<TagRecord, TagRecordError> decode_carpet(ByteView memory) {
  if (memory.size() < kCarpetRecordBytes) {
    return Unexpected{TagRecordError::kTooShort};
  }
  // The version before the CRC: another version may keep its CRC elsewhere. A torn version byte is reported
  // as an unknown version, and is no less refused for it.
  if (memory[1] != kCarpetVersion) {
    return Unexpected{TagRecordError::kUnknownVersion};
  }
  if (crc16_iso13239(memory.first(kCarpetRecordBytes - 2)) != u16_from_be(memory[10], memory[11])) {
    return Unexpected{TagRecordError::kBadCrc};
  }
  const std::uint32_t map_id = (static_cast<std::uint32_t>(u16_from_be(memory[2], memory[3])) << 16) |
                               u16_from_be(memory[8], memory[9]);
  return TagRecord{
      CarpetRecord{map_id, s16_from_be(memory[4], memory[5]), s16_from_be(memory[6], memory[7])}};
}

Result<TagRecord, TagRecordError> decode_landmark(ByteView memory) {
  bool first_known = false;
  for (const LandmarkRow& row : kTable1) {
    if (row.first != memory[0]) {
      continue;
    }
    first_known = true;
    if (!row.second_matters || row.second == memory[1]) {
      return TagRecord{LandmarkRecord{row.kind}};
    }
  }
  return Unexpected{first_known ? TagRecordError::kUnknownLandmark : TagRecordError::kUnknownFormat};
}

}  // namespace

Result<TagRecord, TagRecordError> decode_tag_record(ByteView memory) {
  if (memory.size() < kLandmarkRecordBytes) {
    return Unexpected{TagRecordError::kTooShort};
  }
  if (std::all_of(memory.begin(), memory.end(), [](std::uint8_t b) { return b == 0; })) {
    return Unexpected{TagRecordError::kBlank};
  }
  if (memory[0] == kCarpetMarker) {
    return decode_carpet(memory);
  }
  if (memory[0] == kObjectMarker) {
    if (memory.size() < kObjectRecordBytes) {
      return Unexpected{TagRecordError::kTooShort};
    }
    return TagRecord{ObjectRecord{memory[4], memory[5], memory[6], memory[7]}};
  }
  return decode_landmark(memory);
}

std::array<std::uint8_t, kCarpetRecordBytes> encode(const CarpetRecord& record) {
  const auto id_high = static_cast<std::uint16_t>(record.map_id >> 16);
  const auto id_low = static_cast<std::uint16_t>(record.map_id & 0xFFFFu);
  const auto column = static_cast<std::uint16_t>(record.column);
  const auto row = static_cast<std::uint16_t>(record.row);
  std::array<std::uint8_t, kCarpetRecordBytes> memory{
      kCarpetMarker,    kCarpetVersion, high_byte(id_high), low_byte(id_high), high_byte(column),
      low_byte(column), high_byte(row), low_byte(row),      high_byte(id_low), low_byte(id_low)};
  const std::uint16_t crc = crc16_iso13239(ByteView{memory}.first(kCarpetRecordBytes - 2));
  memory[10] = high_byte(crc);
  memory[11] = low_byte(crc);
  return memory;
}

std::array<std::uint8_t, kLandmarkRecordBytes> encode(const LandmarkRecord& record) {
  const auto* row = std::find_if(kTable1.begin(), kTable1.end(),
                                 [&record](const LandmarkRow& r) { return r.kind == record.kind; });
  return {row->first, row->second, 0, 0};
}

std::array<std::uint8_t, kObjectRecordBytes> encode(const ObjectRecord& record) {
  return {kObjectMarker, 0, 0, 0, record.category, record.length, record.width, record.color};
}

std::uint16_t crc16_iso13239(ByteView bytes) {
  unsigned crc = 0xFFFFu;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 1u) != 0 ? (crc >> 1) ^ 0x8408u : crc >> 1;
    }
  }
  return static_cast<std::uint16_t>(~crc & 0xFFFFu);
}

}  // namespace sensotwin::robot
