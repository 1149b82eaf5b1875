// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "robot/base/bytes.hpp"
#include "robot/base/epc.hpp"
#include "robot/wire/llrp/bit_array.hpp"
#include "robot/wire/llrp/custom.hpp"
#include "robot/wire/llrp/decode_error.hpp"

/// The decoding half of the layouts (layout_*.hpp): the same description of a parameter, given to a Reader,
/// fills the structure from bytes, and given to a Writer, makes bytes of it.
namespace sensotwin::robot::llrp {

/// Size of a TV parameter's value; nothing for a type that LLRP 1.0.1 does not have (16.2.7.3, 16.3.1.5).
[[nodiscard]] std::optional<std::size_t> tv_size(std::uint16_t type);
enum class Knowledge : std::uint8_t { kUnknown, kLeftOut, kKnown };
/// Whether LLRP 1.0.1 has a TLV parameter of this type, and whether this codec does (16.4, table 5).
[[nodiscard]] Knowledge knowledge_of(std::uint16_t tlv_type);

/// Reads fields in order. The first fault is kept; from then on every call does nothing, so that a layout
/// need not ask after each field.
class Reader {
 public:
  template <class T>
  using Ref = T&;

  explicit Reader(ByteView bytes) : bytes_(bytes), end_(bytes.size()) {}

  [[nodiscard]] bool ok() const { return !error_; }
  [[nodiscard]] const std::optional<DecodeError>& error() const { return error_; }
  [[nodiscard]] bool at_end() const { return at_ == end_; }

  void number(std::uint8_t& v) { fixed(v); }
  void number(std::int8_t& v) { fixed(v); }
  void number(std::uint16_t& v) { fixed(v); }
  void number(std::int16_t& v) { fixed(v); }
  void number(std::uint32_t& v) { fixed(v); }
  void number(std::uint64_t& v) { fixed(v); }
  void number(Epc& v) {
    if (need(v.bytes.size())) {
      std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), v.bytes.size(), v.bytes.begin());
      at_ += v.bytes.size();
    }
  }
  /// An enumeration of values 0 to `last`. Any other: kBadField.
  template <class E>
  void code(E& v, E last) {
    std::underlying_type_t<E> raw{};
    fixed(raw);
    if (ok() && raw > static_cast<std::underlying_type_t<E>>(last)) {
      fail(Fault::kBadField);
      return;
    }
    v = static_cast<E>(raw);
  }
  /// As code(), for values that are kept even when they have no name (status codes).
  template <class E>
  void open_code(E& v) {
    std::underlying_type_t<E> raw{};
    fixed(raw);
    v = static_cast<E>(raw);
  }
  template <class... Flag>
  void flags8(Flag&... flag) {
    flags<std::uint8_t>(flag...);
  }
  template <class... Flag>
  void flags16(Flag&... flag) {
    flags<std::uint16_t>(flag...);
  }
  /// Two bits at the top of a byte, and one flag below them.
  template <class E>
  void two_bits(E& v, bool& flag) {
    std::uint8_t raw{0};
    fixed(raw);
    v = static_cast<E>(raw >> 6);
    flag = (raw & 0x20u) != 0;
  }
  template <class E>
  void two_bits(E& v) {
    bool unused = false;
    two_bits(v, unused);
  }
  void reserved(std::size_t bytes) {
    if (need(bytes)) {
      at_ += bytes;
    }
  }
  void text(std::string& v);
  void bits(BitArray& v);
  void counted_bytes(Bytes& v);
  void rest(Bytes& v);
  template <class N>
  void counted(std::vector<N>& v) {
    std::uint16_t n{0};
    fixed(n);
    if (!need(n * sizeof(N))) {
      return;
    }
    v.resize(n);
    for (N& each : v) {
      fixed(each);
    }
    field_ = static_cast<std::uint16_t>(field_ - n);
  }

  /// The parameters that fill the rest. `describe(slots)` names the allowed ones; they are taken in any
  /// order.
  template <class Describe>
  void children(Describe&& describe);

  void fail(Fault fault) { fail(fault, field_); }
  void fail_about(Fault fault, std::uint16_t parameter);

 private:
  friend class Slots;
  static constexpr std::size_t kMaxDepth = DecodeError::kMaxPath - 1;

  [[nodiscard]] bool need(std::size_t n) {
    if (error_) {
      return false;
    }
    ++field_;
    if (end_ - at_ < n) {
      fail(Fault::kTruncated);
      return false;
    }
    return true;
  }
  template <class N>
  void fixed(N& v) {
    if (!need(sizeof(N))) {
      return;
    }
    using Wide = std::make_unsigned_t<N>;
    Wide raw{0};
    for (std::size_t i = 0; i < sizeof(N); ++i) {
      raw = static_cast<Wide>((static_cast<std::uint64_t>(raw) << 8) | bytes_[at_ + i]);
    }
    at_ += sizeof(N);
    v = static_cast<N>(raw);
  }
  template <class Raw, class... Flag>
  void flags(Flag&... flag) {
    Raw raw{0};
    fixed(raw);
    int bit = static_cast<int>(sizeof(Raw) * 8);
    ((--bit, flag = ((static_cast<unsigned>(raw) >> bit) & 1u) != 0), ...);
  }
  void fail(Fault fault, std::uint16_t field);

  ByteView bytes_;
  std::size_t at_{0};
  std::size_t end_;
  std::uint16_t field_{0};
  std::array<std::uint16_t, DecodeError::kMaxPath> path_{};
  std::size_t depth_{0};
  std::optional<DecodeError> error_;
};

