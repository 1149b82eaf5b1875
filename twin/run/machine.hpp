// SPDX-License-Identifier: MIT
#pragma once

#include "robot/base/random.hpp"
#include "robot/base/time.hpp"
#include "robot/settings/robot_settings.hpp"
#include "twin/devices/emulated_card_reader.hpp"
#include "twin/devices/emulated_roomba.hpp"
#include "twin/devices/emulated_sensor_board.hpp"
#include "twin/output/state_hash.hpp"
#include "twin/scene/scene.hpp"
#include "world/radio/radio.hpp"
#include "world/world.hpp"

namespace sensotwin::twin {

/// What every twin has, whatever its mission: the world, and in it the emulated Roomba, the floor antenna and
/// the sensor board, with the ends of their wires. Neither copies nor moves: the serial line refers to the
/// Roomba.
class Machine {
 public:
  /// \param random  the run's; everything here forks from it by name
  Machine(const Scene& scene, const robot::RandomStream& random);
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  /// The world goes on by one tick. \returns how the robot moved in it
  world::RobotMotion tick_world();
  /// The devices see where it came to.
  void tick_devices();
  /// After whatever else the tick holds: its state enters the hash.
  void close_tick() { hash_.add(world_.state_hash()); }

  [[nodiscard]] robot::Instant now() const { return now_; }
  [[nodiscard]] world::World& world() { return world_; }
  [[nodiscard]] const world::World& world() const { return world_; }
  /// What the mainboard sampled last.
  [[nodiscard]] const world::RoombaInputs& inputs() const { return inputs_; }
  [[nodiscard]] const StateHash& hash() const { return hash_; }

  [[nodiscard]] EmulatedRoomba& roomba() { return roomba_; }
  [[nodiscard]] robot::ByteLink& serial() { return serial_; }
  [[nodiscard]] robot::CardLink& floor_reader() { return floor_reader_; }
  [[nodiscard]] robot::ByteLink& sensor_board() { return sensor_board_; }

 private:
  world::World world_;
  world::RoombaInputs inputs_;
  world::RoombaOutputs outputs_;
  EmulatedRoomba roomba_;
  EmulatedSerial serial_;
  EmulatedCardReader floor_reader_;
  EmulatedSensorBoard sensor_board_;
  robot::Instant now_;
  StateHash hash_;
};

/// What the robot knows of itself and of its task; of a radio, see phase_config.hpp. The same keys configure
/// the machine.
[[nodiscard]] robot::RobotSettings robot_settings_of(const Scene& scene);

}  // namespace sensotwin::twin
