// SPDX-License-Identifier: MIT
#include "twin/devices/emulated_card_reader.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace sensotwin::twin {

using robot::Bytes;
using robot::ByteView;
using robot::CardError;
using robot::CardPresence;
using robot::CardResponse;
using robot::CardStatus;
using robot::Duration;
using robot::Instant;
using robot::kBlockBytes;
using robot::status_word;
using robot::StatusWord;
using world::TagMemory;

CardReaderSettings card_reader_settings(const world::ReaderDescription& description) {
  return {.exchange = robot::from_s(description.exchange_s),
          .latency = robot::from_s(description.latency_s),
          .missed_share = description.missed_share,
          .torn_write_probability = description.torn_write_probability};
}

void EmulatedCardReader::step(Instant now, TagMemory* in_field) {
  assert(now >= now_);
  if (in_field != in_field_) {
    in_field_ = in_field;
    answers_from_ = now + settings_.latency;
    missed_ = in_field != nullptr && settings_.missed_share > 0.0 && random_.chance(settings_.missed_share);
  }
  TagMemory* const tag = missed_ || now < answers_from_ ? nullptr : in_field;
  const Instant before = now_;
  now_ = now;
  if (tag != tag_) {
    if (exchange_) {
      const auto left_at = before + Duration{static_cast<std::int64_t>(
                                        random_.uniform() * static_cast<double>((now - before).count()))};
      if (left_at < exchange_->due) {
        cut_off(left_at, CardError::kRemoved);
      } else {
        complete();
      }
    }
    swapped_ = swapped_ || (tag_ != nullptr && tag != nullptr);
    tag_ = tag;
    return;
  }
  if (exchange_ && now_ >= exchange_->due) {
    complete();
  }
}

void EmulatedCardReader::unplug() {
  if (exchange_) {
    cut_off(now_, CardError::kReaderGone);
  }
  plugged_ = false;
}

CardPresence EmulatedCardReader::do_presence() {
  if (!plugged_) {
    return CardPresence::kNoReader;
  }
  if (swapped_) {
    swapped_ = false;
    return CardPresence::kEmpty;
  }
  return tag_ == nullptr ? CardPresence::kEmpty : CardPresence::kPresent;
}

bool EmulatedCardReader::do_begin(ByteView command_apdu) {
  // An answer that nobody has fetched is an exchange under way: the next poll() must not take it for
  // another's.
  if (!plugged_ || swapped_ || tag_ == nullptr || exchange_ || answer_) {
    return false;
  }
  command_.assign(command_apdu.begin(), command_apdu.end());
  const Duration needed = settings_.exchange + extra_delay_;
  const bool out_of_time = needed > settings_.answer_limit;
  exchange_ = Exchange{now_, now_ + std::min(needed, settings_.answer_limit), out_of_time};
  return true;
}

std::optional<robot::Result<Bytes, CardError>> EmulatedCardReader::do_poll() {
  return std::exchange(answer_, std::nullopt);
}

void EmulatedCardReader::complete() {
  // The late answer of a reader that hangs: the command was carried out, only the word of it is missing.
  Bytes response = carry_out();
  if (exchange_->out_of_time) {
    answer_ = robot::Unexpected{CardError::kTimeout};
  } else {
    answer_ = std::move(response);
  }
  exchange_.reset();
}

void EmulatedCardReader::cut_off(Instant left_at, CardError error) {
  const auto command = robot::decode_command(command_);
  if (const auto* update = command ? std::get_if<robot::UpdateBinary>(&*command) : nullptr) {
    // An exchange that takes no time has programmed nothing when it is cut off.
    if (check(*update).ok() && exchange_->due > exchange_->begun) {
      tear(*update, robot::to_s(left_at - exchange_->begun) / robot::to_s(exchange_->due - exchange_->begun));
    }
  }
  answer_ = robot::Unexpected{error};
  exchange_.reset();
}

