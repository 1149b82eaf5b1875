// SPDX-License-Identifier: MIT
#include "robot/wire/oi_stream.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "robot/wire/oi_packet_tables.hpp"

namespace sensotwin::robot::oi {
std::uint8_t sum_of(ByteView bytes) {
  // Eight bytes at a time: the even and the odd ones gather in 16-bit lanes, which hold 257 of them.
  assert(bytes.size() <= 8 * 257 / 2);
  constexpr std::uint64_t kEven = 0x00FF00FF00FF00FFu;
  std::uint64_t lanes = 0;
  std::size_t at = 0;
  for (; at + 8 <= bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, 8);
    lanes += (word & kEven) + ((word >> 8) & kEven);
  }
  auto sum = static_cast<unsigned>(lanes + (lanes >> 16) + (lanes >> 32) + (lanes >> 48));
  for (; at < bytes.size(); ++at) {
    sum += bytes[at];
  }
  return static_cast<std::uint8_t>(sum);
}

std::span<std::uint8_t> StreamDecoder::room() {
  if (begin_ == end_) {
    reset();  // nearly always: the last frame was read to its end
  } else if (begin_ > 0) {
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
    if (held() > 0 && buffer_[begin_] != kStreamHeader) {
      const auto* header =
          static_cast<const std::uint8_t*>(std::memchr(buffer_.data() + begin_, kStreamHeader, held()));
      skip(header == nullptr ? held() : static_cast<std::size_t>(header - buffer_.data()) - begin_);
    }
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
  const std::uint8_t* at = payload.data();
  const std::uint8_t* const end = at + payload.size();
  std::size_t packets = 0;
  while (at != end) {
    const PacketRun run = detail::kRuns[*at++];
    if (run.size == 0) {
      return Unexpected{StreamError::kUnknownPacket};
    }
    if (end - at < run.size) {
      return Unexpected{StreamError::kTooShort};
    }
    at = detail::read_run(run, at, into);
    ++packets;
  }
  return packets;
}

Result<std::size_t, StreamError> encode_frame(ByteView ids, const SensorValues& values,
                                              std::span<std::uint8_t> into) {
  if (into.size() < kStreamOverhead) {
    return Unexpected{StreamError::kNoRoom};
  }
  const std::size_t payload_room = std::min<std::size_t>(into.size() - kStreamOverhead, 255);
  std::uint8_t* const payload = into.data() + 2;
  std::uint8_t* out = payload;
  for (const std::uint8_t id : ids) {
    const PacketRun run = detail::kRuns[id];
    if (run.size == 0) {
      return Unexpected{StreamError::kUnknownPacket};
    }
    if (payload_room - static_cast<std::size_t>(out - payload) < 1u + run.size) {
      return Unexpected{StreamError::kNoRoom};
    }
    *out++ = id;
    out = detail::write_run(run, values, out);
  }
  const auto n = static_cast<std::size_t>(out - payload);
  into[0] = kStreamHeader;
  into[1] = static_cast<std::uint8_t>(n);
  into[n + 2] = static_cast<std::uint8_t>(256u - sum_of(into.first(n + 2)));
  return n + kStreamOverhead;
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
