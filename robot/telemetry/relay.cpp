// SPDX-License-Identifier: MIT
#include "robot/telemetry/relay.hpp"

#include "robot/output/event_log.hpp"

namespace sensotwin::robot {
namespace {

/// Every message of a robot begins so (ProgramTap::publish).
constexpr std::string_view kBegin = "{\"r\":";
constexpr std::string_view kKey = ",\"key\":\"";

}  // namespace

Relay::Relay(TelemetryHub& hub, int id, const std::string& url)
    : hub_(hub),
      id_(std::to_string(id)),
      origin_(page_url(url).origin),
      source_(
          page_url(url), [this](std::string_view data) { pass_on(data); }, [this](bool up) { tell(up); }) {}

void Relay::tell(bool up) {
  std::string body = ",\"key\":\"link\",\"k\":\"link\"";
  append_json_fields(body, {{"up", up}, {"at", origin_}});
  body += '}';
  publish("link", body);
}

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
