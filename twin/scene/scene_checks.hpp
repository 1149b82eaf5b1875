// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "robot/config/field_reader.hpp"
#include "robot/config/problem.hpp"
#include "twin/scene/floor_plan.hpp"
#include "twin/scene/scene.hpp"

/// What each field alone cannot tell: whether the scene makes sense as a whole.
namespace sensotwin::twin {

class SceneChecks {
 public:
  /// \param reader  knows the places of what was written
  SceneChecks(const Scene& scene, const robot::FieldReader& reader, std::vector<robot::Problem>& problems)
      : scene_(scene), reader_(reader), problems_(problems) {}

  /// Outer wall and partitions, before anything is built on them. \returns false when they cannot be used.
  bool room();
  /// The carpet plan against the floor, before it is laid. \returns false when it would be far too large.
  bool carpet_size(const FloorPlan& floor);
  /// All that needs no floor: names, shapes, figures against each other.
  void by_itself();
  /// All that lies on the floor: carpet, furniture, markers, start.
  void on_floor(const FloorPlan& floor);

 private:
  void add(const std::string& path, std::string what, std::string hint);
  /// True when nothing at or below `path` is wrong already.
  [[nodiscard]] bool sound(const std::string& path) const;
  /// \returns false, and says so, when two neighbours of the list are too close for the physics to tell apart
  bool apart(const std::string& path, const std::vector<Vec2>& points, bool closed);
  void names();
  void shapes();
  void figures();
  void expectations();
  void radio();
  void reader_faults();
  void phase_mission();
  void exchanged_tags(const std::vector<std::string>& names);
  void carpet(const FloorPlan& floor);
  void furniture(const FloorPlan& floor);
  void markers(const FloorPlan& floor);
  void start(const FloorPlan& floor);

  const Scene& scene_;
  const robot::FieldReader& reader_;
  std::vector<robot::Problem>& problems_;
};

}  // namespace sensotwin::twin
