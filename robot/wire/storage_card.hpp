// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <variant>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"
#include "robot/base/tag_uid.hpp"

/// Storage-card command set of PC/SC Part 3 ("Supplemental Document for Contactless ICCs", 2.02.00, April
/// 2010, section 3.2.2), as far as ISO/IEC 15693 tags need it. Both directions: the driver encodes commands
/// and decodes responses, an emulated reader does the opposite.
///
///     command   CLA | INS | P1 P2         | Lc, data | Le
///     get UID   FF  | CA  | 00 00         |          | 00 (all) or 08
///     read      FF  | B0  | block, 16 bit |          | bytes, 00 = 256
///     write     FF  | D6  | block, 16 bit | Lc, data |
///     response  data | SW1 SW2
///
/// P1 P2 are "address MSB, address LSB", and the address of an ISO 15693 card is its block number. (Windows'
/// own NFC driver, unlike CCID readers, documents the block number in P1: learn.microsoft.com, dn905578.)
namespace sensotwin::robot {

/// Bytes of a block of ICODE SLI and Tag-it HFI (NXP SL2ICS20, Texas Instruments RI-I11: 32 bits).
inline constexpr std::size_t kBlockBytes = 4;

/// In which order a reader delivers the eight bytes of a UID: readers do not agree. The air interface sends
/// the least significant byte first (ISO/IEC 15693-3, section 4.1); some pass that on with E0 last, others
/// turn it to the order in which UIDs are printed, E0 first. No rule on the bytes tells them apart: a tag's
/// serial number may itself end in E0. So it is a setting of the reader; the wrong one is reported as
/// kReversed.
enum class UidOrder : std::uint8_t { kMsbFirst, kLsbFirst };

/// What SW1 SW2 say; texts of ISO/IEC 7816-4 as PC/SC Part 3 uses them.
enum class CardStatus : std::uint8_t {
  kOk,                       ///< 9000
  kDataMayBeCorrupt,         ///< 6281 part of the returned data may be corrupted
  kEndReached,               ///< 6282 end of memory before Le bytes; what there was is returned
  kOperationFailed,          ///< 6300 no information given
  kMemoryFailure,            ///< 6581 writing was unsuccessful
  kWrongLength,              ///< 6700
  kClassNotSupported,        ///< 6800
  kCommandIncompatible,      ///< 6981
  kSecurityNotSatisfied,     ///< 6982
  kCommandNotAllowed,        ///< 6986
  kFunctionNotSupported,     ///< 6A81
  kBlockNotFound,            ///< 6A82 addressed block or byte does not exist
  kWrongAddress,             ///< 6B00 wrong parameter P1 P2
  kWrongExpectedLength,      ///< 6Cxx wrong Le; xx is the right one
  kInstructionNotSupported,  ///< 6D00
  kClassUnknown,             ///< 6E00
  kNoDiagnosis,              ///< 6F00
  kUnknown,                  ///< any other word
};

/// The two trailing bytes of a response.
struct StatusWord {
  std::uint16_t raw{0x9000};

  [[nodiscard]] CardStatus meaning() const;
  [[nodiscard]] bool ok() const { return raw == 0x9000; }
  /// The length to ask for instead. \pre meaning() == kWrongExpectedLength
  [[nodiscard]] std::uint8_t exact_length() const { return low_byte(raw); }
  bool operator==(const StatusWord&) const = default;
};
/// The status word of a meaning. \pre status is neither kWrongExpectedLength nor kUnknown
[[nodiscard]] StatusWord status_word(CardStatus status);
/// 6Cxx. A length of 256 is spelt 0.
[[nodiscard]] StatusWord wrong_expected_length(std::uint8_t exact);
/// English text for logs and reports; static.
[[nodiscard]] std::string_view to_text(CardStatus status);

struct GetUid {
  std::uint8_t expected_length{0};  ///< Le: 0 = all
  bool operator==(const GetUid&) const = default;
};
struct ReadBinary {
  std::uint16_t first_block{0};
  std::uint8_t expected_length{0};  ///< Le: bytes, 0 = 256
  bool operator==(const ReadBinary&) const = default;
};
struct UpdateBinary {
  std::uint16_t first_block{0};
  ByteView data;  ///< 1 to 255 bytes
};
using CardCommand = std::variant<GetUid, ReadBinary, UpdateBinary>;

/// The command APDU. \pre UpdateBinary: 1 to 255 bytes of data
[[nodiscard]] Bytes encode(const CardCommand& command);

enum class CommandError : std::uint8_t {
  kTooShort,            ///< fewer than five bytes
  kUnknownClass,        ///< CLA is not FF
  kUnknownInstruction,  ///< INS is none of CA, B0, D6
  kWrongParameter,      ///< GET DATA of something else than the UID
  kWrongLength,         ///< Lc or Le do not fit the length of the APDU
};
/// What an emulated reader does with a command APDU. The data of UpdateBinary is a view into `apdu`.
/// \returns the command, or any CommandError
[[nodiscard]] Result<CardCommand, CommandError> decode_command(ByteView apdu);
/// The status word with which a reader answers a command that it could not read.
[[nodiscard]] StatusWord status_word(CommandError error);

struct CardResponse {
  ByteView data;
  StatusWord status;
};
enum class ResponseError : std::uint8_t { kTooShort };  ///< no room for SW1 SW2
/// Splits a response APDU; `data` is a view into `apdu`. \returns kTooShort below two bytes
[[nodiscard]] Result<CardResponse, ResponseError> decode_response(ByteView apdu);
/// The response APDU.
[[nodiscard]] Bytes encode(const CardResponse& response);

enum class UidError : std::uint8_t {
  kWrongLength,  ///< not eight bytes
  kReversed,     ///< E0 stands at the other end only: the reader's UidOrder is set wrongly
  kNotIso15693,  ///< no E0 at either end
};
/// The UID in the data of a response to GetUid. \returns the UID or any UidError
[[nodiscard]] Result<TagUid, UidError> decode_uid(ByteView data, UidOrder order);
[[nodiscard]] std::array<std::uint8_t, 8> encode_uid(TagUid uid, UidOrder order);

}  // namespace sensotwin::robot
