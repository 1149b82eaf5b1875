// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "robot/base/bytes.hpp"
#include "robot/base/random.hpp"
#include "robot/base/time.hpp"
#include "robot/hal/card_link.hpp"
#include "robot/wire/storage_card.hpp"
#include "world/description.hpp"
#include "world/tag_memory.hpp"

namespace sensotwin::twin {

struct CardReaderSettings {
  robot::Duration exchange{};          ///< from begin() to the answer
  robot::Duration latency{};           ///< from a tag's coming into the field to its answering
  double missed_share{0.0};            ///< of tags come upon that are not heard until they are left again
  double torn_write_probability{0.0};  ///< that a block cut off while it is programmed ends as a mixture
  robot::UidOrder uid_order{robot::UidOrder::kMsbFirst};
  /// The reader's own limit; an answer delayed beyond it becomes kTimeout. Chosen: CCID readers wait about 1
  /// s
  robot::Duration answer_limit{std::chrono::seconds{1}};
};
[[nodiscard]] CardReaderSettings card_reader_settings(const world::ReaderDescription& description);

/// A PC/SC reader of ISO 15693 tags in virtual time. The twin says what is in the field, the driver speaks
/// storage-card APDUs, and the answer is due one exchange later.
///
/// Model of an exchange: a command is carried out, and answered, at the instant it is due. Of an UPDATE
/// BINARY of n blocks, block i is programmed during the i-th n-th of the exchange. A tag that leaves between
/// two steps does so at an instant drawn uniformly between them; when that is before the answer is due, the
/// exchange ends as kRemoved, blocks programmed by then are new, later ones old, and the one being programmed
/// is torn with the stated probability (each bit old or new with equal chance), else old or new with equal
/// chance. A tag that takes another's place between two steps shows as an empty field once, as PC/SC reports
/// the removal. Leaves out: fading at the rim of the field (the read zone is a sharp disc), two tags in the
/// field at once.
///
/// Status words: 6A82 a block that does not exist, 6700 data that is not whole blocks, 6C04 a read that asks
/// for less than a block, 6282 a read beyond the last block, 6986 a locked block (nothing is written then),
/// 6C08 and 6282 a UID asked for with too small and too large Le.
class EmulatedCardReader final : public robot::CardLink {
 public:
  /// `random` is drawn from only when a tag leaves in mid-exchange.
  EmulatedCardReader(CardReaderSettings settings, robot::RandomStream random)
      : settings_(settings), random_(random) {}

  /// Time goes on to `now`; from now on `tag` (or nothing) is in the field. Costs a few comparisons when
  /// nothing is under way, and never allocates then. \param now  never earlier than before \param tag  has to
  /// live until another one is named
  void step(robot::Instant now, world::TagMemory* tag);

  /// The cable is pulled: presence() is kNoReader, an exchange under way is cut off as if the tag had left.
  void unplug();
  void replug() { plugged_ = true; }
  /// Every exchange begun from now on takes this much longer.
  void set_extra_delay(robot::Duration delay) { extra_delay_ = delay; }

 private:
  struct Exchange {
    robot::Instant begun{};
    robot::Instant due{};
    bool out_of_time{false};
  };

  robot::CardPresence do_presence() override;
  bool do_begin(robot::ByteView command_apdu) override;
  std::optional<robot::Result<robot::Bytes, robot::CardError>> do_poll() override;

  void complete();
  /// \param left_at  when the tag (or the reader) was lost; before the answer is due
  void cut_off(robot::Instant left_at, robot::CardError error);
  void tear(const robot::UpdateBinary& update, double done);
  [[nodiscard]] robot::Bytes carry_out();
  [[nodiscard]] robot::Bytes carry_out(const robot::GetUid& get) const;
  [[nodiscard]] robot::Bytes carry_out(const robot::ReadBinary& read) const;
  [[nodiscard]] robot::Bytes carry_out(const robot::UpdateBinary& update);
  /// 9000 when the update may be written.
  [[nodiscard]] robot::StatusWord check(const robot::UpdateBinary& update) const;

  CardReaderSettings settings_;
  robot::RandomStream random_;
  robot::Instant now_{};
  world::TagMemory* in_field_{nullptr};
  world::TagMemory* tag_{nullptr};  ///< that answers
  bool missed_{false};              ///< the one in the field does not
  robot::Instant answers_from_{};   ///< it does from then on
  bool plugged_{true};
  bool swapped_{false};  ///< another tag took the place of one, and nobody asked since
  robot::Duration extra_delay_{};
  robot::Bytes command_;  ///< of the exchange under way
  std::optional<Exchange> exchange_;
  std::optional<robot::Result<robot::Bytes, robot::CardError>> answer_;
};

}  // namespace sensotwin::twin
