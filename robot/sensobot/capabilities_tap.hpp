// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <variant>

#include "robot/hal/byte_link.hpp"
#include "robot/wire/llrp/codec.hpp"

namespace sensotwin::robot {

/// Listens to what a UHF reader says and keeps what it tells of itself, which its driver has no use for.
class CapabilitiesTap : public ByteLink {
 public:
  /// `inner` must outlive the tap.
  explicit CapabilitiesTap(ByteLink& inner) : inner_(inner) {}
  [[nodiscard]] const std::optional<llrp::GeneralCapabilities>& general() const { return general_; }

 private:
  bool do_write(ByteView bytes) override { return inner_.write(bytes); }
  [[nodiscard]] bool do_is_up() const override { return inner_.is_up(); }
  std::size_t do_read(std::span<std::uint8_t> into) override {
    const std::size_t size = inner_.read(into);
    for (ByteView rest = into.first(size); !rest.empty();) {
      const auto room = decoder_.room();
      const std::size_t part = std::min(room.size(), rest.size());
      std::copy_n(rest.begin(), part, room.begin());
      decoder_.received(part);
      rest = rest.subspan(part);
      while (const auto frame = decoder_.next()) {
        if (*frame) {
          take(**frame);
        }
      }
    }
    return size;
  }
  void take(const llrp::Frame& frame) {
    const auto message = llrp::decode(frame);
    if (!message) {
      return;
    }
    if (const auto* answer = std::get_if<llrp::GetReaderCapabilitiesResponse>(&*message)) {
      general_ = answer->general;
    }
  }

  ByteLink& inner_;
  llrp::FrameDecoder decoder_;
  std::optional<llrp::GeneralCapabilities> general_;
};

}  // namespace sensotwin::robot
