// SPDX-License-Identifier: MIT
#include <winscard.h>

#include <array>
#include <optional>
#include <utility>

#include "robot/ports/card_session.hpp"

namespace sensotwin::robot {
namespace {

CardFault fault_of(LONG code) {
  switch (code) {
    case SCARD_E_NO_SERVICE:
    case SCARD_E_SERVICE_STOPPED:
    case SCARD_E_INVALID_HANDLE:
    case SCARD_F_COMM_ERROR:
    case SCARD_F_INTERNAL_ERROR:
      return CardFault::kNoService;
    case SCARD_E_UNKNOWN_READER:
    case SCARD_E_READER_UNAVAILABLE:
    case SCARD_E_NO_READERS_AVAILABLE:
      return CardFault::kNoReader;
    case SCARD_E_NO_SMARTCARD:
    case SCARD_W_REMOVED_CARD:
    case SCARD_W_UNPOWERED_CARD:
    case SCARD_W_UNRESPONSIVE_CARD:
      return CardFault::kNoCard;
    case SCARD_W_RESET_CARD:
      return CardFault::kReset;
    case SCARD_E_TIMEOUT:
    case SCARD_E_NOT_TRANSACTED:
      return CardFault::kNoAnswer;
    default:
      return CardFault::kOther;
  }
}

class PcscSession : public CardSession {
 public:
  explicit PcscSession(SCARDCONTEXT context) : context_(context) {}
  PcscSession(const PcscSession&) = delete;
  PcscSession& operator=(const PcscSession&) = delete;
  ~PcscSession() override {
    PcscSession::disconnect();
    SCardReleaseContext(context_);
  }

  Result<std::vector<std::string>, CardFault> readers() override {
    // One string after the other, each ended by a zero, one zero more at the end.
    DWORD size = 0;
    LONG code = SCardListReaders(context_, nullptr, nullptr, &size);
    std::vector<char> text(code == SCARD_S_SUCCESS ? size : 0);
    if (!text.empty()) {
      code = SCardListReaders(context_, nullptr, text.data(), &size);
    }
    if (code == SCARD_E_NO_READERS_AVAILABLE) {
      return std::vector<std::string>{};
    }
    if (code != SCARD_S_SUCCESS) {
      return Unexpected{fault_of(code)};
    }
    std::vector<std::string> names;
    for (const char* at = text.data(); at < text.data() + size && *at != '\0';
         at += names.back().size() + 1) {
      names.emplace_back(at);
    }
    return names;
  }

  Result<CardField, CardFault> look(const std::string& reader) override {
    SCARD_READERSTATE state{};
    state.szReader = reader.c_str();
    state.dwCurrentState = SCARD_STATE_UNAWARE;
    const LONG code = SCardGetStatusChange(context_, 0, &state, 1);
    if (code != SCARD_S_SUCCESS && code != SCARD_E_TIMEOUT) {
      return Unexpected{fault_of(code)};
    }
    if ((state.dwEventState & (SCARD_STATE_UNKNOWN | SCARD_STATE_UNAVAILABLE)) != 0) {
      return Unexpected{CardFault::kNoReader};
    }
    return CardField{(state.dwEventState & SCARD_STATE_PRESENT) != 0,
                     static_cast<std::uint16_t>(state.dwEventState >> 16)};
  }

  Result<bool, CardFault> connect(const std::string& reader) override {
    disconnect();
    SCARDHANDLE card = 0;
    const LONG code = SCardConnect(context_, reader.c_str(), SCARD_SHARE_SHARED,
                                   SCARD_PROTOCOL_T0 | SCARD_PROTOCOL_T1, &card, &protocol_);
    if (code != SCARD_S_SUCCESS) {
      return Unexpected{fault_of(code)};
    }
    card_ = card;
    return true;
  }

  Result<Bytes, CardFault> transmit(ByteView command_apdu) override {
    if (!card_) {
      return Unexpected{CardFault::kNoCard};
    }
    std::array<std::uint8_t, MAX_BUFFER_SIZE> answer{};
    DWORD size = answer.size();
    const LONG code = SCardTransmit(*card_, protocol_ == SCARD_PROTOCOL_T0 ? SCARD_PCI_T0 : SCARD_PCI_T1,
                                    command_apdu.data(), command_apdu.size(), nullptr, answer.data(), &size);
    if (code != SCARD_S_SUCCESS) {
      return Unexpected{fault_of(code)};
    }
    return Bytes(answer.begin(), answer.begin() + static_cast<std::ptrdiff_t>(size));
  }

  void disconnect() override {
    if (card_) {
      SCardDisconnect(*card_, SCARD_LEAVE_CARD);
      card_.reset();
    }
  }

 private:
  SCARDCONTEXT context_;
  std::optional<SCARDHANDLE> card_;
  DWORD protocol_{0};
};

}  // namespace

Result<std::unique_ptr<CardSession>, CardFault> begin_pcsc_session() {
  SCARDCONTEXT context = 0;
  const LONG code = SCardEstablishContext(SCARD_SCOPE_SYSTEM, nullptr, nullptr, &context);
  if (code != SCARD_S_SUCCESS) {
    return Unexpected{fault_of(code)};
  }
  return std::unique_ptr<CardSession>{std::make_unique<PcscSession>(context)};
}

}  // namespace sensotwin::robot
