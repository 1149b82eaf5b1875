// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/telemetry/web/http.hpp"

namespace sensotwin::robot {

/// Who may see and change what.
///
/// On the loopback interface everybody on this machine may read; elsewhere the token is asked for, once in
/// the address (?token=...) and then by a cookie that scripts cannot read. A request by a foreign name is
/// refused on loopback: a page of the internet whose name points here (DNS rebinding) reads nothing. Whatever
/// changes something must come from a page of this site, or bring the token: the header that write() of
/// pages/common/http.ts sets cannot be set from another site without a permission that is never given (CORS).
struct SiteAccess {
  bool loopback{true};
  std::string token{};  ///< not empty unless loopback
  std::string cookie_name{"sensotwin"};
};

/// The pages of a program, its files and what it does for them. Knows no socket, so that it is tested without
/// one. After it was given to a server only answer(), refusal() and open_stream() are called, by several
/// threads at once.
class Site {
 public:
  /// \param files  static; the file "/" is the page itself
  explicit Site(std::span<const EmbeddedFile> files);

  /// \param method  GET, POST or PUT  \param path  whole, as in the request
  void on(std::string method, std::string path, HttpHandler handler);
  void on_events(std::string path, EventStreamOpener opener);
  void set_access(SiteAccess access) { access_ = std::move(access); }

  /// Why this request must not be answered; looked at before its body is read, so `body` may be empty.
  [[nodiscard]] std::optional<HttpResponse> refusal(const HttpRequest& request) const;
  /// To everything but event streams. Refuses by itself. Never throws.
  [[nodiscard]] HttpResponse answer(const HttpRequest& request) const;
  /// The opener of the event stream at this path, nullptr when there is none. Ask refusal() first.
  [[nodiscard]] const EventStreamOpener* events_at(const HttpRequest& request) const;

  /// Headers of every answer, refusals and streams included.
  [[nodiscard]] static std::span<const std::pair<std::string_view, std::string_view>> security_headers();
  /// A write from the page itself carries this header, with any value.
  static constexpr std::string_view kWriteHeader = "X-SensoTwin";

 private:
  [[nodiscard]] bool knows_token(const HttpRequest& request) const;
  [[nodiscard]] std::optional<HttpResponse> refused_write(const HttpRequest& request) const;
  [[nodiscard]] HttpResponse dispatch(const HttpRequest& request) const;

  std::span<const EmbeddedFile> files_;
  std::map<std::pair<std::string, std::string>, HttpHandler> handlers_;  ///< path, method
  std::map<std::string, EventStreamOpener> streams_;
  SiteAccess access_;
};

}  // namespace sensotwin::robot
