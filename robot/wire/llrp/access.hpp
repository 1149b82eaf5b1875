// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "robot/wire/llrp/bit_array.hpp"
#include "robot/wire/llrp/custom.hpp"
#include "robot/wire/llrp/inventory.hpp"
#include "robot/wire/llrp/report_spec.hpp"

/// What to do with a tag once it answers: the AccessSpec, its operations and their results (LLRP 1.0.1, 11.2,
/// 15.2.1.3, 15.2.1.5.5).
namespace sensotwin::robot::llrp {

/// A tag is meant when its bits from `bit_pointer` on are `data` wherever `mask` is 1 (match), or are not. A
/// mask of no bits means every tag.
struct C1G2TargetTag {
  static constexpr std::uint16_t kType = 339;
  MemoryBank bank{};
  bool match{true};
  std::uint16_t bit_pointer{0};
  BitArray mask{};
  BitArray data{};
  bool operator==(const C1G2TargetTag&) const = default;
};
struct C1G2TagSpec {
  static constexpr std::uint16_t kType = 338;
  std::vector<C1G2TargetTag> targets{};  ///< one or two; a tag has to match all
  bool operator==(const C1G2TagSpec&) const = default;
};

struct C1G2Read {
  static constexpr std::uint16_t kType = 341;
  std::uint16_t op{0};
  std::uint32_t password{0};
  MemoryBank bank{};
  std::uint16_t word{0};
  std::uint16_t count{0};  ///< words; 0: to the end of the bank
  bool operator==(const C1G2Read&) const = default;
};
/// C1G2Write (342) and C1G2BlockWrite (347) look alike.
template <std::uint16_t Type>
struct C1G2Writing {
  static constexpr std::uint16_t kType = Type;
  std::uint16_t op{0};
  std::uint32_t password{0};
  MemoryBank bank{};
  std::uint16_t word{0};
  std::vector<std::uint16_t> data{};
  bool operator==(const C1G2Writing&) const = default;
};
using C1G2Write = C1G2Writing<342>;
using C1G2BlockWrite = C1G2Writing<347>;
struct C1G2Kill {
  static constexpr std::uint16_t kType = 343;
  std::uint16_t op{0};
  std::uint32_t password{0};
  bool operator==(const C1G2Kill&) const = default;
};
struct C1G2LockPayload {
  static constexpr std::uint16_t kType = 345;
  std::uint8_t privilege{0};   ///< 0 read/write, 1 permalock, 2 permaunlock, 3 unlock
  std::uint8_t data_field{0};  ///< 0 kill password, 1 access password, 2 EPC, 3 TID, 4 user
  bool operator==(const C1G2LockPayload&) const = default;
};
struct C1G2Lock {
  static constexpr std::uint16_t kType = 344;
  std::uint16_t op{0};
  std::uint32_t password{0};
  std::vector<C1G2LockPayload> payloads{};
  bool operator==(const C1G2Lock&) const = default;
};
struct C1G2BlockErase {
  static constexpr std::uint16_t kType = 346;
  std::uint16_t op{0};
  std::uint32_t password{0};
  MemoryBank bank{};
  std::uint16_t word{0};
  std::uint16_t count{0};
  bool operator==(const C1G2BlockErase&) const = default;
};
using C1G2OpSpec = std::variant<C1G2Read, C1G2Write, C1G2BlockWrite, C1G2Kill, C1G2Lock, C1G2BlockErase>;

struct AccessCommand {
  static constexpr std::uint16_t kType = 209;
  C1G2TagSpec tags{};
  std::vector<C1G2OpSpec> operations{};  ///< done in this order, up to the first that fails
  std::vector<CustomParameter> customs{};
  bool operator==(const AccessCommand&) const = default;
};
enum class AccessStop : std::uint8_t { kNull, kCount };
struct AccessSpecStopTrigger {
  static constexpr std::uint16_t kType = 208;
  AccessStop kind{};
  std::uint16_t count{0};  ///< operations done, then the AccessSpec is gone
  bool operator==(const AccessSpecStopTrigger&) const = default;
};
struct AccessSpec {
  static constexpr std::uint16_t kType = 207;
  std::uint32_t id{0};
  std::uint16_t antenna{0};  ///< 0: all
  std::uint8_t protocol{1};
  bool active{false};
  std::uint32_t ro_spec_id{0};  ///< 0: all
  AccessSpecStopTrigger stop{};
  AccessCommand command{};
  std::optional<AccessReportSpec> report{};
  std::vector<CustomParameter> customs{};
  bool operator==(const AccessSpec&) const = default;
};

enum class ReadResult : std::uint8_t { kSuccess, kTagError, kNoResponse, kReaderError };
enum class WriteResult : std::uint8_t {
  kSuccess,
  kMemoryOverrun,
  kMemoryLocked,
  kInsufficientPower,
  kTagError,
  kNoResponse,
  kReaderError
};
struct C1G2ReadResult {
  static constexpr std::uint16_t kType = 349;
  ReadResult result{};
  std::uint16_t op{0};
  std::vector<std::uint16_t> words{};
  bool operator==(const C1G2ReadResult&) const = default;
};
/// C1G2WriteOpSpecResult (350) and C1G2BlockWriteOpSpecResult (354).
template <std::uint16_t Type>
struct C1G2WritingResult {
  static constexpr std::uint16_t kType = Type;
  WriteResult result{};
  std::uint16_t op{0};
  std::uint16_t words_written{0};
  bool operator==(const C1G2WritingResult&) const = default;
};
using C1G2WriteResult = C1G2WritingResult<350>;
using C1G2BlockWriteResult = C1G2WritingResult<354>;
/// Kill (351), lock (352) and block erase (353) tell their code and nothing else.
template <std::uint16_t Type>
struct C1G2PlainResult {
  static constexpr std::uint16_t kType = Type;
  std::uint8_t result{0};
  std::uint16_t op{0};
  bool operator==(const C1G2PlainResult&) const = default;
};
using C1G2KillResult = C1G2PlainResult<351>;
using C1G2LockResult = C1G2PlainResult<352>;
using C1G2BlockEraseResult = C1G2PlainResult<353>;
using C1G2OpResult = std::variant<C1G2ReadResult, C1G2WriteResult, C1G2BlockWriteResult, C1G2KillResult,
                                  C1G2LockResult, C1G2BlockEraseResult>;

}  // namespace sensotwin::robot::llrp
