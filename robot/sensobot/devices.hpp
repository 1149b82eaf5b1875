// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/hal/no_device.hpp"
#include "robot/output/exit_codes.hpp"
#include "robot/ports/card_port.hpp"
#include "robot/ports/card_session.hpp"
#include "robot/ports/monotonic_clock.hpp"
#include "robot/ports/port.hpp"
#include "robot/settings/robot_file.hpp"
#include "robot/settings/robot_program.hpp"

namespace sensotwin::robot {

inline constexpr const char* kBaseName = "the Roomba";
inline constexpr const char* kSensorsName = "the sensor board";
inline constexpr const char* kUhfReaderName = "the UHF reader";
inline constexpr const char* kFloorReaderName = "the floor reader";
inline constexpr const char* kForwardReaderName = "the forward reader";

/// A device of the robot file, and how it is now.
struct DeviceState {
  std::string name;     ///< one of the above
  std::string address;  ///< as the file has it
  bool up{false};
  std::string trouble;  ///< why it is not up, for people
  std::string remedy;   ///< what to try then
};

/// The ports of a robot file, open or waiting for their devices.
class Devices {
 public:
  /// Opens nothing yet but the card readers, whose threads begin at once: the guardian is forked before.
  /// \param on_base_open  told of the base's descriptor each time that it is open
  Devices(const RobotFile& robot, const CardService& service, std::function<void(int)> on_base_open);

  /// Once a step, before the program. \param now  never earlier than before
  void keep(Instant now);
  [[nodiscard]] RobotLinks links();
  /// Waits until all are there.
  /// \param longest       of the clock's time
  /// \param interruption  asked every step
  /// \returns nothing when they are; else how the program ends, and it was said why
  [[nodiscard]] std::optional<ExitCode> wait_for_all(
      const MonotonicClock& clock, Duration longest,
      const std::function<std::optional<ExitCode>()>& interruption,
      const std::function<void(std::string_view)>& say);
  /// Of those that the file names, in its order.
  [[nodiscard]] std::vector<DeviceState> states() const;

 private:
  struct Slot {
    std::string name;
    std::string address;
    std::string remedy;
    std::unique_ptr<Port> port;      ///< or
    std::unique_ptr<CardPort> card;  ///< either
  };

  ByteLink& port_or_none(const char* name);
  CardLink& card_or_none(const char* name);

  std::vector<Slot> slots_;
  NoByteLink no_port_;
  NoCardLink no_card_;
};

}  // namespace sensotwin::robot
