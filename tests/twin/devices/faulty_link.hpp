// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "robot/base/bytes.hpp"
#include "robot/base/random.hpp"
#include "robot/hal/byte_link.hpp"

namespace sensotwin::twin {

/// A wire on which bytes are lost, bent, held up, or come from nobody.
class FaultyLink final : public robot::ByteLink {
 public:
  explicit FaultyLink(robot::ByteLink& good) : good_(&good) {}

  double lose_in{0.0};      ///< chance for each byte towards the program
  double lose_out{0.0};     ///< and towards the device
  double corrupt_in{0.0};   ///< one bit turned
  double corrupt_out{0.0};  ///
  bool cut{false};          ///< nothing passes, and both ends know

  /// Another device is at the other end from now on.
  void plug_into(robot::ByteLink& good) { good_ = &good; }
  /// Nothing passes; it comes through when the line goes on.
  void set_stalled(bool stalled) {
    stalled_ = stalled;
    if (!stalled_ && !held_.empty()) {
      static_cast<void>(good_->write(held_));
      held_.clear();
    }
  }
  /// The program reads these first.
  void inject(robot::ByteView bytes) { injected_.insert(injected_.end(), bytes.begin(), bytes.end()); }

 private:
  [[nodiscard]] robot::Bytes spoilt(robot::ByteView bytes, double lose, double corrupt) {
    robot::Bytes out;
    out.reserve(bytes.size());
    for (const std::uint8_t byte : bytes) {
      if (!random_.chance(lose)) {
        out.push_back(
            static_cast<std::uint8_t>(byte ^ (random_.chance(corrupt) ? 1u << random_.below(8) : 0u)));
      }
    }
    return out;
  }
  bool do_write(robot::ByteView bytes) override {
    if (cut) {
      return false;
    }
    const robot::Bytes through = spoilt(bytes, lose_out, corrupt_out);
    if (stalled_) {
      held_.insert(held_.end(), through.begin(), through.end());
      return true;
    }
    return good_->write(through);
  }
  std::size_t do_read(std::span<std::uint8_t> into) override {
    if (cut || stalled_) {
      return 0;
    }
    if (!injected_.empty()) {
      const std::size_t count = std::min(into.size(), injected_.size());
      std::copy_n(injected_.begin(), count, into.begin());
      injected_.erase(injected_.begin(), injected_.begin() + static_cast<std::ptrdiff_t>(count));
      return count;
    }
    const robot::Bytes through = spoilt(into.first(good_->read(into)), lose_in, corrupt_in);
    std::copy(through.begin(), through.end(), into.begin());
    return through.size();
  }
  [[nodiscard]] bool do_is_up() const override { return !cut && good_->is_up(); }

  robot::ByteLink* good_;
  robot::RandomStream random_ = robot::RandomStream{20261122}.fork("faulty link");
  bool stalled_{false};
  robot::Bytes held_;
  robot::Bytes injected_;
};

}  // namespace sensotwin::twin
