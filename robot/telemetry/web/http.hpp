// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

/// What a page asks and is answered, free of sockets.
namespace sensotwin::robot {

/// Names of headers are told apart whatever their case (RFC 9110, 5.1).
struct HeaderLess {
  using is_transparent = void;
  [[nodiscard]] bool operator()(std::string_view a, std::string_view b) const;
};

struct HttpRequest {
  std::string method;  ///< GET, HEAD, POST, PUT
  std::string path;    ///< decoded, without the query
  std::map<std::string, std::string, std::less<>> query{};
  std::map<std::string, std::string, HeaderLess> headers{};
  std::string body{};

  /// Empty when it is not there. Valid as long as the request.
  [[nodiscard]] std::string_view header(std::string_view name) const;
  [[nodiscard]] std::string_view parameter(std::string_view name) const;
};

struct HttpResponse {
  int status{200};
  std::string type{"text/plain; charset=utf-8"};
  std::string body{};
  std::map<std::string, std::string, HeaderLess> headers{};  ///< beside those of every answer
};

/// Called by the server's threads, several at once: what it shares with others it must guard itself. What it
/// throws becomes status 500, and its text is not shown.
using HttpHandler = std::function<HttpResponse(const HttpRequest&)>;

/// One client's server-sent events (WHATWG HTML, 9.2), drawn by the thread that serves it.
class EventStream {
 public:
  virtual ~EventStream() = default;
  /// What is to be sent next, whole events; empty when there was nothing for `patience`.
  [[nodiscard]] virtual std::string next(std::chrono::milliseconds patience) = 0;
  /// No more will come: the connection is closed.
  [[nodiscard]] virtual bool ended() const = 0;
};
using EventStreamOpener = std::function<std::unique_ptr<EventStream>(const HttpRequest&)>;

/// A file that lies in the binary. All views are of static data.
struct EmbeddedFile {
  std::string_view path;  ///< as requested: "/monitor.js"
  std::string_view type;  ///< media type
  std::string_view bytes;
};

}  // namespace sensotwin::robot
