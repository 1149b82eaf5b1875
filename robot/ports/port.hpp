// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "robot/base/time.hpp"
#include "robot/hal/byte_link.hpp"

namespace sensotwin::robot {

/// Counters since construction.
struct PortHealth {
  std::uint32_t opened{0};
  std::uint32_t lost{0};
  std::uint64_t bytes_read{0};
  std::uint64_t bytes_written{0};
  std::uint64_t writes_refused{0};  ///< down, or the peer takes nothing and the queue is full
};

/// A ByteLink that may have to be opened again: the main loop calls keep() once a step, before the drivers.
class Port : public ByteLink {
 public:
  /// Opens what is closed when it is time to try, and sends what waits. Never waits itself.
  /// \param now  never earlier than before
  void keep(Instant now) { do_keep(now); }
  /// Why it is down, for people: what failed and the system's reason. Empty while it is up, or untried.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  [[nodiscard]] const PortHealth& health() const { return health_; }

 protected:
  std::string trouble_;
  PortHealth health_;

 private:
  virtual void do_keep(Instant now) = 0;
};

}  // namespace sensotwin::robot
