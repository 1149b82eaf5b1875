// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"

namespace sensotwin::robot {

/// Why an exchange with a card brought no answer. The words follow winscard's return codes.
enum class CardError : std::uint8_t {
  kRemoved,     ///< the card left the field before it answered (SCARD_W_REMOVED_CARD)
  kReaderGone,  ///< the reader was unplugged (SCARD_E_READER_UNAVAILABLE)
  kTimeout,     ///< the reader gave no answer in its own time limit (SCARD_E_TIMEOUT)
};

/// What is in the reader's field now (SCardGetStatusChange).
enum class CardPresence : std::uint8_t { kNoReader, kEmpty, kPresent };

/// One PC/SC card slot. An exchange takes milliseconds, so it is begun and then asked for: on the machine a
/// worker waits in SCardTransmit, in the twin the answer is due at a simulated instant.
class CardLink {
 public:
  virtual ~CardLink() = default;
  [[nodiscard]] CardPresence presence() { return do_presence(); }
  /// Sends one command APDU to the card in the field. \returns false, sending nothing, when an exchange is
  /// still under way, or there is no card or no reader.
  [[nodiscard]] bool begin(ByteView command_apdu) { return do_begin(command_apdu); }
  /// The outcome of the exchange that was begun, once: the response APDU (data, SW1, SW2), or the reason why
  /// there is none; nothing while it is under way or when none was begun.
  [[nodiscard]] std::optional<Result<Bytes, CardError>> poll() { return do_poll(); }

 private:
  virtual CardPresence do_presence() = 0;
  virtual bool do_begin(ByteView command_apdu) = 0;
  virtual std::optional<Result<Bytes, CardError>> do_poll() = 0;
};

}  // namespace sensotwin::robot
