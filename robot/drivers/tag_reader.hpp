// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <variant>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"
#include "robot/base/time.hpp"
#include "robot/drivers/tag_write.hpp"
#include "robot/hal/card_link.hpp"
#include "robot/wire/storage_card.hpp"

namespace sensotwin::robot {

struct TagReaderConfig {
  UidOrder uid_order{UidOrder::kMsbFirst};
  /// Blocks read from each tag as soon as it is identified; 0 = none. Three hold each record of
  /// tag_record.hpp.
  std::uint8_t read_first_block{0};
  std::uint8_t read_blocks{3};
  /// Blocks in one READ or UPDATE BINARY: 1 for readers that pass single blocks only. Chosen: 4, a record.
  std::uint8_t blocks_per_command{4};
  int write_attempts{3};  ///< chosen: a quarter of the cut-off writes is torn, three in a row are 1.6 %
  /// An exchange without an answer is given up after this. Chosen: ten times the slowest exchange (30 ms).
  Duration exchange_limit{std::chrono::milliseconds{300}};
};

/// The tag over which the antenna stands.
struct TagInField {
  TagUid uid{0};
  Instant entered{};  ///< when its presence was first seen, before it was identified
  /// Bytes of the blocks asked for by the configuration, and what was written since; absent while they are
  /// being read (again after a failed write), and for good when the card refused (see ReaderHealth::refused)
  /// or none were asked for.
  std::optional<Bytes> data;
};

/// Something came into the field.
struct TagEntered {
  Instant stamp{};
};
/// It said its UID.
struct TagIdentified {
  TagUid uid{0};
  Instant stamp{};
};
/// It gave its data (tag()->data) or refused to: no more will come of itself.
struct TagDataRead {
  TagUid uid{0};
  Instant stamp{};
  StatusWord status{};  ///< 9000, or why there is no data
};
/// It left, with its UID when that had become known.
struct TagLeft {
  std::optional<TagUid> uid;
  Instant stamp{};
};
/// A write asked for by write() is over.
struct WriteOutcome {
  TagUid uid{0};
  std::uint8_t first_block{0};
  Result<WriteDone, WriteError> result{WriteDone{}};
  Instant stamp{};
};
using TagEvent = std::variant<TagEntered, TagIdentified, TagDataRead, TagLeft, WriteOutcome>;

/// Counters since construction.
struct ReaderHealth {
  bool connected{false};          ///< the reader was there at the last step
  std::uint32_t vanished{0};      ///< times the reader was unplugged
  std::uint32_t returned{0};      ///< times it came back
  std::uint32_t exchanges{0};     ///< begun
  std::uint32_t removed{0};       ///< exchanges that a leaving tag cut off
  std::uint32_t timeouts{0};      ///< exchanges without an answer
  std::uint32_t refused{0};       ///< answers to identification or reading with a status word other than 9000
  std::uint32_t malformed{0};     ///< answers without status word, of a wrong length, or without a UID
  std::uint32_t reversed_uid{0};  ///< of these, UIDs with E0 at the wrong end: uid_order is set wrongly
  std::uint32_t events_lost{0};   ///< events that nobody fetched
};

/// One HF reader: watches its field, identifies and reads what comes, writes on request and verifies.
/// One exchange at most is begun in a step.
class TagReader {
 public:
  /// `link` has to outlive the reader.
  explicit TagReader(CardLink& link, TagReaderConfig config = {});

  /// Goes on by one step; every 15 ms. \param now  never earlier than before
  void step(Instant now);

  /// The identified tag in the field. Valid until the next step.
  [[nodiscard]] const std::optional<TagInField>& tag() const { return tag_; }
  /// The oldest event not yet fetched. The last 64 are kept.
  [[nodiscard]] std::optional<TagEvent> next_event();

  /// Begins to write `data` from `first_block` on into the tag `uid`; the end is told by a WriteOutcome.
  /// \param data  whole blocks, at least one; copied
  /// \returns false, doing nothing, when a write is under way or `uid` is not the tag in the field
  [[nodiscard]] bool write(TagUid uid, std::uint8_t first_block, ByteView data);
  [[nodiscard]] bool writing() const { return write_.has_value(); }
  [[nodiscard]] const ReaderHealth& health() const { return health_; }

 private:
  /// What the answer under way is for. kNothing: none is under way; kDiscarded: whom it was for is gone.
  enum class Purpose : std::uint8_t { kNothing, kIdentify, kRead, kWrite, kDiscarded };
  using Answer = Result<Bytes, CardError>;

  void watch_link(CardPresence presence);
  void watch_field(CardPresence presence);
  void fetch_answer();
  void on_answer(Purpose purpose, const Answer& answer);
  void on_identified(const CardResponse& response);
  void on_read(const CardResponse& response);
  void finish_write();
  void begin_next();
  void begin(const CardCommand& command, Purpose purpose);
  /// What the next READ BINARY has to bring; 0 when all is there.
  [[nodiscard]] std::size_t read_piece_bytes() const;
  void forget_tag();
  void emit(const TagEvent& event);

  CardLink& link_;
  TagReaderConfig config_;
  Instant now_{};
  Purpose purpose_{Purpose::kNothing};
  Instant begun_{};                 ///< of the exchange under way
  std::optional<Instant> entered_;  ///< set while something is in the field
  std::optional<TagInField> tag_;
  Bytes reading_;  ///< data blocks received so far
  bool read_over_{false};
  std::optional<TagWrite> write_;
  std::deque<TagEvent> events_;
  ReaderHealth health_;
  bool ever_connected_{false};
};

}  // namespace sensotwin::robot
