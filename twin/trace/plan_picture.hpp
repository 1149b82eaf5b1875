// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "robot/base/geometry.hpp"
#include "twin/scene/picture_file.hpp"

namespace sensotwin::twin {

/// A floor plan that somebody traces. Its place in the world is spelt as map_server spells it.
struct PlanPicture {
  std::string name;  ///< of the file
  std::string png;   ///< the picture, as a browser shows it
  int columns{0};
  int rows{0};
  double resolution_m{kUnscaled_m};  ///< side of a pixel
  bool scaled{false};                ///< false: nobody has said yet how large it is
  robot::Pose2 X_WO;                 ///< lower left corner of the picture; +y of W is the plan's north
  bool negate{false};                ///< map_server's: light is occupied
  double occupied_thresh{0.65};      ///< map_server's default
  double free_thresh{0.196};         ///< map_server's default

  /// Until somebody says better. Chosen: what map_server's maps mostly have.
  static constexpr double kUnscaled_m = 0.05;
};

/// Chosen: four times the largest published robot map at hand; a browser takes 160 MB for it.
inline constexpr std::size_t kPlanPixelsMax = 40'000'000;
/// Chosen: a 16-bit grey picture of that many pixels, half of it compressed away.
inline constexpr std::size_t kPlanBytesMax = 40'000'000;

/// A plan from a picture's bytes. \throws LoadError  kExitInvalid: no PNG or PGM, damaged, or too large, with
/// `name` as its source
[[nodiscard]] PlanPicture plan_from_bytes(const std::string& bytes, const std::string& name);

/// A plan from a picture, or from the YAML of a map_server map and the picture that it names.
/// \throws LoadError  kExitMissing, kExitInvalid
[[nodiscard]] PlanPicture read_plan(const std::filesystem::path& file);

/// The plan as a map_server map: a PGM, and the YAML that names it. Pixels finer than physics takes
/// (read_map()) are merged, the darkest of each group wins, so that thin walls stay. \param pgm_name  as the
/// YAML spells it \throws LoadError  kExitInvalid: the picture is damaged
struct MapFiles {
  std::string pgm;
  std::string yaml;
};
[[nodiscard]] MapFiles map_files(const PlanPicture& plan, const std::string& pgm_name);

}  // namespace sensotwin::twin
