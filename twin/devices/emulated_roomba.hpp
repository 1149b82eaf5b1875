// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "robot/base/bytes.hpp"
#include "robot/hal/byte_link.hpp"
#include "robot/wire/oi_commands.hpp"
#include "robot/wire/oi_packets.hpp"
#include "robot/wire/oi_stream_layout.hpp"
#include "robot/wire/ticks.hpp"
#include "twin/devices/wheel_counter.hpp"
#include "world/description.hpp"
#include "world/roomba_io.hpp"

namespace sensotwin::twin {

struct FirmwareVersion {
  int major{3};
  int minor{7};
  int patch{7};
  auto operator<=>(const FirmwareVersion&) const = default;
};

/// How one mainboard differs from another. The errata are those of the manual's Appendix B and of its users;
/// the firmware's own follow from its version.
struct EmulatedRoombaConfig {
  /// Kind, wheels and wheel base.
  world::RoombaDescription body{};
  /// A version seen on Create 2 of 2018. Before 3.3.0 lengths in mm (packets 19 and 40) are wrong: minus a
  /// tenth (what Player undoes by -10); up to 3.4.0 angles are 0.324056 times the degrees.
  FirmwareVersion firmware{};
  /// Packet 35 is one above the mode (some 600s with Wi-Fi).
  bool mode_one_too_high{false};
  /// Fractions of a degree are thrown away at each read instead of kept (Create 1).
  bool truncate_angle{false};
  /// Of packet 19; some 630s are about 10 % low.
  double distance_scale{1.0};
  /// Wheels run at multiples of this: "steps of about 28.5 mm/s" (pages 13 and 14). 0: any speed.
  double speed_step_mps{0.0285};
  /// Where the encoders begin at power-on.
  robot::Ticks encoder_start_left{};
  robot::Ticks encoder_start_right{};
  /// Packet 14 reports motors above this. Chosen: twice what a wheel draws on carpet.
  int overcurrent_ma{1500};
  /// Light bumper bits are set from this signal on, of 4095. Chosen; the manual names no threshold.
  int light_bump_threshold{100};
  /// Packet 8 is set from this wall signal on, of 1023. Chosen: the same fraction of the range.
  int wall_threshold{25};
};

/// Lamps and display of the top panel.
struct RoombaPanel {
  robot::oi::Leds leds{};
  robot::oi::SchedulingLeds scheduling{};
  robot::oi::DigitLedsAscii digits{};
};

/// The mainboard of a Roomba: what answers at the serial port, and drives motors from what it was told and
/// what its sensors see. Open Interface for the Create 2, SCI for the 400 series. Sources: Create 2 Open
/// Interface (2016); Roomba SCI (2005). Where they are silent: out-of-range speeds and radii are clamped;
/// unknown packets are not answered; safe mode entered over a cliff falls back at once; turning in place
/// counts as moving towards a cliff; a song asked for while another plays is not played.
///
/// Leaves out: cleaning cycles and docking by itself (134, 135, 136, 143 change the mode, the wheels stand);
/// opcode 163, which real firmware does not obey either; reception at a wrong baud rate.
class EmulatedRoomba {
 public:
  explicit EmulatedRoomba(const EmulatedRoombaConfig& config = {});

  /// Bytes from the client; commands act at once. Lost while asleep or without power.
  void receive(robot::ByteView bytes);
  /// One sensor update: samples the inputs, reacts, queues a stream frame, lets the line send 15 ms' worth.
  world::RoombaOutputs tick(const world::RoombaInputs& inputs);
  /// Moves bytes that have left on the line into `into`, at most 172 in a tick at 115200 baud. \returns their
  /// number
  std::size_t drain(std::span<std::uint8_t> into);
  /// A pulse on the BRC pin: ends sleep, restarts the five minutes before the next.
  void pulse_brc();

  [[nodiscard]] robot::oi::Mode mode() const { return mode_; }
  [[nodiscard]] bool asleep() const { return asleep_; }
  [[nodiscard]] int baud() const { return baud_; }
  [[nodiscard]] bool song_playing() const { return song_left_s_ > 0.0; }
  [[nodiscard]] const RoombaPanel& panel() const { return panel_; }
  /// Bytes lost because the client asked for more than the line carries.
  [[nodiscard]] std::uint64_t bytes_overrun() const { return bytes_overrun_; }

 private:
  friend struct RoombaCommands;

  [[nodiscard]] bool is_sci() const { return config_.body.kind == world::RoombaKind::kRoomba400; }
  void boot();
  void enter(robot::oi::Mode mode);
  void stop_motors();
  void fall_asleep();
  void request_wheels(double left_mps, double right_mps);
  [[nodiscard]] bool charger_present() const { return inputs_.on_home_base || inputs_.internal_charger; }
  [[nodiscard]] bool must_leave_safe_mode() const;
  void react_to_hazards();
  void count_wheels();
  void run_timers();
  void update_values();
  void update_motion_values();
  void clear_motion(std::uint8_t id);
  void queue(robot::ByteView bytes);
  void answer(std::uint8_t id);
  void queue_stream_frame();

  EmulatedRoombaConfig config_;
  const robot::oi::OpcodeTable* table_;
  robot::oi::CommandDecoder decoder_;
  world::RoombaInputs inputs_;
  world::RoombaOutputs outputs_;
  robot::oi::SensorValues values_;
  RoombaPanel panel_;

  robot::oi::Mode mode_{robot::oi::Mode::kOff};
  bool powered_{true};
  bool asleep_{false};
  int quiet_ticks_{0};
  int baud_;

  robot::oi::Drive requested_drive_;
  robot::oi::DriveDirect requested_direct_;
  WheelCounter left_;
  WheelCounter right_;
  double distance_mm_{0.0};  ///< since last read, as packet 19 will tell it
  double angle_{0.0};        ///< since last read, in the unit of packet 20

  std::array<robot::oi::Song, 16> songs_{};
  std::uint8_t song_number_{0};
  double song_left_s_{0.0};
  std::uint8_t pushed_buttons_{0};
  int pushed_ticks_{0};

  robot::oi::Stream stream_;
  std::optional<robot::oi::StreamLayout> layout_;  ///< nothing when what was asked for fits into no frame
  bool streaming_{false};
  bool stream_has_motion_{false};  ///< distance or angle, which each frame clears

  /// What waits for the line. A client that asks for too much fills it, and what does not fit is lost: "the
  /// data stream will eventually become corrupted" (page 22). Size chosen: three ticks at 115200 baud.
  static constexpr std::size_t kLineBytes = 512;
  std::array<std::uint8_t, kLineBytes> line_{};
  std::size_t line_begin_{0};
  std::size_t line_held_{0};
  std::size_t line_allowance_{0};  ///< bytes that may still leave in this tick
  std::uint64_t bytes_overrun_{0};
};

/// The emulated serial port, client's end.
class EmulatedSerial : public robot::ByteLink {
 public:
  /// `roomba` must outlive the port.
  explicit EmulatedSerial(EmulatedRoomba& roomba) : roomba_(roomba) {}

 private:
  bool do_write(robot::ByteView bytes) override {
    roomba_.receive(bytes);
    return true;
  }
  std::size_t do_read(std::span<std::uint8_t> into) override { return roomba_.drain(into); }

  EmulatedRoomba& roomba_;
};

}  // namespace sensotwin::twin
