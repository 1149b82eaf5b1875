// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <chrono>
#include <utility>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"
#include "robot/ports/descriptor.hpp"

namespace sensotwin::robot {

struct GuardianConfig {
  /// Without a beat for so long the robot is told to stop. Chosen: four control steps; with the 5 ms that the
  /// stop takes on the line it is within the 100 ms that are promised.
  std::chrono::milliseconds silent_after{60};
  Bytes stop;      ///< said when the beats stop
  Bytes farewell;  ///< said after it when the program is gone for good
};

/// A second process that stops the robot when the first cannot: killed, crashed, hung or stopped in a
/// debugger. A Roomba has no time-out of its own; it drives on at its last speed.
///
/// It is forked off before any port is open or thread runs, holds a copy of the serial port's descriptor, and
/// listens to a socket whose other end only the program has: the kernel closes that one whatever ends the
/// program. It is in a session of its own and ignores the terminal's signals. What it cannot help: a cable
/// that is pulled, a computer that loses power (docs/hardware.md).
class Guardian {
 public:
  /// Forks. \returns the guardian, or errno's number when there can be none
  [[nodiscard]] static Result<Guardian, int> begin(const GuardianConfig& config);
  Guardian(Guardian&&) noexcept = default;
  Guardian& operator=(Guardian&&) noexcept = default;
  Guardian(const Guardian&) = delete;
  Guardian& operator=(const Guardian&) = delete;
  /// As when the program dies: the guardian stops the robot, unless it was released.
  ~Guardian() = default;

  /// Gives it the port, in place of an earlier one. \returns false when it is gone
  bool watch(int serial_port);
  /// "I live": once a step. Silence counts from the first beat on. \returns false when it is gone
  bool beat();
  /// Sends it home without a word: the program has stopped the robot itself.
  void release();
  [[nodiscard]] pid_t pid() const { return pid_; }

 private:
  Guardian(Descriptor socket, pid_t pid) : socket_(std::move(socket)), pid_(pid) {}

  Descriptor socket_;
  pid_t pid_;
};

}  // namespace sensotwin::robot
