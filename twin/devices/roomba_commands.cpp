// SPDX-License-Identifier: MIT
#include "twin/devices/roomba_commands.hpp"

#include <cstdio>
#include <variant>

#include "robot/wire/oi_drive.hpp"
#include "robot/wire/oi_stream.hpp"
#include "robot/wire/sci.hpp"

namespace sensotwin::twin {

namespace oi = robot::oi;

void RoombaCommands::obey(const oi::Command& command) {
  const oi::OpcodeInfo& info = *board.table_->find(static_cast<std::uint8_t>(oi::opcode_of(command)));
  if (!oi::contains(info.modes, board.mode_)) {
    return;
  }
  if (info.becomes) {
    board.enter(*info.becomes);
  }
  std::visit([this](const auto& one) { on(one); }, command);
}

void RoombaCommands::print_welcome() {
  if (board.is_sci()) {
    return;
  }
  const FirmwareVersion& version = board.config_.firmware;
  std::array<char, 96> text{};
  const int size = std::snprintf(text.data(), text.size(),
                                 "bl-start\r\nRoomba by iRobot!\r\nr3_robot/tags/release-%d.%d.%d\r\n",
                                 version.major, version.minor, version.patch);
  board.queue({reinterpret_cast<const std::uint8_t*>(text.data()), static_cast<std::size_t>(size)});
}

template <oi::Opcode kCode>
void RoombaCommands::on(const oi::NoData<kCode>&) {
  if constexpr (kCode == oi::Opcode::kReset) {
    board.boot();
    print_welcome();
  } else if constexpr (kCode == oi::Opcode::kPower) {
    board.fall_asleep();
  }
}

void RoombaCommands::on(const oi::Baud& baud) {
  if (baud.code < oi::kBauds.size()) {
    board.baud_ = oi::kBauds[baud.code];
  }
}

void RoombaCommands::on(const oi::Drive& drive) {
  board.requested_drive_ = std::get<oi::Drive>(oi::clamped(drive));
  const robot::WheelSpeeds wheels =
      oi::wheel_speeds(board.requested_drive_, board.config_.body.wheel_base_m, board.is_sci());
  board.request_wheels(wheels.left_mps, wheels.right_mps);
}

void RoombaCommands::on(const oi::DriveDirect& drive) {
  board.requested_direct_ = std::get<oi::DriveDirect>(oi::clamped(drive));
  const robot::WheelSpeeds wheels = oi::wheel_speeds(board.requested_direct_);
  board.request_wheels(wheels.left_mps, wheels.right_mps);
}

/// An unloaded motor's speed is proportional to its duty cycle.
void RoombaCommands::on(const oi::DrivePwm& drive) {
  const auto duty = std::get<oi::DrivePwm>(oi::clamped(drive));
  const double full_mps = board.config_.body.speed_max_mps / 255.0;
  board.request_wheels(duty.left * full_mps, duty.right * full_mps);
}

void RoombaCommands::on(const oi::Motors& motors) {
  const auto duty = [&](int on_bit, int opposite_bit) {
    return (motors.bits & on_bit) == 0 ? 0.0 : (motors.bits & opposite_bit) != 0 ? -1.0 : 1.0;
  };
  // The Roomba 400 has bits 0 to 2 only.
  const int opposite = board.is_sci() ? 0 : 0xFF;
  board.outputs_.side_brush = duty(oi::Motors::kSideBrush, oi::Motors::kSideBrushClockwise & opposite);
  board.outputs_.main_brush = duty(oi::Motors::kMainBrush, oi::Motors::kMainBrushOutward & opposite);
  board.outputs_.vacuum = duty(oi::Motors::kVacuum, 0);
}

void RoombaCommands::on(const oi::PwmMotors& motors) {
  constexpr double kFull = 128.0;  // page 15: "max 128"
  const auto duty = std::get<oi::PwmMotors>(oi::clamped(motors));
  board.outputs_.main_brush = duty.main_brush / kFull;
  board.outputs_.side_brush = duty.side_brush / kFull;
  board.outputs_.vacuum = duty.vacuum / kFull;
}

void RoombaCommands::on(const oi::Leds& leds) {
  board.panel_.leds = leds;
}

void RoombaCommands::on(const oi::SchedulingLeds& leds) {
  board.panel_.scheduling = leds;
}

void RoombaCommands::on(const oi::DigitLedsRaw&) {}

void RoombaCommands::on(const oi::DigitLedsAscii& digits) {
  board.panel_.digits = digits;
}

void RoombaCommands::on(const oi::Buttons& buttons) {
  constexpr int kPushTicks = 11;  // 1/6 s (page 17) in ticks of 15 ms
  board.pushed_buttons_ = buttons.bits;
  board.pushed_ticks_ = kPushTicks;
}

void RoombaCommands::on(const oi::Schedule&) {}

void RoombaCommands::on(const oi::SetDayTime&) {}

std::size_t RoombaCommands::songs() const {
  constexpr std::size_t kOpenInterfaceSongs = 5;  // page 19: numbers 0 to 4
  return board.is_sci() ? robot::sci::kSongs : kOpenInterfaceSongs;
}

void RoombaCommands::on(const oi::Song& song) {
  if (song.number < songs()) {
    board.songs_[song.number] = song;
  }
}

void RoombaCommands::on(const oi::Play& play) {
  if (play.number >= songs() || board.song_playing()) {
    return;
  }
  board.song_number_ = play.number;
  const oi::Song& song = board.songs_[play.number];
  for (std::size_t i = 0; i < song.length; ++i) {
    board.song_left_s_ += song.notes[i].sixty_fourths_s / 64.0;
  }
}

void RoombaCommands::on(const oi::Sensors& sensors) {
  board.answer(sensors.id);
}

void RoombaCommands::on(const oi::QueryList& query) {
  for (const std::uint8_t id : query.ids()) {
    board.answer(id);
  }
}

void RoombaCommands::on(const oi::Stream& stream) {
  board.stream_ = {};
  board.stream_has_motion_ = false;
  for (const std::uint8_t id : stream.ids()) {
    if (oi::packet_run(id).size > 0) {
      board.stream_.id[board.stream_.count++] = id;
      board.stream_has_motion_ |=
          oi::covers(id, oi::PacketId::kDistance) || oi::covers(id, oi::PacketId::kAngle);
    }
  }
  board.layout_ = oi::StreamLayout::of(board.stream_.ids());
  board.streaming_ = board.stream_.count > 0;
}

void RoombaCommands::on(const oi::PauseResume& pause) {
  board.streaming_ = pause.running != 0 && board.stream_.count > 0;
}

}  // namespace sensotwin::twin
