// SPDX-License-Identifier: MIT
#include "robot/telemetry/relay.hpp"

namespace sensotwin::robot {
namespace {

/// Every message of a robot begins so (ProgramTap::publish).
constexpr std::string_view kBegin = "{\"r\":";
constexpr std::string_view kKey = ",\"key\":\"";

}  // namespace

Relay::Relay(TelemetryHub& hub, int id, const std::string& url)
    : hub_(hub),
      id_(std::to_string(id)),
      source_(
          page_url(url), [this](std::string_view data) { pass_on(data); },
          [this] { publish("link", ",\"key\":\"link\",\"k\":\"link\",\"up\":false}"); }) {}

void Relay::publish(std::string_view key, std::string_view body) {
  std::string name = id_ + "/";
  name += key;
  std::string json{kBegin};
  json += id_;
  json += body;
  hub_.publish({std::move(name), std::move(json)});
}

void Relay::pass_on(std::string_view data) {
  if (data == "{\"k\":\"reset\"}") {
    // What is known of it is of another run.
    publish("restarted", ",\"key\":\"restarted\",\"k\":\"restarted\"}");
    publish("link", ",\"key\":\"link\",\"k\":\"link\",\"up\":true}");
    return;
  }
  const std::size_t comma = data.find(kKey);
  if (!data.starts_with(kBegin) || comma == std::string_view::npos) {
    return;  // of a newer or an older program
  }
  const std::size_t begun = comma + kKey.size();
  const std::string_view key = data.substr(begun, data.find('"', begun) - begun);
  publish(key, data.substr(comma));
}

}  // namespace sensotwin::robot
