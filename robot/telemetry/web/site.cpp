// SPDX-License-Identifier: MIT
#include "robot/telemetry/web/site.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "robot/telemetry/web/access_token.hpp"
#include "robot/telemetry/web/web_address.hpp"

namespace sensotwin::robot {
namespace {

using Header = std::pair<std::string_view, std::string_view>;

/// Only files of this page run or are loaded, nothing frames it, and no address leaks out by a link.
constexpr std::array<Header, 7> kSecurityHeaders{{
    {"Content-Security-Policy",
     "default-src 'self'; img-src 'self' data: blob:; object-src 'none'; base-uri 'none'; form-action "
     "'self'; "
     "frame-ancestors 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"X-Frame-Options", "DENY"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cache-Control", "no-store"},
}};

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

HttpResponse plain(int status, std::string text) {
  return {.status = status, .body = std::move(text) + "\n"};
}

bool is_write(const HttpRequest& request) {
  return request.method != "GET" && request.method != "HEAD";
}

/// The name in a Host header: "localhost:8080" is localhost.
std::string_view name_of_host(std::string_view host) {
  if (host.starts_with('[')) {
    const std::size_t bracket = host.find(']');
    return bracket == std::string_view::npos ? std::string_view{} : host.substr(1, bracket - 1);
  }
  return host.substr(0, host.rfind(':'));
}

/// An IPv4 address of the loopback network, not a name that begins like one.
bool names_this_machine(std::string_view name) {
  const bool figures =
      std::all_of(name.begin(), name.end(), [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
  return is_loopback(name) && (figures || name == "localhost" || name == "::1");
}

/// The value of one cookie of a Cookie header, RFC 6265 (4.2).
std::string_view cookie(std::string_view header, std::string_view name) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find(';'), header.size());
    std::string_view pair = header.substr(0, end);
    pair.remove_prefix(std::min(pair.find_first_not_of(' '), pair.size()));
    if (pair.starts_with(name) && pair.substr(name.size()).starts_with('=')) {
      return pair.substr(name.size() + 1);
    }
    header.remove_prefix(std::min(end + 1, header.size()));
  }
  return {};
}

}  // namespace

bool HeaderLess::operator()(std::string_view a, std::string_view b) const {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [](char x, char y) { return lower(x) < lower(y); });
}

std::string_view HttpRequest::header(std::string_view name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? std::string_view{} : found->second;
}

std::string_view HttpRequest::parameter(std::string_view name) const {
  const auto found = query.find(name);
  return found == query.end() ? std::string_view{} : found->second;
}

Site::Site(std::span<const EmbeddedFile> files) : files_(files) {}

std::span<const Header> Site::security_headers() {
  return kSecurityHeaders;
}

void Site::on(std::string method, std::string path, HttpHandler handler) {
  assert(method == "GET" || method == "POST" || method == "PUT");
  handlers_[{std::move(path), std::move(method)}] = std::move(handler);
}

void Site::on_events(std::string path, EventStreamOpener opener) {
  streams_[std::move(path)] = std::move(opener);
}

bool Site::knows_token(const HttpRequest& request) const {
  if (access_.token.empty()) {
    return false;
  }
  const std::string_view bearer = request.header("Authorization");
  constexpr std::string_view kBearer = "Bearer ";
  return equal_in_constant_time(request.parameter("token"), access_.token) ||
         equal_in_constant_time(cookie(request.header("Cookie"), access_.cookie_name), access_.token) ||
         (bearer.starts_with(kBearer) &&
          equal_in_constant_time(bearer.substr(kBearer.size()), access_.token));
}

std::optional<HttpResponse> Site::refused_write(const HttpRequest& request) const {
  const std::string_view origin = request.header("Origin");
  if (!origin.empty() && origin != "http://" + std::string(request.header("Host"))) {
    return plain(403, "another site may not change anything here");
  }
  const std::string_view site = request.header("Sec-Fetch-Site");
  if (!site.empty() && site != "same-origin" && site != "none") {
    return plain(403, "another site may not change anything here");
  }
  if (request.header(kWriteHeader).empty()) {
    return plain(403, "a write needs the header " + std::string(kWriteHeader));
  }
  return std::nullopt;
}

std::optional<HttpResponse> Site::refusal(const HttpRequest& request) const {
  const std::string_view host = request.header("Host");
  if (host.empty()) {
    return plain(400, "the header Host is missing");
  }
  if (access_.loopback && !names_this_machine(name_of_host(host))) {
    return plain(403, "this page is served to this machine only, by the name localhost or 127.0.0.1");
  }
  if (!access_.loopback && !knows_token(request)) {
    return plain(401, "the token is missing or wrong: open the address that the program printed");
  }
  if (request.method != "GET" && request.method != "HEAD" && request.method != "POST" &&
      request.method != "PUT") {
    return plain(405, "only GET, HEAD, POST and PUT are answered");
  }
  // Neither is needed here, and both make much work of a small request.
  if (!request.header("Range").empty() || !request.header("Content-Encoding").empty()) {
    return plain(400, "neither parts nor packed bodies are taken");
  }
  if (is_write(request)) {
    if (!request.header("Transfer-Encoding").empty() || request.header("Content-Length").empty()) {
      return plain(411, "a body needs a Content-Length");
    }
    if (request.header("Content-Type").starts_with("multipart/")) {
      return plain(415, "no forms are taken");
    }
    return refused_write(request);
  }
  return std::nullopt;
}

HttpResponse Site::dispatch(const HttpRequest& request) const {
  const std::string method = request.method == "HEAD" ? "GET" : request.method;
  if (const auto found = handlers_.find({request.path, method}); found != handlers_.end()) {
    return found->second(request);
  }
  const auto file = std::find_if(files_.begin(), files_.end(),
                                 [&](const EmbeddedFile& each) { return each.path == request.path; });
  const bool known = file != files_.end() || streams_.contains(request.path) ||
                     handlers_.lower_bound({request.path, ""}) != handlers_.upper_bound({request.path, "~"});
  if (file == files_.end() || method != "GET") {
    return known ? plain(405, "not with this method") : plain(404, "there is no such page");
  }
  if (!access_.loopback && !request.parameter("token").empty()) {
    // The token leaves the address bar and the history, where others would read it.
    return {.status = 303,
            .headers = {{"Location", request.path},
                        {"Set-Cookie",
                         access_.cookie_name + "=" + access_.token + "; Path=/; HttpOnly; SameSite=Lax"}}};
  }
  return {.type = std::string(file->type), .body = std::string(file->bytes)};
}

HttpResponse Site::answer(const HttpRequest& request) const {
  if (auto refused = refusal(request)) {
    return *std::move(refused);
  }
  try {
    return dispatch(request);
  } catch (const std::exception&) {
    return plain(500, "this could not be done");
  }
}

const EventStreamOpener* Site::events_at(const HttpRequest& request) const {
  const auto found = streams_.find(request.path);
  return found == streams_.end() || request.method != "GET" ? nullptr : &found->second;
}

}  // namespace sensotwin::robot
