// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"
#include "robot/hal/card_link.hpp"
#include "robot/wire/storage_card.hpp"

namespace sensotwin::robot {

enum class WriteFailure : std::uint8_t {
  kTagLeft,       ///< the tag left the field, or another one took its place; its blocks may be torn
  kVerifyFailed,  ///< read back differently after the last attempt
  kRefused,       ///< the card said no, for good or in the last attempt; `status` says why
  kReaderGone,    ///< the reader was unplugged; the tag's blocks may be torn
  kTimeout,       ///< no answer in time, in the last attempt
};
struct WriteError {
  WriteFailure failure{WriteFailure::kVerifyFailed};
  StatusWord status{};  ///< of kRefused, else 9000
  bool operator==(const WriteError&) const = default;
};
struct WriteDone {
  int attempts{1};  ///< 1 when the first one held
  bool operator==(const WriteDone&) const = default;
};

/// The order of exchanges that puts bytes into one tag's memory and makes sure of it. A pure machine: it is
/// asked for the next command and told its answer; it knows no link and no time.
///
///     for each attempt:
///       for each piece of the data:  get UID (is it still this tag?), write the piece
///       for each piece of the data:  read the piece, compare
///       get UID (is it still this tag?)
///
/// A UID other than the one meant ends it as kTagLeft before anything is written to the stranger. A piece
/// that reads back differently, a memory failure (6581), a failed operation (6300) or a time-out costs one
/// attempt; any other status word is final.
class TagWrite {
 public:
  struct Job {
    TagUid uid{0};
    std::uint8_t first_block{0};
    Bytes data;  ///< a multiple of kBlockBytes, at least one block
    int attempts{3};
    std::uint8_t blocks_per_command{4};  ///< how many blocks this reader takes at once; at least 1
    UidOrder uid_order{UidOrder::kMsbFirst};
  };
  /// \pre job's fields are within what is said there
  explicit TagWrite(Job job);

  /// The command that is due; UpdateBinary's data is a view into this object, valid until the next call of
  /// answered(). \pre !outcome()
  [[nodiscard]] CardCommand command() const;
  /// The answer to command(). `response.data` is not kept.
  void answered(const CardResponse& response);
  /// command() brought no answer.
  void failed(CardError error);
  /// Set once it is over.
  [[nodiscard]] const std::optional<Result<WriteDone, WriteError>>& outcome() const { return outcome_; }
  [[nodiscard]] const Job& job() const { return job_; }

 private:
  enum class Stage : std::uint8_t { kIdentify, kUpdate, kReadBack, kIdentifyAgain };

  [[nodiscard]] ByteView piece() const;
  [[nodiscard]] bool last_piece() const;
  void advance(const CardResponse& response);
  void try_again(WriteError error);
  void end(WriteFailure failure, StatusWord status = {});

  Job job_;
  Stage stage_{Stage::kIdentify};
  std::size_t offset_{0};  ///< of the piece in hand, bytes
  int attempt_{1};
  std::optional<Result<WriteDone, WriteError>> outcome_;
};

}  // namespace sensotwin::robot
