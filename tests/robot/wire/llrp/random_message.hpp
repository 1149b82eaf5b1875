// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "robot/base/random.hpp"
#include "robot/wire/llrp/frame.hpp"
#include "robot/wire/llrp/layout_messages.hpp"

namespace sensotwin::robot::llrp {

/// A third user of the layouts, beside Reader and Writer: fills a message with random values that LLRP
/// allows.
class Filler {
 public:
  template <class T>
  using Ref = T&;

  explicit Filler(RandomStream random) : random_(random) {}

  template <class N>
  void number(N& v) {
    if constexpr (std::is_same_v<N, Epc>) {
      for (std::uint8_t& each : v.bytes) {
        number(each);
      }
    } else {
      v = static_cast<N>(random_.next_u64());
    }
  }
  template <class E>
  void code(E& v, E last) {
    v = static_cast<E>(random_.below(static_cast<std::uint32_t>(last) + 1));
  }
  template <class E>
  void open_code(E& v) {
    v = static_cast<E>(random_.below(65536));
  }
  template <class... Flag>
  void flags8(Flag&... flag) {
    ((flag = random_.chance(0.5)), ...);
  }
  template <class... Flag>
  void flags16(Flag&... flag) {
    flags8(flag...);
  }
  template <class E>
  void two_bits(E& v) {
    v = static_cast<E>(random_.below(4));
  }
  template <class E>
  void two_bits(E& v, bool& flag) {
    two_bits(v);
    flags8(flag);
  }
  void reserved(std::size_t /*bytes*/) {}
  void text(std::string& v) { v.assign(random_.below(6), 'x'); }
  void bits(BitArray& v) {
    v.count = static_cast<std::uint16_t>(random_.below(40));
    v.bytes.resize((v.count + 7u) / 8u);
    for (std::uint8_t& each : v.bytes) {
      number(each);
    }
  }
  void counted_bytes(Bytes& v) { counted(v); }
  void rest(Bytes& v) { counted(v); }
  template <class N>
  void counted(std::vector<N>& v) {
    v.resize(random_.below(5));
    for (N& each : v) {
      number(each);
    }
  }

  template <class Describe>
  void children(Describe&& describe) {
    describe(*this);
  }
  template <class T>
  void one(T& v) {
    ++depth_;
    layout(*this, v);
    if constexpr (std::is_same_v<T, TagReport>) {
      fix(v.epc_96, v.epc);
    } else if constexpr (std::is_same_v<T, ReaderEvent>) {
      fix(v.utc, v.uptime);
    }
    --depth_;
  }
  template <class T>
  void maybe(std::optional<T>& v) {
    if (random_.chance(0.5)) {
      one(v.emplace());
    }
  }
  template <class T>
  void list(std::vector<T>& v, std::size_t at_least = 0, std::size_t at_most = 3) {
    // Errors may nest in errors: deep ones get rarer.
    const std::size_t n = depth_ > 6 ? at_least : at_least + random_.below(3);
    for (std::size_t i = 0; i < std::min(n, at_most); ++i) {
      one(v.emplace_back());
    }
  }
  template <class... T>
  void any_of(std::vector<std::variant<T...>>& v, std::size_t at_least = 0) {
    const std::size_t n = at_least + random_.below(3);
    for (std::size_t i = 0; i < n; ++i) {
      std::size_t wanted = random_.below(sizeof...(T));
      ((wanted-- == 0 ? add<T>(v) : void()), ...);
    }
  }
  template <class N>
  void tv(std::uint16_t /*type*/, std::optional<N>& v) {
    if (random_.chance(0.5)) {
      number(v.emplace());
    }
  }
  void customs(std::vector<CustomParameter>& v) {
    list(v);
    for (CustomParameter& each : v) {
      each.vendor |= 0x80000000u;  // nobody we have names for
    }
  }

 private:
  template <class T, class Variant>
  void add(std::vector<Variant>& v) {
    T value;
    one(value);
    v.emplace_back(std::move(value));
  }
  /// Exactly one of two.
  template <class A, class B>
  void fix(std::optional<A>& a, std::optional<B>& b) {
    if (random_.chance(0.5)) {
      b.reset();
      if constexpr (std::is_same_v<A, Epc>) {
        number(a.emplace());
      } else {
        one(a.emplace());
      }
    } else {
      a.reset();
      one(b.emplace());
    }
  }

  RandomStream random_;
  int depth_{0};
};

/// One message of each kind, filled at random.
[[nodiscard]] inline std::vector<Message> random_messages(RandomStream random) {
  std::vector<Message> out;
  const auto add = [&]<std::size_t I>() {
    std::variant_alternative_t<I, Message> message;
    Filler filler{random.fork(std::to_string(I))};
    body_layout(filler, message);
    if constexpr (std::is_same_v<decltype(message), CustomMessage>) {
      message.vendor |= 0x80000000u;
    }
    out.emplace_back(std::move(message));
  };
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (add.template operator()<I>(), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Message>>{});
  return out;
}

/// The frame that `bytes` are, without looking at the length they announce.
[[nodiscard]] inline Frame frame_of(const Bytes& bytes) {
  const std::uint16_t first = u16_from_be(bytes[0], bytes[1]);
  const auto id =
      static_cast<std::uint32_t>(u16_from_be(bytes[6], bytes[7]) << 16) | u16_from_be(bytes[8], bytes[9]);
  return {{static_cast<std::uint8_t>((first >> 10) & 7), static_cast<std::uint16_t>(first & 0x3FFu), id},
          ByteView{bytes}.subspan(kHeaderBytes)};
}

}  // namespace sensotwin::robot::llrp
