// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/telemetry/telemetry_hub.hpp"
#include "twin/scene/scene.hpp"
#include "twin/serve/served_wires.hpp"

namespace sensotwin::twin {

struct ServerSettings {
  std::string scene_as_given;
  std::filesystem::path folder;  ///< for devices.yaml, serve.json and the terminals' links; made when missing
  std::optional<double> factor{1.0};  ///< simulated seconds a real second; none: as the client follows
  WireSettings wires{};
  bool wait_for_cards{false};  ///< the world stands still until pcscd has noticed that a tag came or went
  bool truth{false};           ///< truth.csv in the folder: where the robot is, every tick
  std::optional<double> end_after_sim_s{};  ///< none: until it is told to stop
  /// What a monitor is told; none: there is none. Outlives the server.
  robot::TelemetryHub* telemetry{nullptr};
  /// main's clock, s.
  std::function<double()> wall_s;
  /// Asked some hundred times a second; false ends it in order.
  std::function<bool()> keep_going;
  /// A line for the person who watches.
  std::function<void(std::string_view)> say;
  /// Something is not as it should be.
  std::function<void(std::string_view)> warn;
};

/// How it goes, and in the end: how it went.
struct ServeStatus {
  struct OfWire {
    std::string name;
    bool has_client{false};
    WireTally tally;
  };
  double sim_s{0.0};
  double wall_s{0.0};
  double factor{0.0};      ///< achieved over the last second
  double given_up_s{0.0};  ///< real time that could not be caught up
  double waited_s{0.0};    ///< real time that the world stood still for the cards
  std::string base_mode;   ///< off, asleep, passive, safe, full
  std::vector<OfWire> wires;
};

/// `twin serve`: a scene's world paced by a real clock, its devices at the operating system's ports.
///
/// One thread: it moves bytes, makes the ticks that are due, and sleeps in poll() until the next of either.
class Server {
 public:
  /// Opens the wires. \throws ServeError, OutputError
  Server(const Scene& scene, ServerSettings settings);
  /// Removes devices.yaml and the links: nobody answers there any more.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Serves until it is told to stop or the time is over. \param show  called a few times a second
  /// \returns the last status; it is also in serve.json  \throws OutputError
  ServeStatus run(const std::function<void(const ServeStatus&)>& show);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// serve.json
[[nodiscard]] std::string to_json(const ServeStatus& status, const Scene& scene,
                                  const ServerSettings& settings);

}  // namespace sensotwin::twin
