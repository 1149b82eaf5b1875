// SPDX-License-Identifier: MIT
#include "robot/telemetry/program_tap.hpp"

#include <algorithm>
#include <utility>

#include "robot/output/text_format.hpp"
#include "robot/settings/program_config.hpp"

namespace sensotwin::robot {
namespace {

/// Ticks from pose to pose. Chosen: 0.105 s, 3 cm at 0.3 m/s, ten pictures a second.
constexpr int kPoseEvery = 7;
/// Points of the trail lie so far apart at least. Chosen: a tenth of a tile.
constexpr double kPoint_m = 0.05;
/// Kept of the trail, the events and each chart. Chosen: 400 m, a long list, more than an hour of seconds.
constexpr std::int64_t kPointsKept = 8192;
constexpr std::int64_t kEventsKept = 2000;
constexpr std::int64_t kSamplesKept = 4096;
constexpr double kStatusEvery_s = 1.0;

std::string_view name_of(oi::Mode mode) {
  switch (mode) {
    case oi::Mode::kOff:
      return "off";
    case oi::Mode::kPassive:
      return "passive";
    case oi::Mode::kSafe:
      return "safe";
    case oi::Mode::kFull:
      break;
  }
  return "full";
}

const EventField* field(std::initializer_list<EventField> fields, std::string_view key) {
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const EventField& each) { return each.key == key; });
  return found == fields.end() ? nullptr : found;
}

std::optional<Tile> tile_in(std::initializer_list<EventField> fields) {
  const EventField* column = field(fields, "column");
  const EventField* row = field(fields, "row");
  if (column == nullptr || row == nullptr) {
    return std::nullopt;
  }
  const auto number = [](const EventField& of) {
    const auto* value = std::get_if<std::int64_t>(&of.value);
    return static_cast<int>(value != nullptr ? *value : 0);
  };
  return Tile{number(*column), number(*row)};
}

}  // namespace

RobotCard card_of(const RobotSettings& settings, std::string name, std::string source) {
  RobotCard card;
  card.name = std::move(name);
  card.source = std::move(source);
  card.tile_m = settings.tile_m;
  card.radius_m = settings.base.radius_m;
  if (settings.mission.phase) {
    card.mission = "phase";
    for (const std::size_t tag : destinations_of(settings)) {
      card.destinations.push_back(settings.ceiling_tags[tag].name);
    }
  } else if (settings.mission.hallway) {
    card.mission = "hallway";
    card.goal = settings.mission.hallway->to;
  } else {
    card.mission = "map";
  }
  return card;
}

ProgramTap::ProgramTap(TelemetryHub& hub, RobotCard card)
    : hub_(hub), card_(std::move(card)), prefix_(std::to_string(card_.id) + "/") {
  if (card_.mission == "hallway" || card_.mission == "serve") {
    true_.trail = "true_trail";  // no program tells of a pose
  }
  std::string body;
  append_json_fields(body, {{"name", card_.name},
                            {"title", card_.title},
                            {"source", card_.source},
                            {"mission", card_.mission},
                            {"tile_m", card_.tile_m},
                            {"radius_m", card_.radius_m},
                            {"goal", card_.goal}});
  publish("robot", "robot", body);
}

void ProgramTap::publish(std::string_view key, std::string_view kind, std::string_view body) {
  TelemetryMessage message;
  message.key = prefix_;
  message.key += key;
  message.json = "{\"r\":" + std::to_string(card_.id) + ",\"key\":";
  append_json_string(message.json, key);
  message.json += ",\"k\":\"";
  message.json += kind;
  message.json += '"';
  message.json += body;
  message.json += '}';
  hub_.publish(std::move(message));
}

void ProgramTap::publish_changed(const std::string& key, std::string_view kind, std::string_view body) {
  std::string& shown = shown_[key];
  if (shown != body) {
    shown = body;
    publish(key, kind, body);
  }
}

