// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sensotwin::twin {

/// What a bare loop needs of a house and of the twin's drive through it, in Box2D's frame and single
/// precision.
struct BareLoopInput {
  struct Edge {
    float ax_m, ay_m, bx_m, by_m;
  };
  struct Disc {
    float x_m, y_m, radius_m;
  };
  struct Way {
    float x_m, y_m;  ///< where the twin was at the end of the tick
    float turn_rad;  ///< how far it turned in it
  };
  std::vector<Edge> edges;
  std::vector<Disc> discs;
  float x_m{0.0F};
  float y_m{0.0F};
  float yaw_rad{0.0F};
  std::vector<Way> ticks;
  float shell_radius_m{0.0F};
  float mass_kg{0.0F};
  float tick_s{0.0F};
  int steps_per_tick{1};
};

/// The yardstick: the twin's house in Box2D and nothing else. The same walls, fixed furniture and shell as
/// fixtures, the same step, iterations and continuous collision (off), driven where the twin went. No wheels,
/// no sensors, no tags, no bytes, no program: what any twin built on Box2D has to pay.
class BareLoop {
 public:
  BareLoop() = default;
  BareLoop(const BareLoop&) = delete;
  BareLoop& operator=(const BareLoop&) = delete;
  virtual ~BareLoop() = default;
  /// Puts the robot back to the start.
  virtual void restart() = 0;
  /// Goes through ticks [first, last), 15 ms each.
  virtual void run(std::size_t first, std::size_t last) = 0;
  /// The farthest that any tick ended from the twin's place, m.
  [[nodiscard]] virtual double farthest_m() const = 0;
  /// Steps of one whole drive at whose end the shell touched something.
  [[nodiscard]] virtual std::uint64_t touching_steps() const = 0;
};

}  // namespace sensotwin::twin

/// Built twice: into the benchmark, where Box2D's clock stands (world/box2d_clock.hpp), and into a library
/// that is loaded apart from it, with a Box2D as it was installed. The caller deletes the result.
extern "C" sensotwin::twin::BareLoop* make_bare_loop(const sensotwin::twin::BareLoopInput& input);
