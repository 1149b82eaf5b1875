// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "robot/hal/card_link.hpp"
#include "robot/ports/card_session.hpp"

namespace sensotwin::robot {

struct CardPortConfig {
  std::string reader;  ///< PC/SC name, as pcsc_scan shows it
  /// How often the field is looked at. Chosen: half a control step; a look is one question to pcscd, some
  /// 0.1 ms.
  std::chrono::milliseconds look_every{7};
  /// After pcscd went away, or the reader. Chosen.
  std::chrono::milliseconds retry_every{500};
};

/// A PC/SC reader as a CardLink. A thread of its own waits for the service; the calls of the link never do.
/// It survives a card that leaves in mid-exchange, a reader that is unplugged, and a pcscd that stops or
/// starts again: presence() is kNoReader until all of it is back.
class CardPort : public CardLink {
 public:
  CardPort(CardPortConfig config, CardService service);
  /// Waits for an exchange under way.
  ~CardPort() override;
  CardPort(const CardPort&) = delete;
  CardPort& operator=(const CardPort&) = delete;

  /// Why presence() is kNoReader, for people; empty when it is not, or before the first look.
  [[nodiscard]] std::string trouble() const;
  /// True once the field was looked at, or could not be.
  [[nodiscard]] bool was_tried() const;

 private:
  using Answer = Result<Bytes, CardError>;

  CardPresence do_presence() override;
  bool do_begin(ByteView command_apdu) override;
  std::optional<Answer> do_poll() override;

  void work();
  void look();
  void lose(CardFault fault);
  void set_field(const CardField& field);
  [[nodiscard]] Answer exchange(ByteView command_apdu);
  [[nodiscard]] Result<Bytes, CardFault> transmit(ByteView command_apdu);

  const CardPortConfig config_;
  const CardService service_;

  // The worker's alone.
  std::unique_ptr<CardSession> session_;
  bool connected_{false};
  std::optional<std::uint16_t> changes_;

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  // Both threads', under the mutex.
  bool ending_{false};
  bool tried_{false};
  CardPresence presence_{CardPresence::kNoReader};
  bool swapped_{false};  ///< one card left and another came between two looks
  std::string trouble_;
  std::optional<Bytes> command_;
  bool busy_{false};
  std::optional<Answer> answer_;

  std::thread worker_;  ///< last: begins when all else is there
};

}  // namespace sensotwin::robot