void EmulatedCardReader::tear(const robot::UpdateBinary& update, double done) {
  const std::size_t count = update.data.size() / kBlockBytes;
  const auto whole = std::min(static_cast<std::size_t>(std::floor(done * static_cast<double>(count))), count);
  for (std::size_t i = 0; i <= whole && i < count; ++i) {
    TagMemory::Block& block = tag_->blocks[update.first_block + i];
    const ByteView data = update.data.subspan(i * kBlockBytes, kBlockBytes);
    const bool programming = i == whole;
    if (programming && random_.chance(settings_.torn_write_probability)) {
      for (std::size_t k = 0; k < kBlockBytes; ++k) {
        const std::uint32_t programmed = random_.below(256);
        block[k] = static_cast<std::uint8_t>((block[k] & ~programmed) | (data[k] & programmed));
      }
    } else if (!programming || random_.chance(0.5)) {
      std::copy(data.begin(), data.end(), block.begin());
    }
  }
}

Bytes EmulatedCardReader::carry_out() {
  const auto command = robot::decode_command(command_);
  if (!command) {
    return encode(CardResponse{{}, status_word(command.error())});
  }
  return std::visit([this](const auto& c) { return carry_out(c); }, *command);
}

Bytes EmulatedCardReader::carry_out(const robot::GetUid& get) const {
  const auto uid = encode_uid(tag_->uid, settings_.uid_order);
  if (get.expected_length != 0 && get.expected_length < uid.size()) {
    return encode(CardResponse{{}, robot::wrong_expected_length(static_cast<std::uint8_t>(uid.size()))});
  }
  const CardStatus status = get.expected_length > uid.size() ? CardStatus::kEndReached : CardStatus::kOk;
  return encode(CardResponse{uid, status_word(status)});
}

Bytes EmulatedCardReader::carry_out(const robot::ReadBinary& read) const {
  if (read.first_block >= TagMemory::kBlocks) {
    return encode(CardResponse{{}, status_word(CardStatus::kBlockNotFound)});
  }
  if (read.expected_length != 0 && read.expected_length < kBlockBytes) {
    return encode(CardResponse{{}, robot::wrong_expected_length(static_cast<std::uint8_t>(kBlockBytes))});
  }
  std::array<std::uint8_t, TagMemory::kBlocks * kBlockBytes> memory{};
  const std::size_t available = (TagMemory::kBlocks - read.first_block) * kBlockBytes;
  for (std::size_t i = 0; i < available; ++i) {
    memory[i] = tag_->blocks[read.first_block + i / kBlockBytes][i % kBlockBytes];
  }
  const std::size_t wanted = read.expected_length == 0 ? available : read.expected_length;
  const CardStatus status = wanted > available ? CardStatus::kEndReached : CardStatus::kOk;
  return encode(CardResponse{ByteView{memory}.first(std::min(wanted, available)), status_word(status)});
}

Bytes EmulatedCardReader::carry_out(const robot::UpdateBinary& update) {
  const StatusWord status = check(update);
  if (status.ok()) {
    for (std::size_t i = 0; i < update.data.size(); ++i) {
      tag_->blocks[update.first_block + i / kBlockBytes][i % kBlockBytes] = update.data[i];
    }
  }
  return encode(CardResponse{{}, status});
}

StatusWord EmulatedCardReader::check(const robot::UpdateBinary& update) const {
  if (update.data.size() % kBlockBytes != 0) {
    return status_word(CardStatus::kWrongLength);
  }
  const std::size_t end = update.first_block + update.data.size() / kBlockBytes;
  if (end > TagMemory::kBlocks) {
    return status_word(CardStatus::kBlockNotFound);
  }
  for (std::size_t block = update.first_block; block < end; ++block) {
    if (tag_->locked[block]) {
      return status_word(CardStatus::kCommandNotAllowed);
    }
  }
  return {};
}

}  // namespace sensotwin::twin
