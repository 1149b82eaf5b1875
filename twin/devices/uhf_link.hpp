// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/base/bytes.hpp"
#include "robot/base/time.hpp"
#include "robot/hal/byte_link.hpp"

namespace sensotwin::twin {

class EmulatedUhfReader;

/// The in-memory stand-in for a TCP connection between a client and an emulated UHF reader. Dials by itself:
/// at the first step, and again a while after a connection has ended. Takes faults: a cut cable, silence in
/// the line, bytes that nobody sent, bytes that get lost.
class UhfLink final : public robot::ByteLink {
 public:
  UhfLink(EmulatedUhfReader& reader, robot::Duration redial_after)
      : reader_(reader), redial_after_(redial_after) {}

  /// Called by the reader's step().
  void step(robot::Instant now);

  /// The connection ends now, whatever is under way, and nobody dials before mend().
  void cut();
  void mend() { cut_ = false; }
  /// Nothing passes either way, as when a network stalls; what was written comes through when it ends.
  void set_silent(bool silent);
  /// The client reads these bytes before anything else.
  void inject(robot::ByteView bytes);
  /// The next so many bytes to the client are lost.
  void lose(std::size_t bytes) { lose_ = bytes; }

 private:
  bool do_write(robot::ByteView bytes) override;
  std::size_t do_read(std::span<std::uint8_t> into) override;
  [[nodiscard]] bool do_is_up() const override;

  EmulatedUhfReader& reader_;
  robot::Duration redial_after_;
  std::optional<robot::Instant> dial_at_{robot::Instant{}};
  bool cut_{false};
  bool silent_{false};
  std::size_t lose_{0};
  robot::Bytes injected_;
  robot::Bytes written_;  ///< while the line was silent
};

}  // namespace sensotwin::twin
