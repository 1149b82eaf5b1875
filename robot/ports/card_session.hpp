// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"

namespace sensotwin::robot {

/// What goes wrong with PC/SC, as far as one has to tell it apart.
enum class CardFault : std::uint8_t {
  kNoService,  ///< pcscd is not there, or went away
  kNoReader,   ///< no reader of that name is plugged in
  kNoCard,     ///< none in the field, or it left it
  kReset,      ///< another program reset the card: connect again
  kNoAnswer,   ///< the card or the reader did not answer in the reader's own time limit
  kOther,
};
/// For people, without full stop.
[[nodiscard]] const char* say(CardFault fault);

/// What a reader sees.
struct CardField {
  bool card{false};
  std::uint16_t changes{0};  ///< counts cards that came and went; 0 always where the service does not count
};

/// One program's talk with the PC/SC service about one card at a time. Calls wait for the service (an
/// exchange takes 10 to 30 ms), so a thread of its own makes them.
class CardSession {
 public:
  virtual ~CardSession() = default;
  virtual Result<std::vector<std::string>, CardFault> readers() = 0;
  virtual Result<CardField, CardFault> look(const std::string& reader) = 0;
  /// To the card in the reader's field. \returns true, or why not
  virtual Result<bool, CardFault> connect(const std::string& reader) = 0;
  virtual Result<Bytes, CardFault> transmit(ByteView command_apdu) = 0;
  /// Leaves the card as it is.
  virtual void disconnect() = 0;
};

/// Begins a session with the service, or says why there is none.
using CardService = std::function<Result<std::unique_ptr<CardSession>, CardFault>()>;

/// The service of this machine: pcscd.
[[nodiscard]] Result<std::unique_ptr<CardSession>, CardFault> begin_pcsc_session();

}  // namespace sensotwin::robot
