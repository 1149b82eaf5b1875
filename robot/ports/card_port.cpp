// SPDX-License-Identifier: MIT
#include "robot/ports/card_port.hpp"

#include <utility>

namespace sensotwin::robot {

const char* say(CardFault fault) {
  switch (fault) {
    case CardFault::kNoService:
      return "pcscd does not answer";
    case CardFault::kNoReader:
      return "no such PC/SC reader";
    case CardFault::kNoCard:
      return "no card in the field";
    case CardFault::kReset:
      return "another program reset the card";
    case CardFault::kNoAnswer:
      return "no answer";
    case CardFault::kOther:
      break;
  }
  return "PC/SC failed";
}

CardPort::CardPort(CardPortConfig config, CardService service)
    : config_(std::move(config)), service_(std::move(service)), worker_([this] { work(); }) {}

CardPort::~CardPort() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_one();
  worker_.join();
}

std::string CardPort::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

bool CardPort::was_tried() const {
  const std::lock_guard lock(mutex_);
  return tried_;
}

CardPresence CardPort::do_presence() {
  const std::lock_guard lock(mutex_);
  if (std::exchange(swapped_, false)) {
    return CardPresence::kEmpty;
  }
  return presence_;
}

bool CardPort::do_begin(ByteView command_apdu) {
  {
    const std::lock_guard lock(mutex_);
    if (busy_ || swapped_ || presence_ != CardPresence::kPresent) {
      return false;
    }
    command_ = Bytes(command_apdu.begin(), command_apdu.end());
    busy_ = true;
    answer_.reset();
  }
  wake_.notify_one();
  return true;
}

std::optional<CardPort::Answer> CardPort::do_poll() {
  const std::lock_guard lock(mutex_);
  if (!answer_) {
    return std::nullopt;
  }
  busy_ = false;
  return std::exchange(answer_, std::nullopt);
}

void CardPort::work() {
  std::unique_lock lock(mutex_);
  while (!ending_) {
    if (command_) {
      const Bytes command = *std::exchange(command_, std::nullopt);
      lock.unlock();
      Answer answer = exchange(command);
      lock.lock();
      answer_ = std::move(answer);
      continue;
    }
    lock.unlock();
    look();
    lock.lock();
    const auto pause = presence_ == CardPresence::kNoReader ? config_.retry_every : config_.look_every;
    wake_.wait_for(lock, pause, [this] { return ending_ || command_.has_value(); });
  }
}

void CardPort::look() {
  if (!session_) {
    auto begun = service_();
    if (!begun) {
      lose(begun.error());
      return;
    }
    session_ = std::move(*begun);
  }
  const auto field = session_->look(config_.reader);
  if (!field) {
    lose(field.error());
    return;
  }
  set_field(*field);
}

void CardPort::lose(CardFault fault) {
  connected_ = false;
  changes_.reset();
  if (fault != CardFault::kNoReader) {
    session_.reset();
  }
  const std::lock_guard lock(mutex_);
  tried_ = true;
  presence_ = CardPresence::kNoReader;
  swapped_ = false;
  trouble_ = "cannot use the card reader '" + config_.reader + "': " + say(fault);
}

void CardPort::set_field(const CardField& field) {
  const bool another = changes_ && *changes_ != field.changes;
  changes_ = field.changes;
  if (connected_ && (!field.card || another)) {
    session_->disconnect();
    connected_ = false;
  }
  const std::lock_guard lock(mutex_);
  tried_ = true;
  trouble_.clear();
  // Kept until presence() has shown it.
  swapped_ = field.card && (swapped_ || (another && presence_ == CardPresence::kPresent));
  presence_ = field.card ? CardPresence::kPresent : CardPresence::kEmpty;
}

Result<Bytes, CardFault> CardPort::transmit(ByteView command_apdu) {
  if (!connected_) {
    const auto connection = session_->connect(config_.reader);
    if (!connection) {
      return Unexpected{connection.error()};
    }
    connected_ = true;
  }
  return session_->transmit(command_apdu);
}

CardPort::Answer CardPort::exchange(ByteView command_apdu) {
  if (!session_) {
    return Unexpected{CardError::kReaderGone};
  }
  auto answer = transmit(command_apdu);
  if (!answer && answer.error() == CardFault::kReset) {
    connected_ = false;
    answer = transmit(command_apdu);
  }
  if (answer) {
    return std::move(*answer);
  }
  switch (answer.error()) {
    case CardFault::kNoAnswer:
      return Unexpected{CardError::kTimeout};
    case CardFault::kNoCard:
    case CardFault::kReset:
      session_->disconnect();
      connected_ = false;
      return Unexpected{CardError::kRemoved};
    default:
      lose(answer.error());
      return Unexpected{CardError::kReaderGone};
  }
}

}  // namespace sensotwin::robot
