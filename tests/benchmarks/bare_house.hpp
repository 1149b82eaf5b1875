// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "robot/base/geometry.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// The yardstick: the twin's house in Box2D and nothing else. The same walls, fixed furniture and shell as
/// fixtures, the same step, iterations and continuous collision (off), driven where the twin went. No wheels,
/// no sensors, no tags, no bytes, no program: what any twin built on Box2D has to pay.
class BareHouse {
 public:
  /// \param path  the twin's poses in W: at the start, then after each tick
  /// \pre no pushable furniture stands in the scene
  BareHouse(const Scene& scene, const std::vector<robot::Pose2>& path);
  ~BareHouse();

  /// Puts the robot back to the start.
  void restart();
  /// One tick of 15 ms. \pre fewer than ticks() since the last restart
  void tick();

  [[nodiscard]] std::size_t ticks() const;
  /// The farthest that any tick ended from the twin's pose, m.
  [[nodiscard]] double farthest_m() const;
  /// Steps of one whole drive at whose end the shell touched something.
  [[nodiscard]] std::uint64_t touching_steps() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sensotwin::twin
