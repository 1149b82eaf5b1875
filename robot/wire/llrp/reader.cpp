// SPDX-License-Identifier: MIT
#include "robot/wire/llrp/reader.hpp"

#include "robot/wire/llrp/layout_report.hpp"

namespace sensotwin::robot::llrp {
namespace {

/// A TLV header, and with it the vendor and subtype of a custom one.
constexpr std::size_t kTlvHeader = 4;
constexpr std::size_t kCustomHeader = 12;
constexpr std::uint16_t kFirstTlvType = 128;

}  // namespace

std::optional<std::size_t> tv_size(std::uint16_t type) {
  // By type, from 0: AntennaID, first and last seen (UTC, uptime), RSSI, channel, count, ROSpecID, inventory
  // id, CRC, PC, EPC-96, spec index, client request, AccessSpecID, OpSpecID, singulation details.
  static constexpr std::array<std::uint8_t, 19> kSizes{0, 2, 8, 8,  8, 8, 1, 2, 2, 4,
                                                       2, 2, 2, 12, 2, 2, 4, 2, 4};
  const std::size_t size = type < kSizes.size() ? kSizes[type] : 0u;
  return size > 0 ? std::optional{size} : std::nullopt;
}

Knowledge knowledge_of(std::uint16_t tlv_type) {
  const auto within = [tlv_type](int first, int last) { return tlv_type >= first && tlv_type <= last; };
  if (within(187, 188) || within(210, 211) || within(242, 243) || tlv_type == 253) {
    return Knowledge::kLeftOut;
  }
  const bool known = within(128, 129) || within(137, 149) || within(177, 186) || within(207, 209) ||
                     within(217, 226) || within(237, 257) || within(287, 289) || within(327, 354) ||
                     tlv_type == CustomParameter::kType;
  return known ? Knowledge::kKnown : Knowledge::kUnknown;
}

void Reader::text(std::string& v) {
  std::uint16_t n{0};
  fixed(n);
  if (need(n)) {
    v.assign(bytes_.begin() + static_cast<std::ptrdiff_t>(at_),
             bytes_.begin() + static_cast<std::ptrdiff_t>(at_ + n));
    at_ += n;
  }
}

void Reader::bits(BitArray& v) {
  fixed(v.count);
  const std::size_t n = (v.count + 7u) / 8u;
  if (need(n)) {
    v.bytes.assign(bytes_.begin() + static_cast<std::ptrdiff_t>(at_),
                   bytes_.begin() + static_cast<std::ptrdiff_t>(at_ + n));
    at_ += n;
  }
}

void Reader::counted_bytes(Bytes& v) {
  std::uint16_t n{0};
  fixed(n);
  if (need(n)) {
    v.assign(bytes_.begin() + static_cast<std::ptrdiff_t>(at_),
             bytes_.begin() + static_cast<std::ptrdiff_t>(at_ + n));
    at_ += n;
  }
}

void Reader::rest(Bytes& v) {
  if (ok()) {
    v.assign(bytes_.begin() + static_cast<std::ptrdiff_t>(at_),
             bytes_.begin() + static_cast<std::ptrdiff_t>(end_));
    at_ = end_;
  }
}

void Reader::fail(Fault fault, std::uint16_t field) {
  if (error_) {
    return;
  }
  error_.emplace();
  error_->fault = fault;
  error_->path = path_;
  error_->path_size = depth_;
  error_->field = fault == Fault::kBadField || fault == Fault::kTruncated ? field : std::uint16_t{0};
  error_->position = at_;
}

void Reader::fail_about(Fault fault, std::uint16_t parameter) {
  path_[depth_++] = parameter;
  fail(fault, 0);
  --depth_;
}

void Slots::peek() {
  Reader& r = reader_;
  is_tv_ = false;
  head_ = 0;
  if (!r.ok() || r.at_ == r.end_) {
    is_end_ = true;
    return;
  }
  const ByteView left = r.bytes_.subspan(r.at_, r.end_ - r.at_);
  if ((left[0] & 0x80u) != 0) {
    const auto type = static_cast<std::uint16_t>(left[0] & 0x7Fu);
    const auto size = tv_size(type);
    if (!size) {
      r.fail_about(Fault::kUnknownParameter, type);
    } else if (left.size() < 1 + *size) {
      r.fail_about(Fault::kTruncated, type);
    } else {
      is_tv_ = true;
      head_ = type;
      body_ = r.at_ + 1;
      next_ = body_ + *size;
    }
  } else if (left.size() < kTlvHeader) {
    r.fail(Fault::kTrailingBytes);
  } else {
    const std::uint16_t raw = u16_from_be(left[0], left[1]);
    const auto type = static_cast<std::uint16_t>(raw & 0x3FFu);
    const std::uint16_t length = u16_from_be(left[2], left[3]);
    if (raw != type || type < kFirstTlvType) {
      r.fail_about(Fault::kBadParameterHeader, type);
    } else if (length < (type == CustomParameter::kType ? kCustomHeader : kTlvHeader) ||
               length > left.size()) {
      r.fail_about(Fault::kBadParameterLength, type);
    } else {
      head_ = type;
      body_ = r.at_ + kTlvHeader;
      next_ = r.at_ + length;
      if (type == CustomParameter::kType) {
        const auto u32_at = [left](std::size_t i) {
          return (static_cast<std::uint32_t>(u16_from_be(left[i], left[i + 1])) << 16) |
                 u16_from_be(left[i + 2], left[i + 3]);
        };
        vendor_ = u32_at(4);
        subtype_ = u32_at(8);
      }
    }
  }
  is_end_ = !r.ok();
}

void Slots::customs(std::vector<CustomParameter>& v) {
  // One a pass: a parameter behind it may belong to a place before this one.
  if (!checking_ && !is_end_ && !is_tv_ && head_ == CustomParameter::kType) {
    take(v.emplace_back());
  }
}

void Slots::refuse() {
  const Knowledge knowledge = is_tv_ ? Knowledge::kKnown : knowledge_of(head_);
  const Fault fault = knowledge == Knowledge::kKnown     ? Fault::kUnexpectedParameter
                      : knowledge == Knowledge::kLeftOut ? Fault::kUnsupportedParameter
                                                         : Fault::kUnknownParameter;
  reader_.fail_about(fault, head_);
}

}  // namespace sensotwin::robot::llrp
