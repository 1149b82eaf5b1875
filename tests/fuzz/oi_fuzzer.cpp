// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "robot/base/random.hpp"
#include "robot/base/time.hpp"
#include "tests/fuzz/fuzzers.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/oi_parts.hpp"
#include "twin/devices/emulated_roomba.hpp"

namespace sensotwin::fuzz {
namespace {

using robot::Bytes;
using robot::ByteView;
using robot::oi::Mode;

/// Anything a Roomba may meet, rarely.
void meet_something(world::RoombaInputs& in, robot::RandomStream& random) {
  const auto now_and_then = [&random] { return random.below(16) == 0; };
  in.bump_left = now_and_then();
  in.wheel_drop_right = now_and_then();
  in.cliff[random.below(4)] = now_and_then();
  in.on_home_base = now_and_then();
  in.power = !now_and_then();
  in.buttons = static_cast<std::uint8_t>(random.below(256));
  in.wheel_angle_left_rad += random.uniform(-1.0, 1.0);
  in.wheel_angle_right_rad += random.uniform(-1.0, 1.0);
  in.battery_mv = static_cast<std::uint16_t>(random.below(65536));
  in.battery_ma = static_cast<std::int16_t>(static_cast<int>(random.below(65536)) - 32768);
  in.battery_charge_mah = random.uniform(0.0, 3000.0);
  in.battery_capacity_mah = random.uniform(0.0, 3000.0);
}

void check_outputs(const twin::EmulatedRoomba& board, const world::RoombaOutputs& out, double speed_max_mps) {
  const auto within = [](double value, double limit) {
    return std::isfinite(value) && std::abs(value) <= limit;
  };
  require(within(out.wheel_left_mps, speed_max_mps) && within(out.wheel_right_mps, speed_max_mps),
          "no wheel is asked for more than it can");
  require(within(out.main_brush, 1.0) && within(out.side_brush, 1.0) && within(out.vacuum, 1.0),
          "no motor is asked for more than all");
  const bool controlled = board.mode() == Mode::kSafe || board.mode() == Mode::kFull;
  require(controlled || (out.wheel_left_mps == 0.0 && out.wheel_right_mps == 0.0),
          "wheels stand unless the mode is safe or full");
}

/// A mainboard obeys any bytes within its limits, says no more than the line carries, and does not care how
/// the bytes of one tick were cut.
void board(ByteView input, std::size_t piece, std::uint64_t seed, world::RoombaKind kind) {
  twin::EmulatedRoombaConfig config;
  config.body.kind = kind;
  twin::EmulatedRoomba whole{config};
  twin::EmulatedRoomba torn{config};
  robot::RandomStream random{seed};
  world::RoombaInputs in;
  Script script{input};
  std::array<std::uint8_t, 1024> from_whole{};
  std::array<std::uint8_t, 1024> from_torn{};
  while (!script.empty()) {
    const ByteView bytes = script.bytes(piece);
    whole.receive(bytes);
    for (const std::uint8_t& byte : bytes) {
      torn.receive({&byte, 1});
    }
    if (seed != 0) {  // at seed 0 nothing happens to the robot but its client
      meet_something(in, random);
    }
    check_outputs(whole, whole.tick(in), config.body.speed_max_mps);
    static_cast<void>(torn.tick(in));
    if (random.below(8) == 0) {
      whole.pulse_brc();
      torn.pulse_brc();
    }
    const std::size_t count = whole.drain(from_whole);
    const double carried = whole.baud() * robot::to_s(robot::kTick) / 10.0;
    require(static_cast<double>(count) <= std::max(1.0, carried), "no more leaves than the line carries");
    require(torn.drain(from_torn) == count &&
                std::equal(from_whole.begin(), from_whole.begin() + static_cast<std::ptrdiff_t>(count),
                           from_torn.begin()) &&
                torn.mode() == whole.mode(),
            "torn commands are the same commands");
  }
}

}  // namespace

void oi(ByteView input) {
  Script script{input};
  const std::size_t piece = 1u + script.byte() % 64u;
  const std::uint8_t seed = script.byte();
  const ByteView bytes = script.rest();
  oi_commands(bytes, robot::oi::kOpenInterface);
  oi_commands(bytes, robot::oi::kSerialCommandInterface);
  oi_frames(bytes, piece);
  oi_payload(bytes);
  oi_answers(bytes);
  oi_driver(bytes, piece, false);
  oi_driver(bytes, piece, true);
  board(bytes, piece, seed, world::RoombaKind::kCreate2);
  board(bytes, piece, seed, world::RoombaKind::kRoomba400);
}

}  // namespace sensotwin::fuzz
