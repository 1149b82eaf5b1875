// SPDX-License-Identifier: MIT
#include "robot/wire/oi_stream_layout.hpp"

#include <algorithm>
#include <cstring>

#include "robot/wire/oi_packet_tables.hpp"

namespace sensotwin::robot::oi {
namespace {

[[nodiscard]] std::uint64_t word_at(const std::uint8_t* bytes) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

/// Carries the sign on. \param sign_bit  0 leaves the value as it is
[[nodiscard]] std::int32_t with_sign(std::int32_t value, std::uint16_t sign_bit) {
  return (value ^ sign_bit) - sign_bit;
}

}  // namespace

std::optional<StreamLayout> StreamLayout::of(ByteView ids) {
  StreamLayout layout;
  for (const std::uint8_t id : ids) {
    const PacketRun run = detail::kRuns[id];
    if (run.size == 0 || layout.payload_bytes_ + 1 + run.size > kMostBytes) {
      return std::nullopt;
    }
    layout.ids_[layout.payload_bytes_] = id;
    layout.mask_[layout.payload_bytes_] = 0xFF;
    ++layout.payload_bytes_;
    for (unsigned packet = run.first; packet <= run.last; ++packet) {
      layout.add(static_cast<PacketId>(packet));
    }
  }
  return layout;
}

void StreamLayout::add(PacketId packet) {
  const PacketInfo& info = detail::kPackets[static_cast<std::size_t>(packet)];
  const unsigned sign_bit = info.is_signed ? 1u << (8u * info.size - 1u) : 0u;
  const Place place{packet, static_cast<std::uint8_t>(payload_bytes_), static_cast<std::uint16_t>(sign_bit)};
  if (info.size == 2) {
    words_[words_count_++] = place;
  } else {
    bytes_[bytes_count_++] = place;
  }
  payload_bytes_ += info.size;
}

std::size_t StreamLayout::encode(const SensorValues& values, std::span<std::uint8_t> into) const {
  const std::size_t frame_bytes = payload_bytes_ + kStreamOverhead;
  if (into.size() < frame_bytes) {
    return 0;
  }
  into[0] = kStreamHeader;
  into[1] = static_cast<std::uint8_t>(payload_bytes_);
  std::uint8_t* const payload = into.data() + 2;
  std::memcpy(payload, ids_.data(), payload_bytes_);
  for (const Place& place : std::span{words_}.first(words_count_)) {
    const auto bits = static_cast<std::uint16_t>(values[place.packet]);
    payload[place.at] = high_byte(bits);
    payload[place.at + 1] = low_byte(bits);
  }
  for (const Place& place : std::span{bytes_}.first(bytes_count_)) {
    payload[place.at] = static_cast<std::uint8_t>(values[place.packet]);
  }
  payload[payload_bytes_] = static_cast<std::uint8_t>(256u - sum_of(into.first(payload_bytes_ + 2)));
  return frame_bytes;
}

bool StreamLayout::decode(ByteView payload, SensorValues& into) const {
  if (payload.size() != payload_bytes_) {
    return false;
  }
  std::uint64_t foreign = 0;
  std::size_t at = 0;
  for (; at + kWordBytes <= payload.size(); at += kWordBytes) {
    foreign |= (word_at(payload.data() + at) ^ word_at(ids_.data() + at)) & word_at(mask_.data() + at);
  }
  for (; at < payload.size(); ++at) {
    foreign |= static_cast<std::uint64_t>((payload[at] ^ ids_[at]) & mask_[at]);
  }
  if (foreign != 0) {
    return false;
  }
  const std::uint8_t* const data = payload.data();
  for (const Place& place : std::span{words_}.first(words_count_)) {
    into[place.packet] = with_sign((data[place.at] << 8) | data[place.at + 1], place.sign_bit);
  }
  for (const Place& place : std::span{bytes_}.first(bytes_count_)) {
    into[place.packet] = with_sign(data[place.at], place.sign_bit);
  }
  return true;
}

}  // namespace sensotwin::robot::oi
