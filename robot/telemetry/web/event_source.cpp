// SPDX-License-Identifier: MIT
#include "robot/telemetry/web/event_source.hpp"

#include <httplib.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "robot/telemetry/web/web_error.hpp"

namespace sensotwin::robot {
namespace {

/// Between two tries. Chosen: as browsers wait.
constexpr std::chrono::seconds kAgain{1};
/// A source that says nothing for so long is gone: the monitor's heartbeat is 5 s.
constexpr std::chrono::seconds kSilent{15};
/// Of one event. Chosen: a scene with all its walls is some tens of kilobytes.
constexpr std::size_t kEventMost = 4U << 20U;

}  // namespace

PageUrl page_url(std::string_view text) {
  constexpr std::string_view kScheme = "http://";
  const std::string_view rest = text.starts_with(kScheme) ? text.substr(kScheme.size()) : std::string_view{};
  const std::size_t slash = rest.find('/');
  const std::string_view host = rest.substr(0, slash);
  std::string_view query = slash == std::string_view::npos ? std::string_view{} : rest.substr(slash + 1);
  constexpr std::string_view kToken = "?token=";
  if (host.empty() || (!query.empty() && !query.starts_with(kToken))) {
    throw WebError("'" + std::string(text) + "' is not the address of a monitor, as http://host:port/ is");
  }
  query.remove_prefix(query.empty() ? 0 : kToken.size());
  return {.origin = std::string(kScheme) + std::string(host), .token = std::string(query)};
}

struct EventSource::State {
  void run();
  void listen();
  bool hear(std::string_view bytes);
  void hear_line(std::string_view line);
  void tell(bool up);

  PageUrl url;
  std::function<void(std::string_view)> take;
  std::function<void(bool)> link;
  std::optional<bool> told;  ///< of the connection
  std::string pending;
  std::string last_id;
  std::atomic<bool> ending{false};
  std::mutex mutex;
  std::condition_variable end;
  httplib::Client* client{nullptr};  ///< while it listens
  std::thread thread;
};

void EventSource::State::hear_line(std::string_view line) {
  constexpr std::string_view kId = "id: ";
  constexpr std::string_view kData = "data: ";
  if (line.starts_with(kId)) {
    last_id = line.substr(kId.size());
  } else if (line.starts_with(kData)) {
    take(line.substr(kData.size()));
  }
}

void EventSource::State::tell(bool up) {
  if (told != up) {
    told = up;
    link(up);
  }
}

bool EventSource::State::hear(std::string_view bytes) {
  pending += bytes;
  std::size_t begun = 0;
  for (std::size_t end_of_line = pending.find('\n'); end_of_line != std::string::npos;
       end_of_line = pending.find('\n', begun)) {
    hear_line(std::string_view{pending}.substr(begun, end_of_line - begun));
    begun = end_of_line + 1;
  }
  pending.erase(0, begun);
  return !ending && pending.size() < kEventMost;
}

void EventSource::State::listen() {
  httplib::Client here(url.origin);
  here.set_connection_timeout(kSilent);
  here.set_read_timeout(kSilent);
  {
    const std::lock_guard lock(mutex);
    if (ending) {
      return;
    }
    client = &here;
  }
  httplib::Headers headers{{"Last-Event-ID", last_id}};
  if (!url.token.empty()) {
    headers.emplace("Authorization", "Bearer " + url.token);
  }
  pending.clear();
  (void)here.Get(
      "/events", headers,
      [this](const httplib::Response& response) {
        if (response.status == 200) {
          tell(true);
        }
        return response.status == 200;
      },
      [this](const char* bytes, std::size_t size) {
        return hear({bytes, size});
      });
  const std::lock_guard lock(mutex);
  client = nullptr;
}

void EventSource::State::run() {
  while (!ending) {
    listen();
    tell(false);
    std::unique_lock lock(mutex);
    end.wait_for(lock, kAgain, [this] { return ending.load(); });
  }
}

EventSource::EventSource(PageUrl url, std::function<void(std::string_view)> take,
                         std::function<void(bool)> link)
    : state_(std::make_unique<State>()) {
  state_->url = std::move(url);
  state_->take = std::move(take);
  state_->link = std::move(link);
  state_->thread = std::thread([state = state_.get()] { state->run(); });
}

EventSource::~EventSource() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->ending = true;
    if (state_->client != nullptr) {
      state_->client->stop();
    }
  }
  state_->end.notify_all();
  state_->thread.join();
}

}  // namespace sensotwin::robot
