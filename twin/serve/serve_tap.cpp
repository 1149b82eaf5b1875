// SPDX-License-Identifier: MIT
#include "twin/serve/serve_tap.hpp"

#include <utility>

#include "twin/run/twin_tap.hpp"

namespace sensotwin::twin {

ServeTap::ServeTap(robot::TelemetryHub* hub, const Scene& scene) {
  if (hub == nullptr) {
    return;
  }
  robot::RobotCard card;
  card.name = scene.name;
  card.title = scene.title;
  card.source = "twin serve";
  card.mission = "serve";
  card.tile_m = scene.world.carpet.tile_m;
  card.radius_m = scene.robot.base.radius_m;
  tap_.emplace(*hub, std::move(card));
  show_scene(*tap_, scene);
  show_frame(*tap_, {});
}

void ServeTap::after_tick(const ServedTwin& twin) {
  if (!tap_) {
    return;
  }
  show_truth(*tap_, twin.now(), twin.machine().world());
  const world::RoombaInputs& inputs = twin.machine().inputs();
  if (inputs.battery_capacity_mah > 0.0) {
    constexpr double kPercent = 100.0;
    tap_->sample(twin.now(), "battery", kPercent * inputs.battery_charge_mah / inputs.battery_capacity_mah);
  }
}

void ServeTap::tell_of_clients(robot::Instant now, const ServeStatus& status) {
  for (const ServeStatus::OfWire& wire : status.wires) {
    bool& known = clients_[wire.name];
    if (wire.has_client != known) {
      known = wire.has_client;
      tap_->heard(now, wire.has_client ? "client_came" : "client_left", {{"wire", wire.name}});
    }
  }
}

void ServeTap::show(robot::Instant now, const ServeStatus& status) {
  if (!tap_) {
    return;
  }
  tell_of_clients(now, status);
  std::string body;
  robot::append_json_fields(
      body, {{"t", status.sim_s}, {"rtf", status.factor}, {"mode", status.base_mode}, {"done", false}});
  tap_->publish("status", "status", body);
}

}  // namespace sensotwin::twin