/// The places for parameters inside a parameter, while one is read.
class Slots {
 public:
  explicit Slots(Reader& reader) : reader_(reader) { peek(); }

  /// Mandatory, once.
  template <class T>
  void one(T& v) {
    const std::uint32_t bit = 1u << slot_++;
    if (checking_) {
      if ((seen_ & bit) == 0) {
        reader_.fail_about(Fault::kMissingParameter, T::kType);
      }
    } else if (is_next<T>()) {
      if ((seen_ & bit) != 0) {
        reader_.fail_about(Fault::kDuplicateParameter, T::kType);
        return;
      }
      seen_ |= bit;
      take(v);
    }
  }
  /// Optional, once.
  template <class T>
  void maybe(std::optional<T>& v) {
    if (!checking_ && is_next<T>()) {
      if (v) {
        reader_.fail_about(Fault::kDuplicateParameter, T::kType);
        return;
      }
      take(v.emplace());
    }
  }
  /// Any number, `at_least` of them.
  template <class T>
  void list(std::vector<T>& v, std::size_t at_least = 0, std::size_t at_most = SIZE_MAX) {
    if (checking_ && v.size() < at_least) {
      reader_.fail_about(Fault::kMissingParameter, T::kType);
    } else if (checking_ && v.size() > at_most) {
      reader_.fail_about(Fault::kDuplicateParameter, T::kType);
    }
    while (!checking_ && is_next<T>()) {
      take(v.emplace_back());
    }
  }
  /// Any number of several kinds, kept in their order.
  template <class... T>
  void any_of(std::vector<std::variant<T...>>& v, std::size_t at_least = 0) {
    if (checking_) {
      if (v.size() < at_least) {
        reader_.fail(Fault::kMissingParameter);
      }
      return;
    }
    bool more = true;
    while (more) {
      more = (take_if<T>(v) || ...);
    }
  }
  /// Optional TV parameter of one number.
  template <class N>
  void tv(std::uint16_t type, std::optional<N>& v) {
    if (checking_ || !is_tv_ || head_ != type) {
      return;
    }
    if (v) {
      reader_.fail_about(Fault::kDuplicateParameter, type);
      return;
    }
    reader_.at_ = body_;
    reader_.number(v.emplace());
    peek();
  }
  /// Custom parameters that no place before this one has taken. Named last.
  void customs(std::vector<CustomParameter>& v);

  /// One pass over the places. \returns whether there is another to come
  template <class Describe>
  [[nodiscard]] bool pass(Describe& describe) {
    if (!reader_.ok() || is_end_) {
      return false;
    }
    const std::size_t before = reader_.at_;
    slot_ = 0;
    describe(*this);
    if (reader_.ok() && reader_.at_ == before) {
      refuse();
    }
    return reader_.ok() && !is_end_;
  }
  template <class Describe>
  void check(Describe& describe) {
    if (reader_.ok()) {
      checking_ = true;
      slot_ = 0;
      describe(*this);
    }
  }

 private:
  template <class T>
  [[nodiscard]] bool is_next() const {
    if (is_end_ || is_tv_ || head_ != T::kType) {
      return false;
    }
    if constexpr (requires { T::kImpinjSubtype; }) {
      return vendor_ == kImpinj && subtype_ == T::kImpinjSubtype;
    } else {
      return true;
    }
  }
  template <class T, class Variant>
  [[nodiscard]] bool take_if(std::vector<Variant>& v) {
    if (!is_next<T>()) {
      return false;
    }
    T value;
    take(value);
    v.emplace_back(std::move(value));
    return true;
  }
  template <class T>
  void take(T& v);
  /// Reads the next header. Afterwards the reader stands at its first byte, or has failed, or is at the end.
  void peek();
  void refuse();

  Reader& reader_;
  bool is_end_{false};
  bool is_tv_{false};
  bool checking_{false};
  std::uint16_t head_{0};
  std::size_t body_{0};  ///< where its value begins
  std::size_t next_{0};  ///< where the next one begins
  std::uint32_t vendor_{0};
  std::uint32_t subtype_{0};
  std::uint32_t seen_{0};
  unsigned slot_{0};
};

template <class Describe>
void Reader::children(Describe&& describe) {
  if (error_) {
    return;
  }
  Slots slots{*this};
  while (slots.pass(describe)) {
  }
  slots.check(describe);
}

template <class T>
void Slots::take(T& v) {
  Reader& r = reader_;
  if (r.depth_ == Reader::kMaxDepth) {
    r.fail_about(Fault::kTooDeep, T::kType);
    is_end_ = true;
    return;
  }
  const std::size_t outer_end = r.end_;
  const std::uint16_t outer_field = r.field_;
  const std::size_t next = next_;
  r.path_[r.depth_++] = T::kType;
  r.field_ = 0;
  r.at_ = body_;
  r.end_ = next;
  if constexpr (requires { T::kImpinjSubtype; }) {
    r.at_ += 2 * sizeof(std::uint32_t);  // vendor and subtype, which peek() has read
  }
  layout(r, v);
  if (r.ok() && r.at_ != r.end_) {
    r.fail(Fault::kTrailingBytes);
  }
  --r.depth_;
  r.field_ = outer_field;
  r.end_ = outer_end;
  if (r.ok()) {
    peek();
  } else {
    is_end_ = true;
  }
}

}  // namespace sensotwin::robot::llrp
