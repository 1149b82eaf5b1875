// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include "robot/base/bytes.hpp"
#include "robot/hal/byte_link.hpp"

namespace sensotwin::fuzz {

/// Something that holds for all inputs does not hold for this one.
struct PropertyBroken : std::logic_error {
  using std::logic_error::logic_error;
};

inline void require(bool holds, const char* property) {
  if (!holds) {
    throw PropertyBroken(property);
  }
}

/// An input, taken apart from its front. Beyond its end there are zeros, and nothing.
class Script {
 public:
  explicit Script(robot::ByteView input) : rest_(input) {}
  [[nodiscard]] bool empty() const { return rest_.empty(); }
  [[nodiscard]] robot::ByteView rest() const { return rest_; }
  [[nodiscard]] std::uint8_t byte() {
    const robot::ByteView one = bytes(1);
    return one.empty() ? std::uint8_t{0} : one.front();
  }
  /// As many as there are, `count` at most.
  [[nodiscard]] robot::ByteView bytes(std::size_t count) {
    const robot::ByteView taken = rest_.first(std::min(count, rest_.size()));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }

 private:
  robot::ByteView rest_;
};

/// The far end of a link: says what it is given, keeps what it hears.
class ScriptedLink final : public robot::ByteLink {
 public:
  void say(robot::ByteView bytes) { coming_.insert(coming_.end(), bytes.begin(), bytes.end()); }
  void set_up(bool up) { up_ = up; }
  [[nodiscard]] robot::Bytes& heard() { return heard_; }

 private:
  bool do_write(robot::ByteView bytes) override {
    if (up_) {
      heard_.insert(heard_.end(), bytes.begin(), bytes.end());
    }
    return up_;
  }
  std::size_t do_read(std::span<std::uint8_t> into) override {
    const std::size_t count = std::min(into.size(), coming_.size());
    std::copy_n(coming_.begin(), count, into.begin());
    coming_.erase(coming_.begin(), coming_.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  [[nodiscard]] bool do_is_up() const override { return up_; }

  bool up_{true};
  robot::Bytes coming_;
  robot::Bytes heard_;
};

/// Feeds `bytes` to a decoder of frames (room(), received(), next()) in pieces of at most `piece`, handing
/// every outcome to `each`.
template <class Decoder, class Each>
void feed(Decoder& decoder, robot::ByteView bytes, std::size_t piece, Each&& each) {
  while (!bytes.empty()) {
    const std::span<std::uint8_t> room = decoder.room();
    require(!room.empty(), "a decoder that has said all it knows has room for more");
    const std::size_t count = std::min({piece, bytes.size(), room.size()});
    std::copy_n(bytes.begin(), count, room.begin());
    decoder.received(count);
    bytes = bytes.subspan(count);
    while (const auto outcome = decoder.next()) {
      each(*outcome);
    }
  }
}

}  // namespace sensotwin::fuzz
