// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "robot/base/bytes.hpp"
#include "robot/hal/card_link.hpp"
#include "twin/serve/handle.hpp"
#include "twin/serve/tcp.hpp"
#include "twin/serve/wire.hpp"

namespace sensotwin::twin {

/// A card slot of the operating system, fed by way of vsmartcard's virtual reader vpcd: a driver within
/// pcscd that listens at a TCP port for whoever plays the card.
///
///     u16 length | bytes        both ways, big-endian; length 1 and 0, 1, 2, 4: power off, power on, reset,
///                               tell the ATR; anything else is a command APDU
///
/// pcscd has vpcd ask for the ATR every 0.4 s, to see whether a card is there. vpcd takes an answer of no
/// bytes for a reason to wait for ever (vpcd 3.3), so a card's absence is told by ending the connection. And
/// as a tag under a driving robot is there for half a second, an empty slot does not say so at once: it holds
/// its answer back for a second, so that most tags are seen the moment they come, as by a reader that reports
/// them by itself. A call that needs the empty reader waits as long.
class CardWire final : public Wire {
 public:
  /// What is known of vpcd at this port.
  enum class Peer : std::uint8_t {
    kUnknown,  ///< dialled, and not heard yet
    kAbsent,   ///< nobody listens there
    kSilent,   ///< somebody listens, and asks nothing: another card is in, or pcscd is stuck
    kServing,  ///< it has asked us
  };

  /// \param reader  the emulated one; must outlive the wire  \param vpcd  where its slot listens
  CardWire(std::string name, robot::CardLink& reader, Endpoint vpcd);

  [[nodiscard]] Peer peer() const { return peer_; }
  [[nodiscard]] const Endpoint& endpoint() const { return vpcd_; }
  /// vpcd has been told that there is a tag.
  [[nodiscard]] bool card_is_in() const { return told_in_; }
  /// pcscd knows what is in the field now and whoever asks it has had time to act on that: has spoken to a
  /// tag that came, or could have looked once more when one went. True too when nobody asks, or all have had
  /// time enough.
  [[nodiscard]] bool is_settled(double wall_s) const;
  /// Somebody has come to drive the robot: the tag that it stands on has not been spoken to by this client,
  /// who gets a second for it.
  void await_client(double wall_s);

 private:
  void do_watch(std::vector<pollfd>& handles) const override;
  void do_pump(double wall_s) override;
  [[nodiscard]] bool do_has_client() const override { return peer_ == Peer::kServing; }

  void look_at_field(double wall_s);
  void dial(double wall_s);
  void hang_up();
  void take_leave(double wall_s);
  void see_whether_noticed(double wall_s);
  void listen(double wall_s);
  /// \returns whether the whole of a message has come and was dealt with
  [[nodiscard]] bool take_message();
  void tell_atr(double wall_s);
  void obey(robot::ByteView message);
  void answer(robot::ByteView bytes);
  void finish_exchange();
  void send_rest();

  robot::CardLink& reader_;
  Endpoint vpcd_;
  Handle socket_;
  Handle left_;  ///< closed by us for a tag that has gone, until vpcd has seen it
  Peer peer_{Peer::kUnknown};
  bool present_{false};   ///< a tag is in the field
  bool heard_{false};     ///< vpcd has asked on this connection
  bool told_in_{false};   ///< and was told the ATR
  bool exchange_{false};  ///< an APDU is with the tag
  bool asked_{false};     ///< for an ATR, and not answered yet
  double asked_s_{0.0};
  bool spoken_to_{false};  ///< the tag in the field has had a command
  double changed_s_{0.0};  ///< when a tag came or went
  double noticed_s_{0.0};  ///< when pcscd was told of the last that came, or showed that it saw the last go
  double dialled_s_{0.0};
  double dial_again_s_{0.0};
  robot::Bytes in_;
  robot::Bytes out_;
};

/// What a contactless storage card of ISO 15693 part 3, ICODE SLI, is told to have answered to reset (PC/SC 2
/// part 3, supplement; pcsc-tools' list knows it as Philips ICode).
[[nodiscard]] robot::Bytes icode_sli_atr();

}  // namespace sensotwin::twin
