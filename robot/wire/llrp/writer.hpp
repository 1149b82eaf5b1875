// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
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

/// The encoding half of the layouts: see reader.hpp.
namespace sensotwin::robot::llrp {

/// Appends fields to `out`. Cannot fail; a parameter above 65535 bytes or a list above 65535 entries is the
/// programmer's error.
class Writer {
 public:
  template <class T>
  using Ref = const T&;

  explicit Writer(Bytes& out) : out_(out) {}

  template <class N>
  void number(const N& v) {
    if constexpr (std::is_same_v<N, Epc>) {
      out_.insert(out_.end(), v.bytes.begin(), v.bytes.end());
    } else {
      std::uint64_t raw = static_cast<std::make_unsigned_t<N>>(v);
      const std::size_t start = out_.size();
      out_.resize(start + sizeof(N));
      for (std::size_t i = sizeof(N); i-- > 0; raw >>= 8) {
        out_[start + i] = static_cast<std::uint8_t>(raw);
      }
    }
  }
  template <class E>
  void code(const E& v, E /*last*/) {
    number(static_cast<std::underlying_type_t<E>>(v));
  }
  template <class E>
  void open_code(const E& v) {
    number(static_cast<std::underlying_type_t<E>>(v));
  }
  template <class... Flag>
  void flags8(const Flag&... flag) {
    flags<std::uint8_t>(flag...);
  }
  template <class... Flag>
  void flags16(const Flag&... flag) {
    flags<std::uint16_t>(flag...);
  }
  template <class E>
  void two_bits(const E& v, bool flag = false) {
    number(static_cast<std::uint8_t>((static_cast<unsigned>(v) << 6) | (flag ? 0x20u : 0u)));
  }
  void reserved(std::size_t bytes) { out_.insert(out_.end(), bytes, std::uint8_t{0}); }
  void text(const std::string& v) {
    count(v.size());
    out_.insert(out_.end(), v.begin(), v.end());
  }
  void bits(const BitArray& v) {
    assert(v.bytes.size() == (v.count + 7u) / 8u);
    number(v.count);
    rest(v.bytes);
  }
  void counted_bytes(const Bytes& v) {
    count(v.size());
    rest(v);
  }
  void rest(const Bytes& v) { out_.insert(out_.end(), v.begin(), v.end()); }
  template <class N>
  void counted(const std::vector<N>& v) {
    count(v.size());
    for (const N& each : v) {
      number(each);
    }
  }
  template <class Describe>
  void children(Describe&& describe) {
    describe(*this);
  }

  template <class T>
  void one(const T& v) {
    const std::size_t start = out_.size();
    number(T::kType);
    number(std::uint16_t{0});
    if constexpr (requires { T::kImpinjSubtype; }) {
      number(kImpinj);
      number(T::kImpinjSubtype);
    }
    layout(*this, v);
    const std::size_t length = out_.size() - start;
    assert(length <= UINT16_MAX);
    out_[start + 2] = static_cast<std::uint8_t>(length >> 8);
    out_[start + 3] = static_cast<std::uint8_t>(length);
  }
  template <class T>
  void maybe(const std::optional<T>& v) {
    if (v) {
      one(*v);
    }
  }
  template <class T>
  void list(const std::vector<T>& v, std::size_t /*at_least*/ = 0, std::size_t /*at_most*/ = 0) {
    for (const T& each : v) {
      one(each);
    }
  }
  template <class... T>
  void any_of(const std::vector<std::variant<T...>>& v, std::size_t /*at_least*/ = 0) {
    for (const auto& each : v) {
      std::visit([this](const auto& what) { this->one(what); }, each);
    }
  }
  template <class N>
  void tv(std::uint16_t type, const std::optional<N>& v) {
    if (v) {
      out_.push_back(static_cast<std::uint8_t>(0x80u | type));
      number(*v);
    }
  }
  void customs(const std::vector<CustomParameter>& v) { list(v); }

 private:
  void count(std::size_t n) {
    assert(n <= UINT16_MAX);
    number(static_cast<std::uint16_t>(n));
  }
  template <class Raw, class... Flag>
  void flags(const Flag&... flag) {
    unsigned raw = 0;
    int bit = static_cast<int>(sizeof(Raw) * 8);
    ((--bit, raw |= flag ? 1u << bit : 0u), ...);
    number(static_cast<Raw>(raw));
  }

  Bytes& out_;
};

}  // namespace sensotwin::robot::llrp
