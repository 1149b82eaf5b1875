// SPDX-License-Identifier: MIT
#pragma once

#include "robot/wire/oi_commands.hpp"
#include "twin/devices/emulated_roomba.hpp"

namespace sensotwin::twin {

/// What the mainboard does at each command: the other half of EmulatedRoomba, one function for each.
struct RoombaCommands {
  EmulatedRoomba& board;

  /// Does nothing in modes that forbid the command.
  void obey(const robot::oi::Command& command);
  /// The text after power-on and reset, abridged to the lines clients look for (page 27: the version).
  void print_welcome();

 private:
  template <robot::oi::Opcode kCode>
  void on(const robot::oi::NoData<kCode>&);
  void on(const robot::oi::Baud& baud);
  void on(const robot::oi::Drive& drive);
  void on(const robot::oi::DriveDirect& drive);
  void on(const robot::oi::DrivePwm& drive);
  void on(const robot::oi::Motors& motors);
  void on(const robot::oi::PwmMotors& motors);
  void on(const robot::oi::Leds& leds);
  void on(const robot::oi::SchedulingLeds& leds);
  void on(const robot::oi::DigitLedsRaw& digits);
  void on(const robot::oi::DigitLedsAscii& digits);
  void on(const robot::oi::Buttons& buttons);
  void on(const robot::oi::Schedule& schedule);
  void on(const robot::oi::SetDayTime& time);
  void on(const robot::oi::Song& song);
  void on(const robot::oi::Play& play);
  void on(const robot::oi::Sensors& sensors);
  void on(const robot::oi::QueryList& query);
  void on(const robot::oi::Stream& stream);
  void on(const robot::oi::PauseResume& pause);
  [[nodiscard]] std::size_t songs() const;
};

}  // namespace sensotwin::twin
