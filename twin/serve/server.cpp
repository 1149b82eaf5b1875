// SPDX-License-Identifier: MIT
#include "twin/serve/server.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>
#include <utility>

#include "robot/output/output_file.hpp"
#include "twin/serve/devices_file.hpp"
#include "twin/serve/pacer.hpp"
#include "twin/serve/serve_folder.hpp"
#include "twin/serve/serve_tap.hpp"
#include "twin/serve/served_twin.hpp"

namespace sensotwin::twin {
namespace {

/// Chosen: as often as a person reads.
constexpr double kShowEvery_s = 0.25;
/// Longest sleep, so that a request to stop is seen. Chosen: a tenth of the second that it may take.
constexpr double kSleepMax_s = 0.1;
/// While the world stands still for a card. Chosen: pcscd's own pace is 0.4 s.
constexpr double kCardLook_s = 1e-3;

void sleep_until_something(std::vector<pollfd>& handles, double seconds) {
  const double whole = std::floor(seconds);
  const timespec limit{.tv_sec = static_cast<time_t>(whole),
                       .tv_nsec = static_cast<long>((seconds - whole) * 1e9)};
  ::ppoll(handles.data(), handles.size(), &limit, nullptr);
}

std::string mode_of(const EmulatedRoomba& roomba) {
  using robot::oi::Mode;
  if (roomba.asleep()) {
    return "asleep";
  }
  switch (roomba.mode()) {
    case Mode::kOff:
      return "off";
    case Mode::kPassive:
      return "passive";
    case Mode::kSafe:
      return "safe";
    case Mode::kFull:
      return "full";
  }
  return "?";
}

}  // namespace

struct Server::State {
  State(const Scene& served_scene, ServerSettings server_settings)
      : scene(served_scene),
        settings(std::move(server_settings)),
        folder(settings.folder),
        twin(scene),
        wires(twin, settings.wires, folder.path(), settings.warn),
        tap(settings.telemetry, scene),
        begun_s(settings.wall_s()),
        pacer(settings.factor, begun_s) {
    if (settings.truth) {
      truth.emplace(folder.path() / "truth.csv");
      truth->append("t_s,x_m,y_m,yaw_rad\n");
    }
  }

  void tick();

  void tick_or_sleep(double wall_s);
  void announce();
  [[nodiscard]] ServeStatus status();

  const Scene scene;
  const ServerSettings settings;
  ServeFolder folder;
  ServedTwin twin;
  ServedWires wires;
  ServeTap tap;
  double begun_s;
  Pacer pacer;
  std::vector<pollfd> handles;
  std::optional<Devices> announced;
  double waited_s{0.0};
  std::optional<double> waits_since_s;
  std::optional<robot::OutputFile> truth;
};

void Server::State::tick() {
  twin.tick();
  tap.after_tick(twin);
  if (truth) {
    const robot::Pose2& X_WR = twin.machine().world().X_WR();
    truth->append(fmt::format("{:.3f},{:.5f},{:.5f},{:.5f}\n", robot::to_s(twin.now()), X_WR.p_m.x(),
                              X_WR.p_m.y(), X_WR.yaw_rad));
  }
}

void Server::State::tick_or_sleep(double wall_s) {
  wires.pump(wall_s);
  const bool waits = settings.wait_for_cards && !wires.cards_are_settled(wall_s);
  if (waits) {
    waited_s += waits_since_s ? wall_s - *waits_since_s : 0.0;
    pacer.stand_still(wall_s);
  }
  waits_since_s = waits ? std::optional{wall_s} : std::nullopt;
  const bool follows = pacer.follows_client() && wires.base().client_is_up_to_date();
  const double wait_s = waits ? kCardLook_s : pacer.wait_s(wall_s, follows);
  if (wait_s <= 0.0) {
    tick();
    pacer.tick(wall_s);
    return;
  }
  handles.clear();
  wires.watch(handles);
  // Nothing wakes us when a client has read what it was sent.
  const bool looking = pacer.follows_client() && wires.base().has_client();
  sleep_until_something(handles, std::min(wait_s, looking ? Pacer::kShortestTick_s : kSleepMax_s));
}

void Server::State::announce() {
  const auto devices = wires.devices();
  if (!devices || devices == announced) {
    return;
  }
  robot::OutputFile file(folder.path() / "devices.yaml");
  file.append(to_yaml(*devices, settings.scene_as_given));
  file.finish();
  announced = devices;
  settings.say(fmt::format("serving; {} says where the wires are", file.final_path().string()));
}

ServeStatus Server::State::status() {
  ServeStatus now;
  now.sim_s = robot::to_s(twin.now());
  now.wall_s = settings.wall_s() - begun_s;
  now.factor = pacer.achieved();
  now.given_up_s = pacer.given_up_s();
  now.waited_s = waited_s;
  now.base_mode = mode_of(twin.machine().roomba());
  for (const auto& wire : wires.all()) {
    now.wires.push_back({.name = wire->name(), .has_client = wire->has_client(), .tally = wire->tally()});
  }
  return now;
}

Server::Server(const Scene& scene, ServerSettings settings)
    : state_(std::make_unique<State>(scene, std::move(settings))) {}

Server::~Server() = default;

ServeStatus Server::run(const std::function<void(const ServeStatus&)>& show) {
  State& state = *state_;
  const double end_s = state.settings.end_after_sim_s.value_or(INFINITY);
  double show_at_s = 0.0;
  while (state.settings.keep_going() && robot::to_s(state.twin.now()) < end_s) {
    const double wall_s = state.settings.wall_s();
    state.tick_or_sleep(wall_s);
    if (wall_s >= show_at_s) {
      show_at_s = wall_s + kShowEvery_s;
      state.announce();
      state.wires.tell(state.settings.say, state.settings.warn);
      const ServeStatus status = state.status();
      state.tap.show(state.twin.now(), status);
      show(status);
    }
  }
  ServeStatus last = state.status();
  robot::OutputFile file(state.folder.path() / "serve.json");
  file.append(to_json(last, state.scene, state.settings));
  file.finish();
  if (state.truth) {
    state.truth->finish();
  }
  return last;
}

std::string to_json(const ServeStatus& status, const Scene& scene, const ServerSettings& settings) {
  nlohmann::ordered_json json{{"scene", settings.scene_as_given}, {"seed", scene.seed}};
  json["rtf_asked"] = settings.factor ? nlohmann::ordered_json(*settings.factor) : "max";
  const double factor = status.wall_s > 0.0 ? status.sim_s / status.wall_s : 0.0;
  const auto rounded = [](double value) { return std::round(value * 1e3) / 1e3; };
  json["rtf"] = rounded(factor);
  json["sim_s"] = rounded(status.sim_s);
  json["wall_s"] = rounded(status.wall_s);
  json["given_up_s"] = rounded(status.given_up_s);
  json["waited_s"] = rounded(status.waited_s);
  for (const ServeStatus::OfWire& wire : status.wires) {
    json["wires"][wire.name] = {{"clients", wire.tally.clients},
                                {"refused", wire.tally.refused},
                                {"bytes_in", wire.tally.bytes_in},
                                {"bytes_out", wire.tally.bytes_out},
                                {"bytes_dropped", wire.tally.bytes_dropped}};
    if (wire.name == "llrp") {
      json["wires"][wire.name]["reports_lost"] = wire.tally.reports_lost;
    }
  }
  return json.dump(2) + '\n';
}

}  // namespace sensotwin::twin
