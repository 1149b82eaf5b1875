// SPDX-License-Identifier: MIT
#include "robot/wire/oi_stream.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace sensotwin::robot::oi {
namespace {

[[nodiscard]] std::uint8_t sum_of(ByteView bytes) {
  unsigned sum = 0;
  for (const std::uint8_t byte : bytes) {
    sum += byte;
  }
  return static_cast<std::uint8_t>(sum);
}

}  // namespace

std::span<std::uint8_t> StreamDecoder::room() {
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, held());
    end_ -= begin_;
    rejected_end_ -= std::min(rejected_end_, begin_);
    begin_ = 0;
  }
  return std::span{buffer_}.subspan(end_);
}

void StreamDecoder::received(std::size_t count) {
  assert(count <= kBufferBytes - end_);
  end_ += count;
}

void StreamDecoder::reset() {
  begin_ = end_ = rejected_end_ = 0;
}

void StreamDecoder::skip(std::size_t count) {
  begin_ += count;
  skipped_ += count;
}

std::optional<Result<ByteView, StreamError>> StreamDecoder::reject(StreamError error,
                                                                   std::size_t frame_bytes) {
  const bool reported_already = begin_ < rejected_end_;
  if (!reported_already) {
    rejected_end_ = begin_ + frame_bytes;
  }
  skip(1);
  if (reported_already) {
    return std::nullopt;
  }
  return Unexpected{error};
}

std::optional<Result<ByteView, StreamError>> StreamDecoder::next() {
  for (;;) {
    const auto* header = static_cast<const std::uint8_t*>(
        held() == 0 ? nullptr : std::memchr(buffer_.data() + begin_, kStreamHeader, held()));
    skip(header == nullptr ? held() : static_cast<std::size_t>(header - buffer_.data()) - begin_);
    if (held() < 2) {
      return std::nullopt;
    }
    const std::size_t n = buffer_[begin_ + 1];
    const bool plausible = expected_ ? n == *expected_ : n > 0 && n <= kMaxPayloadBytes;
    if (!plausible) {
      if (auto error = reject(StreamError::kBadLength, 1)) {
        return error;
      }
      continue;
    }
    if (held() < n + kStreamOverhead) {
      return std::nullopt;
    }
    const ByteView frame{buffer_.data() + begin_, n + kStreamOverhead};
    if (sum_of(frame) != 0) {
      if (auto error = reject(StreamError::kBadChecksum, frame.size())) {
        return error;
      }
      continue;
    }
    begin_ += frame.size();
    return frame.subspan(2, n);
  }
}

Result<std::size_t, StreamError> decode_payload(ByteView payload, SensorValues& into) {
  std::size_t packets = 0;
  for (std::size_t at = 0; at < payload.size(); ++packets) {
    const auto used = decode_packet(payload[at], payload.subspan(at + 1), into);
    if (!used) {
      return Unexpected{used.error() == PacketError::kUnknownPacket ? StreamError::kUnknownPacket
                                                                    : StreamError::kTooShort};
    }
    at += 1 + *used;
  }
  return packets;
}

Result<std::size_t, StreamError> encode_frame(ByteView ids, const SensorValues& values,
                                              std::span<std::uint8_t> into) {
  std::size_t at = 2;
  for (const std::uint8_t id : ids) {
    if (at >= into.size()) {
      return Unexpected{StreamError::kNoRoom};
    }
    into[at] = id;
    const auto written = encode_packet(id, values, into.subspan(at + 1));
    if (!written) {
      return Unexpected{written.error() == PacketError::kUnknownPacket ? StreamError::kUnknownPacket
                                                                       : StreamError::kNoRoom};
    }
    at += 1 + *written;
  }
  if (at >= into.size() || at - 2 > 255) {
    return Unexpected{StreamError::kNoRoom};
  }
  into[0] = kStreamHeader;
  into[1] = static_cast<std::uint8_t>(at - 2);
  into[at] = static_cast<std::uint8_t>(256u - sum_of(into.first(at)));
  return at + 1;
}

std::size_t payload_bytes(ByteView ids) {
  std::size_t bytes = 0;
  for (const std::uint8_t id : ids) {
    const std::size_t size = packet_run(id).size;
    bytes += size == 0 ? 0 : size + 1;
  }
  return bytes;
}

}  // namespace sensotwin::robot::oi
