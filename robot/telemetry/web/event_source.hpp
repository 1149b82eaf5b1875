// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace sensotwin::robot {

/// Where another program's page is, and the token that it asks for.
struct PageUrl {
  std::string origin;  ///< "http://192.168.1.7:8420"
  std::string token{};
};
/// "http://host:port/", with or without "?token=...". \throws WebError for anything else
[[nodiscard]] PageUrl page_url(std::string_view text);

/// Reads another program's server-sent events in a thread of its own, as a browser does: comes back when the
/// connection breaks or is refused, and says what it got last.
class EventSource {
 public:
  /// Both are told in the source's thread. \param take  each datum
  /// \param link  whether the connection is there, at first and when that changes
  EventSource(PageUrl url, std::function<void(std::string_view)> take, std::function<void(bool up)> link);
  ~EventSource();
  EventSource(const EventSource&) = delete;
  EventSource& operator=(const EventSource&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sensotwin::robot
