// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "robot/base/random.hpp"
#include "world/description.hpp"
#include "world/obstacles.hpp"
#include "world/roomba_io.hpp"
#include "world/tag_field.hpp"

namespace sensotwin::world {

/// What happened since the start, for logs and verdicts.
struct ContactCounts {
  std::uint64_t wall{0};    ///< times the shell came to touch something fixed
  std::uint64_t push{0};    ///< times the shell came to touch something that can be pushed, or somebody
  std::uint64_t shoves{0};  ///< times somebody turned it
  bool touching_wall{false};
  bool touching_pushable{false};
};

/// The physical truth: one Roomba in one house, seen from above. See world/README.md for its laws.
///
/// Deterministic: equal descriptions and seed give equal bits on the same machine, whatever else the process
/// does. One thread at a time; different worlds may live in different threads.
class World {
 public:
  /// Obeys the descriptions; they are checked by the scene reader and only asserted here. `random` is the
  /// run's stream; the world forks what it needs by name and draws nothing from it.
  World(const WorldDescription& world, const RobotDescription& robot, const PhysicsDescription& physics,
        const robot::RandomStream& random);
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// One 15 ms tick under the outputs, held for its whole length.
  void tick(const RoombaOutputs& outputs);
  /// What the mainboard samples at the end of the last tick. Bump bits are true when the shell was pressed at
  /// any step within it.
  [[nodiscard]] RoombaInputs roomba_inputs() const;

  /// Truth, for logs, pictures and verdicts. Never hand it to robot/.
  [[nodiscard]] Pose2 X_WR() const;
  /// One pose for each piece of furniture, in the order of the description. Valid until the next tick.
  [[nodiscard]] std::span<const Pose2> X_WF() const;
  [[nodiscard]] const ContactCounts& contacts() const;
  /// Who walks or stands about now, in W.
  [[nodiscard]] std::vector<Disc> people() const;

  /// Tags as they are and where they are now. Valid until the next tick.
  [[nodiscard]] std::span<const Tag> tags() const;
  /// The chip of a tag, to read and write. \pre tag < tags().size()
  [[nodiscard]] TagMemory& tag_memory(TagIndex tag);
  /// The carpet tag, or floor tag below a ceiling tag or in a hallway, that answers the floor antenna now; of
  /// both, the nearer.
  [[nodiscard]] std::optional<TagIndex> floor_tag() const;
  /// The landmark or furniture tag that answers the forward antenna now.
  [[nodiscard]] std::optional<TagIndex> forward_tag() const;

  /// One compass reading: clockwise from magnetic north, rad in [0, 2 pi). Draws noise each time it is asked.
  [[nodiscard]] double compass_heading_rad();

  /// One reading of every rangefinder, m, left to right; nothing where no echo is heard, empty without
  /// rangefinders. Draws noise each time it is asked.
  [[nodiscard]] std::vector<std::optional<double>> sonar_ranges_m();

  /// Kinetic energy of robot and furniture, J.
  [[nodiscard]] double energy_j() const;
  /// Work the wheels have done on the robot since the start, J; braking counts negative.
  [[nodiscard]] double work_j() const;
  /// FNV-1a by 64-bit words over every bit of moving state: bodies, wheels, battery. For tests of determinism
  /// and for summaries, once a tick.
  [[nodiscard]] std::uint64_t state_hash() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sensotwin::world
