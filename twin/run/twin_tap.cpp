// SPDX-License-Identifier: MIT
#include "twin/run/twin_tap.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/output/text_format.hpp"
#include "twin/run/recovered_map.hpp"
#include "twin/run/scene_views.hpp"

namespace sensotwin::twin {
namespace {

void append_point(std::string& to, const Vec2& p_m) {
  char text[32];
  to += '[';
  to.append(text, robot::put_fixed<3>(text, p_m.x()));
  to += ',';
  to.append(text, robot::put_fixed<3>(text, p_m.y()));
  to += ']';
}

void append_points(std::string& to, const std::vector<Vec2>& points_m) {
  to += '[';
  for (const Vec2& p_m : points_m) {
    if (to.back() != '[') {
      to += ',';
    }
    append_point(to, p_m);
  }
  to += ']';
}

/// Objects in a JSON list, each begun by this.
void begin_item(std::string& list) {
  list += list.back() == '[' ? "{\"-\":0" : ",{\"-\":0";
}

std::string walls_of(const Scene& scene) {
  std::string list = ",\"walls\":[";
  for (const world::Wall& wall : scene.world.walls) {
    begin_item(list);
    robot::append_json_fields(list, {{"closed", wall.closed}});
    list += ",\"points\":";
    append_points(list, {wall.points_m.begin(), wall.points_m.end()});
    list += '}';
  }
  return list + ']';
}

std::string furniture_of(const render::SceneView& view) {
  std::string list = ",\"furniture\":[";
  for (const render::FurnitureView& piece : view.furniture) {
    begin_item(list);
    robot::append_json_fields(list, {{"name", piece.name}});
    list += ",\"outline\":";
    append_points(list, {piece.outline_m.begin(), piece.outline_m.end()});
    list += ",\"circles\":[";
    for (const auto& circle : piece.circles) {
      begin_item(list);
      robot::append_json_fields(
          list, {{"x", circle.center_m.x()}, {"y", circle.center_m.y()}, {"radius", circle.radius_m}});
      list += '}';
    }
    list += "]}";
  }
  return list + ']';
}

std::string marks_of(const Scene& scene, const render::SceneView& view) {
  std::string list = ",\"ceiling\":[";
  if (scene.world.radio) {
    for (const world::CeilingTag& tag : scene.world.radio->tags) {
      begin_item(list);
      robot::append_json_fields(list, {{"name", tag.name}, {"x", tag.at_m.x()}, {"y", tag.at_m.y()}});
      list += '}';
    }
  }
  list += "],\"landmarks\":[";
  for (const auto& landmark : view.landmarks) {
    begin_item(list);
    robot::append_json_fields(list,
                              {{"name", landmark.label}, {"x", landmark.at_m.x()}, {"y", landmark.at_m.y()}});
    list += '}';
  }
  return list + ']';
}

}  // namespace

void show_scene(robot::ProgramTap& tap, const Scene& scene) {
  const render::SceneView view = view_of(scene, {}, {});
  std::string body;
  robot::append_json_fields(body, {{"scene", scene.name},
                                   {"title", scene.title},
                                   {"seed", std::to_string(scene.seed)},
                                   {"north", scene.world.north_yaw_rad}});
  body += walls_of(scene) + furniture_of(view) + marks_of(scene, view);
  if (scene.mission.phase) {
    body += ",\"path\":";
    append_points(body, IdealPath(scene).points_m());
  }
  tap.publish("scene", "scene", body);
}

void show_frame(robot::ProgramTap& tap, const robot::Pose2& X_WM) {
  std::string body;
  robot::append_json_fields(body, {{"x", X_WM.p_m.x()}, {"y", X_WM.p_m.y()}, {"yaw", X_WM.yaw_rad}});
  tap.publish("frame", "frame", body);
}

void show_truth(robot::ProgramTap& tap, robot::Instant now, const world::World& world) {
  if (!tap.truth(now, world.X_WR())) {
    return;
  }
  std::string body = ",\"at\":[";
  for (const world::Disc& person : world.people()) {
    begin_item(body);
    robot::append_json_fields(
        body, {{"x", person.middle_m.x()}, {"y", person.middle_m.y()}, {"radius", person.radius_m}});
    body += '}';
  }
  tap.publish_changed("people", "people", body + ']');
}

TwinTap::TwinTap(robot::TelemetryHub* hub, const Scene& scene, const robot::RobotSettings& settings)
    : scene_(scene) {
  if (hub == nullptr) {
    return;
  }
  robot::RobotCard card = robot::card_of(settings, scene.name, "twin run");
  card.title = scene.title;
  tap_.emplace(*hub, std::move(card));
  show_scene(*tap_, scene);
  if (scene.mission.phase) {
    path_.emplace(scene);
    show_frame(*tap_, scene.robot.X_WR_start);
  } else if (scene.mission.hallway) {
    show_frame(*tap_, {});
  }
}

robot::EventLog::Listener TwinTap::listener() {
  if (!tap_) {
    return {};
  }
  return [this](robot::Instant now, std::string_view event, std::initializer_list<robot::EventField> fields) {
    tap_->heard(now, event, fields);
  };
}

void TwinTap::show_total(std::size_t tiles) {
  if (tap_) {
    std::string body;
    robot::append_json_fields(body, {{"tiles", tiles}});
    tap_->publish("total", "total", body);
  }
}

void TwinTap::after_tick(const MappingTwin& twin) {
  if (!tap_) {
    return;
  }
  tap_->after_step(twin.now(), twin.program());
  show_truth(*tap_, twin.now(), twin.world());
  if (!placed_ && twin.program().mission().map().visited_count() > 0) {
    placed_ = true;
    if (const auto placement = placement_of(scene_, twin)) {
      const auto [column, row] = placement->origin;
      show_frame(*tap_, {tile_centre_m(scene_.world.carpet, column, row),
                         robot::wrap_angle(placement->quarter_turns * robot::kPi / 2.0)});
    }
  }
}

void TwinTap::after_tick(const HallwayTwin& twin) {
  if (tap_) {
    tap_->after_step(twin.now(), twin.program());
    show_truth(*tap_, twin.now(), twin.world());
  }
}

void TwinTap::after_tick(const PhaseTwin& twin) {
  if (!tap_) {
    return;
  }
  tap_->after_step(twin.now(), twin.program());
  show_truth(*tap_, twin.now(), twin.world());
  if (const auto error_m = path_->error_m(twin.program().leg(), twin.world().X_WR().p_m)) {
    constexpr double kCentimetres = 100.0;
    tap_->sample(twin.now(), "error_cm", kCentimetres * *error_m);
  }
}

void TwinTap::ended(robot::Instant now, bool interrupted) {
  if (tap_) {
    tap_->ended(now, interrupted ? "interrupted" : "done");
  }
}

}  // namespace sensotwin::twin
