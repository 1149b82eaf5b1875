// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "twin/cli/deed_support.hpp"
#include "twin/cli/deeds.hpp"
#include "twin/run/scene_bound.hpp"

namespace sensotwin::twin {
namespace {

std::string table_of(const SceneBound& bound) {
  const BoundResult figures = figures_of(bound);
  std::string table = fmt::format("{:>4}  {:<24} {:>10}\n", "leg", "to", "bound m");
  for (std::size_t leg = 0; leg < bound.bound.leg_rms_m.size(); ++leg) {
    const std::string rms = leg == 0 ? "not counted" : fmt::format("{:.5f}", bound.bound.leg_rms_m[leg]);
    table += fmt::format("{:>4}  {:<24} {:>10}\n", leg, bound.legs[leg], rms);
  }
  return table + fmt::format("{:<18} {:>10.5f}\n{:<18} {:>10.5f}\n{:<18} {:>10.5f}\n", "bound_m",
                             figures.bound_m, "bound_first_half_m", figures.bound_first_half_m,
                             "bound_second_half_m", figures.bound_second_half_m);
}

std::string table_of(const ImageBound& images) {
  return fmt::format("{:<18} {:>10.5f}\n{:<18} {:>10.5f}\n", "images_rms_m", images.rms_m, "images_median_m",
                     images.run_median_m);
}

std::string json_of(const Scene& scene, const SceneBound& bound, const std::optional<ImageBound>& images) {
  const BoundResult figures = figures_of(bound);
  nlohmann::ordered_json json{{"scene", scene.file},
                              {"variant", scene.variant},
                              {"bound_m", figures.bound_m},
                              {"bound_first_half_m", figures.bound_first_half_m},
                              {"bound_second_half_m", figures.bound_second_half_m}};
  json["legs"] = nlohmann::ordered_json::array();
  for (std::size_t leg = 1; leg < bound.bound.leg_rms_m.size(); ++leg) {
    json["legs"].push_back({{"leg", leg}, {"to", bound.legs[leg]}, {"bound_m", bound.bound.leg_rms_m[leg]}});
  }
  if (images) {
    json["images_rms_m"] = images->rms_m;
    json["images_median_m"] = images->run_median_m;
  }
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

robot::ExitCode bound_deed(const BoundOptions& options, Context& context) {
  const Scene scene = scene_of(options.choice);
  const std::optional<SceneBound> bound = bound_of(scene);
  if (!bound) {
    throw CommandError(robot::ExitCode::kInvalidData,
                       fmt::format("{}: no path along ceiling tags: mission.phase with two destinations that "
                                   "are there, or a circle",
                                   scene.file));
  }
  const std::optional<ImageBound> images = options.images ? image_bound_of(scene) : std::nullopt;
  if (options.images && !images) {
    throw CommandError(
        robot::ExitCode::kInvalidData,
        fmt::format("{}: --images needs world.radio.images above 0, antennas that read at once, "
                    "and mission.phase.path: polyline of two destinations",
                    scene.file));
  }
  context.out << (context.json ? json_of(scene, *bound, images)
                               : table_of(*bound) + (images ? table_of(*images) : ""));
  return robot::ExitCode::kDone;
}

}  // namespace sensotwin::twin