void ProgramTap::heard(Instant now, std::string_view event, std::initializer_list<EventField> fields) {
  const std::int64_t number = events_++;
  std::string body;
  append_json_fields(body, {{"n", number}, {"t", to_s(now)}, {"event", event}});
  body += ",\"of\":{\"event\":";
  append_json_string(body, event);
  append_json_fields(body, fields);
  body += '}';
  // Landmarks are few and stay on the plan: they are not pushed out by what happens later.
  if (const EventField* tag = field(fields, "tag"); tag != nullptr && event.ends_with("_seen")) {
    const auto* uid = std::get_if<std::string_view>(&tag->value);
    publish("object/" + std::string(uid != nullptr ? *uid : ""), "object", body);
  }
  publish("event/" + std::to_string(number % kEventsKept), "event", body);
  if (const auto tile = tile_in(fields)) {
    if (event == "tile_found") {
      found_s_.emplace(*tile, to_s(now));
    } else if (event == "tile_written") {
      written_.insert(*tile);
    }
  }
  changed_ = true;
}

void ProgramTap::sense(Instant now, const RoombaState* fresh) {
  if (fresh == nullptr || (base_s_ && to_s(now) - *base_s_ < kStatusEvery_s)) {
    return;
  }
  base_s_ = to_s(now);
  std::string body;
  append_json_fields(body, {{"t", to_s(now)},
                            {"charge_mah", fresh->charge_mah},
                            {"capacity_mah", fresh->capacity_mah},
                            {"battery_v", 1e-3 * fresh->battery_mv},
                            {"battery_a", 1e-3 * fresh->battery_ma},
                            {"bump_left", fresh->bump_left},
                            {"bump_right", fresh->bump_right},
                            {"wheel_drop", fresh->wheel_drop_left || fresh->wheel_drop_right},
                            {"mode", fresh->mode ? name_of(*fresh->mode) : std::string_view{}}});
  publish("base", "base", body);
  if (fresh->capacity_mah > 0) {
    sample(now, "battery", 100.0 * fresh->charge_mah / fresh->capacity_mah);
  }
}

void ProgramTap::sample(Instant now, std::string_view series, double value) {
  const auto found = series_.find(series);
  Series& to = found != series_.end() ? found->second : series_.emplace(series, Series{}).first->second;
  if (to.samples > 0 && to_s(now) - to.last_s < kStatusEvery_s) {
    return;
  }
  to.last_s = to_s(now);
  const std::int64_t number = to.samples++ % kSamplesKept;
  std::string body;
  append_json_fields(body, {{"of", series}, {"n", number}, {"t", to_s(now)}, {"v", value}});
  std::string key = "sample/";
  key.append(series).append("/").append(std::to_string(number));
  publish(key, "sample", body);
}

bool ProgramTap::PoseTurn::is_now() {
  if (ticks_left_ > 0) {
    --ticks_left_;
    return false;
  }
  ticks_left_ = kPoseEvery - 1;
  return true;
}

bool ProgramTap::show_pose(Track& track, Instant now, const Pose2& X) {
  if (!track.turn.is_now()) {
    return false;
  }
  std::string body;
  append_json_fields(body, {{"t", to_s(now)}, {"x", X.p_m.x()}, {"y", X.p_m.y()}, {"yaw", X.yaw_rad}});
  publish(track.kind, track.kind, body);
  const bool far = !track.last_point_m || (X.p_m - *track.last_point_m).norm() >= kPoint_m;
  if (far && !track.trail.empty()) {
    track.last_point_m = X.p_m;
    const std::int64_t number = track.points++;
    body.clear();
    append_json_fields(body, {{"n", number}, {"x", X.p_m.x()}, {"y", X.p_m.y()}});
    std::string key(track.trail);
    key.append("/").append(std::to_string(number % kPointsKept));
    publish(key, track.trail, body);
  }
  return true;
}

void ProgramTap::pose(Instant now, const Pose2& X_MR) {
  show_pose(believed_, now, X_MR);
}

bool ProgramTap::truth(Instant now, const Pose2& X_WR) {
  return show_pose(true_, now, X_WR);
}

bool ProgramTap::status_is_due(Instant now, bool done) {
  const bool news = done != std::exchange(done_, done);
  if (!news && status_s_ && to_s(now) - *status_s_ < kStatusEvery_s) {
    return false;
  }
  status_s_ = to_s(now);
  return true;
}

void ProgramTap::ended(Instant now, std::string_view outcome) {
  std::string body;
  append_json_fields(body, {{"t", to_s(now)}, {"outcome", outcome}});
  publish("ended", "ended", body);
}

}  // namespace sensotwin::robot
