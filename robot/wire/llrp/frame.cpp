// SPDX-License-Identifier: MIT
#include "robot/wire/llrp/frame.hpp"

#include <algorithm>
#include <cassert>

namespace sensotwin::robot::llrp {
namespace {

[[nodiscard]] std::uint32_t u32_at(ByteView bytes, std::size_t i) {
  return (static_cast<std::uint32_t>(u16_from_be(bytes[i], bytes[i + 1])) << 16) |
         u16_from_be(bytes[i + 2], bytes[i + 3]);
}

/// What a header's first six bytes tell: enough to judge it.
constexpr std::size_t kJudgedBytes = 6;

}  // namespace

bool is_message_type(std::uint16_t type) {
  const auto within = [type](int first, int last) { return type >= first && type <= last; };
  return within(1, 4) || within(11, 14) || within(20, 26) || within(30, 36) || within(40, 44) ||
         within(50, 54) || within(60, 64) || type == 72 || type == 100 || type == 1023;
}

FrameDecoder::FrameDecoder(std::size_t max_frame_bytes) : max_(max_frame_bytes), buffer_(max_frame_bytes) {
  assert(max_frame_bytes >= kHeaderBytes);
}

std::span<std::uint8_t> FrameDecoder::room() {
  if (begin_ > 0) {
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= begin_;
    begin_ = 0;
  }
  return std::span{buffer_}.subspan(end_);
}

void FrameDecoder::received(std::size_t count) {
  assert(end_ + count <= buffer_.size());
  end_ += count;
}

std::optional<Result<Frame, FrameError>> FrameDecoder::next() {
  while (hunting_ && held() >= kJudgedBytes) {
    if (is_plausible()) {
      hunting_ = false;
    } else {
      ++begin_;
      ++skipped_;
    }
  }
  if (hunting_ || held() < kJudgedBytes) {
    return std::nullopt;
  }
  if (const auto fault = fault_of_header()) {
    hunting_ = true;
    ++begin_;
    ++skipped_;
    return Unexpected{*fault};
  }
  const std::size_t length = announced();
  if (held() < length) {
    return std::nullopt;
  }
  const ByteView bytes = ByteView{buffer_}.subspan(begin_, length);
  begin_ += length;
  const std::uint16_t first = u16_from_be(bytes[0], bytes[1]);
  return Frame{{static_cast<std::uint8_t>((first >> 10) & 7), static_cast<std::uint16_t>(first & 0x3FFu),
                u32_at(bytes, 6)},
               bytes.subspan(kHeaderBytes)};
}

void FrameDecoder::reset() {
  begin_ = end_ = 0;
  hunting_ = false;
}

std::size_t FrameDecoder::announced() const {
  return u32_at(ByteView{buffer_}, begin_ + 2);
}

std::optional<FrameError> FrameDecoder::fault_of_header() const {
  if ((buffer_[begin_] & 0xE0u) != 0) {
    return FrameError::kReservedBits;
  }
  if (announced() < kHeaderBytes) {
    return FrameError::kTooShort;
  }
  return announced() > max_ ? std::optional{FrameError::kTooLong} : std::nullopt;
}

bool FrameDecoder::is_plausible() const {
  const std::uint16_t first = u16_from_be(buffer_[begin_], buffer_[begin_ + 1]);
  return (first >> 10) == kVersion && is_message_type(first & 0x3FFu) && !fault_of_header();
}

}  // namespace sensotwin::robot::llrp
