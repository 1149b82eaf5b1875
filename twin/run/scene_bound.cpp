// SPDX-License-Identifier: MIT
#include "twin/run/scene_bound.hpp"

#include <algorithm>
#include <memory>

#include "twin/run/phase_config.hpp"
#include "world/radio/air.hpp"
#include "world/radio/radio.hpp"

namespace sensotwin::twin {
namespace {

/// Tags nearer each other than this make no leg (robot/phase/estimation, ceiling_mission_path.cpp).
constexpr double kShortest_m = 0.02;
/// Seed of the hop table. Chosen: any; one for all of a scene's seeds, so that they have one bound.
constexpr std::uint64_t kHopTable = 1;

/// What the scene's reader reads along a way, as far as the air is the same everywhere.
class Listener {
 public:
  Listener(const world::RadioWorld& world, const robot::RandomStream& random)
      : channels_hz_(world.radio.channels_hz), radio_(quiet(world), random) {}

  std::span<const robot::BoundRead> hear(const robot::BoundMotion& motion) {
    heard_.clear();
    for (const world::RadioRead& read :
         radio_.step({motion.begin_s, motion.end_s, motion.X_WR_begin, motion.X_WR_end})) {
      robot::UhfRead as_reported;
      as_reported.antenna = static_cast<std::uint16_t>(read.antenna + 1);
      as_reported.frequency_hz = channels_hz_[read.channel];
      as_reported.rssi_dbm = read.rssi_dbm;
      heard_.push_back({read.tag, as_reported});
    }
    return heard_;
  }

 private:
  static world::RadioWorld quiet(world::RadioWorld world) {
    world::RadioDescription& radio = world.radio;
    radio.place_sigma_rad = radio.place_sigma_db = radio.channel_sigma_db = radio.rssi_sigma_db = 0.0;
    radio.images = 0;
    radio.report_every = 1;
    radio.accumulate_reads = false;
    radio.report_latency_s = 0.0;
    return world;
  }

  std::vector<double> channels_hz_;
  world::Radio radio_;
  std::vector<robot::BoundRead> heard_;
};

/// Destinations that are there, each a way from the one before.
std::vector<std::size_t> route_of(const Scene& scene) {
  const std::vector<world::CeilingTag>& tags = scene.world.radio->tags;
  std::vector<std::size_t> route;
  for (const std::size_t tag : destinations_of(scene)) {
    if (tags[tag].present &&
        (route.empty() || (tags[tag].at_m - tags[route.back()].at_m).norm() > kShortest_m)) {
      route.push_back(tag);
    }
  }
  return route;
}

bool makes_a_circle(const Scene& scene, const std::vector<std::size_t>& route) {
  std::vector<robot::Vec2> places;
  places.reserve(route.size());
  for (const std::size_t tag : route) {
    places.push_back(scene.world.radio->tags[tag].at_m);
  }
  return robot::circle_through(places).has_value();
}

robot::PathBoundTask task_of(const Scene& scene, const world::RadioWorld& radio,
                             std::vector<std::size_t> route) {
  const robot::CeilingMissionConfig told = ceiling_config_of(scene, radio);
  robot::PathBoundTask task;
  task.reader = told.estimator.reader;
  task.wheels = told.estimator.wheels;
  task.height_sigma_m = told.estimator.height_sigma_m;
  for (const world::CeilingTag& tag : radio.tags) {
    task.tags_m.emplace_back(tag.at_m.x(), tag.at_m.y(), tag.height_m);
  }
  task.route = std::move(route);
  task.path = told.path;
  task.circle_left = told.circle_left;
  task.circle_radius_m = told.circle_radius_m;
  task.circle_laps = told.circle_laps;
  task.X_WR_start = scene.robot.X_WR_start;
  task.speed_mps = told.follower.speed_mps;
  task.tags_ahead = told.tags_ahead;
  task.tags_behind = told.tags_behind;
  return task;
}

}  // namespace

std::optional<SceneBound> bound_of(const Scene& scene) {
  if (!scene.mission.phase || !scene.world.radio) {
    return std::nullopt;
  }
  const std::vector<std::size_t> route = route_of(scene);
  const bool about = scene.mission.phase->path == PhasePath::kCircleAbout;
  if (route.empty() || (route.size() < 2 && !about) ||
      (scene.mission.phase->path == PhasePath::kCircle && !makes_a_circle(scene, route))) {
    return std::nullopt;
  }
  const robot::RandomStream random(kHopTable);
  const world::RadioWorld radio = radio_of(scene, random);
  robot::PathBoundTask task = task_of(scene, radio, route);
  const auto listener = std::make_shared<Listener>(radio, random.fork("radio"));
  task.hear = [listener](const robot::BoundMotion& motion) { return listener->hear(motion); };
  SceneBound bound;
  for (const std::size_t tag : route) {
    bound.legs.push_back(scene.world.radio->tags[tag].name);
  }
  if (about) {
    bound.legs = {"circle about " + bound.legs.front(), "laps"};
  }
  bound.bound = robot::posterior_bound(task);
  return bound;
}

std::optional<ImageBound> image_bound_of(const Scene& scene, int draws) {
  if (!scene.mission.phase || !scene.world.radio || scene.mission.phase->path != PhasePath::kPolyline) {
    return std::nullopt;
  }
  const std::vector<std::size_t> route = route_of(scene);
  const world::RadioWorld radio = radio_of(scene, robot::RandomStream(kHopTable));
  if (route.size() < 2 || radio.radio.images == 0 || !radio.radio.simultaneous) {
    return std::nullopt;
  }
  robot::PathBoundTask path = task_of(scene, radio, route);
  path.rate_hz = radio.radio.rate_hz;
  const ImageSources images{.count = radio.radio.images,
                            .amplitude = radio.radio.image_amplitude,
                            .nearest_m = world::kNearestImage_m,
                            .farthest_m = world::kFarthestImage_m};
  return image_bound({.path = std::move(path), .images = images, .draws = draws});
}

BoundResult figures_of(const SceneBound& bound) {
  return {.bound_m = bound.bound.rms_m,
          .bound_first_half_m = bound.bound.first_half_rms_m,
          .bound_second_half_m = bound.bound.second_half_rms_m};
}

}  // namespace sensotwin::twin
