// SPDX-License-Identifier: MIT
#pragma once

#include <poll.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sensotwin::twin {

/// Counters of one wire since it was opened.
struct WireTally {
  std::uint64_t clients{0};        ///< that came
  std::uint64_t refused{0};        ///< of these, sent away
  std::uint64_t bytes_in{0};       ///< from clients
  std::uint64_t bytes_out{0};      ///< to clients
  std::uint64_t bytes_dropped{0};  ///< lost because a client did not take them in time
  std::uint64_t reports_lost{0};   ///< LLRP: that nobody took, or nobody was there for
};

/// One emulated device, joined to what the operating system shows of it. Nothing here ever waits, and nothing
/// grows because a client is slow: what it does not take is lost, as on the machine, and counted.
class Wire {
 public:
  explicit Wire(std::string name) : name_(std::move(name)) {}
  virtual ~Wire() = default;
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;

  /// Adds what is worth waking up for.
  void watch(std::vector<pollfd>& handles) const { do_watch(handles); }
  /// Moves what can be moved, both ways. \param wall_s  real time, never going back
  void pump(double wall_s) { do_pump(wall_s); }

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Somebody is at the other end.
  [[nodiscard]] bool has_client() const { return do_has_client(); }
  [[nodiscard]] const WireTally& tally() const { return tally_; }

 protected:
  WireTally tally_;  // NOLINT(cppcoreguidelines-non-private-member-variables-in-classes): the implementer's

 private:
  virtual void do_watch(std::vector<pollfd>& handles) const = 0;
  virtual void do_pump(double wall_s) = 0;
  [[nodiscard]] virtual bool do_has_client() const = 0;

  std::string name_;
};

}  // namespace sensotwin::twin
