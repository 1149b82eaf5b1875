// SPDX-License-Identifier: MIT
#include "robot/wire/storage_card.hpp"

#include <algorithm>
#include <cassert>

namespace sensotwin::robot {
namespace {

constexpr std::uint8_t kStorageCardClass = 0xFF;
constexpr std::uint8_t kGetDataInstruction = 0xCA;
constexpr std::uint8_t kReadBinaryInstruction = 0xB0;
constexpr std::uint8_t kUpdateBinaryInstruction = 0xD6;
constexpr std::uint8_t kUidFirstByte = 0xE0;

struct StatusRow {
  std::uint16_t raw;
  CardStatus status;
  std::string_view text;
};
constexpr std::array<StatusRow, 16> kStatusTable{{
    {0x9000, CardStatus::kOk, "ok"},
    {0x6281, CardStatus::kDataMayBeCorrupt, "part of the returned data may be corrupted"},
    {0x6282, CardStatus::kEndReached, "end of memory reached"},
    {0x6300, CardStatus::kOperationFailed, "operation failed, no information given"},
    {0x6581, CardStatus::kMemoryFailure, "memory failure"},
    {0x6700, CardStatus::kWrongLength, "wrong length"},
    {0x6800, CardStatus::kClassNotSupported, "function in class byte not supported"},
    {0x6981, CardStatus::kCommandIncompatible, "command incompatible with the card"},
    {0x6982, CardStatus::kSecurityNotSatisfied, "security status not satisfied"},
    {0x6986, CardStatus::kCommandNotAllowed, "command not allowed"},
    {0x6A81, CardStatus::kFunctionNotSupported, "function not supported"},
    {0x6A82, CardStatus::kBlockNotFound, "addressed block does not exist"},
    {0x6B00, CardStatus::kWrongAddress, "wrong address"},
    {0x6D00, CardStatus::kInstructionNotSupported, "instruction not supported"},
    {0x6E00, CardStatus::kClassUnknown, "class not supported"},
    {0x6F00, CardStatus::kNoDiagnosis, "no precise diagnosis"},
}};
constexpr std::uint16_t kWrongExpectedLengthWord = 0x6C00;

void append_header(Bytes& apdu, std::uint8_t instruction, std::uint16_t p1_p2) {
  apdu.insert(apdu.end(), {kStorageCardClass, instruction, high_byte(p1_p2), low_byte(p1_p2)});
}

struct CommandEncoder {
  Bytes operator()(const GetUid& c) const {
    Bytes apdu;
    append_header(apdu, kGetDataInstruction, 0);
    apdu.push_back(c.expected_length);
    return apdu;
  }
  Bytes operator()(const ReadBinary& c) const {
    Bytes apdu;
    append_header(apdu, kReadBinaryInstruction, c.first_block);
    apdu.push_back(c.expected_length);
    return apdu;
  }
  Bytes operator()(const UpdateBinary& c) const {
    assert(!c.data.empty() && c.data.size() <= 255);
    Bytes apdu;
    apdu.reserve(5 + c.data.size());
    append_header(apdu, kUpdateBinaryInstruction, c.first_block);
    apdu.push_back(static_cast<std::uint8_t>(c.data.size()));
    apdu.insert(apdu.end(), c.data.begin(), c.data.end());
    return apdu;
  }
};

}  // namespace

CardStatus StatusWord::meaning() const {
  if (high_byte(raw) == high_byte(kWrongExpectedLengthWord)) {
    return CardStatus::kWrongExpectedLength;
  }
  const auto* row =
      std::find_if(kStatusTable.begin(), kStatusTable.end(), [this](const auto& r) { return r.raw == raw; });
  return row == kStatusTable.end() ? CardStatus::kUnknown : row->status;
}

StatusWord status_word(CardStatus status) {
  const auto* row = std::find_if(kStatusTable.begin(), kStatusTable.end(),
                                 [status](const auto& r) { return r.status == status; });
  assert(row != kStatusTable.end());
  return {row->raw};
}

StatusWord wrong_expected_length(std::uint8_t exact) {
  return {static_cast<std::uint16_t>(kWrongExpectedLengthWord | exact)};
}

std::string_view to_text(CardStatus status) {
  if (status == CardStatus::kWrongExpectedLength) {
    return "wrong expected length";
  }
  const auto* row = std::find_if(kStatusTable.begin(), kStatusTable.end(),
                                 [status](const auto& r) { return r.status == status; });
  return row == kStatusTable.end() ? "unknown status word" : row->text;
}

Bytes encode(const CardCommand& command) {
  return std::visit(CommandEncoder{}, command);
}

Result<CardCommand, CommandError> decode_command(ByteView apdu) {
  if (apdu.size() < 5) {
    return Unexpected{CommandError::kTooShort};
  }
  if (apdu[0] != kStorageCardClass) {
    return Unexpected{CommandError::kUnknownClass};
  }
  const std::uint16_t p1_p2 = u16_from_be(apdu[2], apdu[3]);
  const std::uint8_t length = apdu[4];
  switch (apdu[1]) {
    case kGetDataInstruction:
      if (p1_p2 != 0) {
        return Unexpected{CommandError::kWrongParameter};
      }
      if (apdu.size() != 5) {
        return Unexpected{CommandError::kWrongLength};
      }
      return CardCommand{GetUid{length}};
    case kReadBinaryInstruction:
      if (apdu.size() != 5) {
        return Unexpected{CommandError::kWrongLength};
      }
      return CardCommand{ReadBinary{p1_p2, length}};
    case kUpdateBinaryInstruction:
      if (length == 0 || apdu.size() != 5u + length) {
        return Unexpected{CommandError::kWrongLength};
      }
      return CardCommand{UpdateBinary{p1_p2, apdu.subspan(5)}};
    default:
      return Unexpected{CommandError::kUnknownInstruction};
  }
}

StatusWord status_word(CommandError error) {
  switch (error) {
    case CommandError::kUnknownClass:
      return status_word(CardStatus::kClassUnknown);
    case CommandError::kUnknownInstruction:
      return status_word(CardStatus::kInstructionNotSupported);
    case CommandError::kWrongParameter:
      return status_word(CardStatus::kFunctionNotSupported);
    case CommandError::kTooShort:
    case CommandError::kWrongLength:
      break;
  }
  return status_word(CardStatus::kWrongLength);
}

Result<CardResponse, ResponseError> decode_response(ByteView apdu) {
  if (apdu.size() < 2) {
    return Unexpected{ResponseError::kTooShort};
  }
  const std::size_t data_size = apdu.size() - 2;
  return CardResponse{apdu.first(data_size), {u16_from_be(apdu[data_size], apdu[data_size + 1])}};
}

Bytes encode(const CardResponse& response) {
  Bytes apdu;
  apdu.reserve(response.data.size() + 2);
  apdu.insert(apdu.end(), response.data.begin(), response.data.end());
  apdu.push_back(high_byte(response.status.raw));
  apdu.push_back(low_byte(response.status.raw));
  return apdu;
}

Result<TagUid, UidError> decode_uid(ByteView data, UidOrder order) {
  if (data.size() != 8) {
    return Unexpected{UidError::kWrongLength};
  }
  const bool msb_first = order == UidOrder::kMsbFirst;
  const std::uint8_t top = msb_first ? data.front() : data.back();
  const std::uint8_t bottom = msb_first ? data.back() : data.front();
  if (top != kUidFirstByte) {
    return Unexpected{bottom == kUidFirstByte ? UidError::kReversed : UidError::kNotIso15693};
  }
  TagUid uid = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    uid = (uid << 8) | data[msb_first ? i : 7 - i];
  }
  return uid;
}

std::array<std::uint8_t, 8> encode_uid(TagUid uid, UidOrder order) {
  std::array<std::uint8_t, 8> bytes{};
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t at = order == UidOrder::kLsbFirst ? i : 7 - i;
    bytes[at] = static_cast<std::uint8_t>(uid >> (8 * i));
  }
  return bytes;
}

}  // namespace sensotwin::robot
