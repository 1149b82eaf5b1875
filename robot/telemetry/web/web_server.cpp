// SPDX-License-Identifier: MIT
#include "robot/telemetry/web/web_server.hpp"

#include <httplib.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <utility>

#include "robot/ports/descriptor.hpp"
#include "robot/telemetry/web/access_token.hpp"
#include "robot/telemetry/web/deadline_stream.hpp"
#include "robot/telemetry/web/web_error.hpp"
#include "robot/telemetry/web/worker_pool.hpp"

namespace sensotwin::robot {
namespace {

/// Connections that wait to be accepted. Chosen: a hundred browsers that come back at once.
constexpr int kBacklog = 128;
/// A stream looks so often whether the server stops. Chosen: nobody waits noticeably.
constexpr std::chrono::milliseconds kStreamLook{250};
/// Streams may finish what they have begun to say: how a run ended is said last. Chosen: a phone takes a run
/// of an hour in this; a client that does not read must not hold up the end longer.
constexpr std::chrono::milliseconds kLastWords{500};

HttpRequest request_of(const httplib::Request& from) {
  HttpRequest request;
  request.method = from.method;
  request.path = from.path;
  for (const auto& [name, value] : from.params) {
    request.query.emplace(name, value);
  }
  for (const auto& [name, value] : from.headers) {
    request.headers.emplace(name, value);
  }
  request.body = from.body;
  return request;
}

void set_security_headers(httplib::Response& to) {
  for (const auto& [name, value] : Site::security_headers()) {
    if (!to.has_header(std::string(name).c_str())) {
      to.set_header(std::string(name), std::string(value));
    }
  }
}

void put(const HttpResponse& from, httplib::Response& to) {
  to.status = from.status;
  for (const auto& [name, value] : from.headers) {
    to.set_header(name, value);
  }
  to.set_content(from.body, from.type);
}

/// httplib's server with our limits: a socket is served by a DeadlineStream, one request long.
class LimitedServer : public httplib::Server {
 public:
  LimitedServer(const WebServerOptions& options, const Descriptor& stop)
      : limits_{.request = options.request_time,
                .write = options.write_time,
                .request_bytes = options.header_bytes + options.body_bytes},
        stop_(stop) {
    new_task_queue = [workers = options.connections] { return new WorkerPool(workers); };
    set_payload_max_length(options.body_bytes);
  }
  /// Serves in this thread until it is stopped.
  void serve() {
    doorman_ = std::this_thread::get_id();
    listen_after_bind();
  }

 private:
  bool process_and_close_socket(socket_t sock) override {
    if (std::this_thread::get_id() == doorman_) {
      turn_away(sock);
    } else {
      DeadlineStream stream(sock, limits_, stop_);
      bool closed = false;
      process_request(stream, true, closed, nullptr);
    }
    ::shutdown(sock, SHUT_RDWR);
    ::close(sock);
    return true;
  }

  static void turn_away(socket_t sock) {
    constexpr std::string_view kFull =
        "HTTP/1.1 503 Service Unavailable\r\nRetry-After: 5\r\nContent-Length: 0\r\nConnection: "
        "close\r\n\r\n";
    (void)::send(sock, kFull.data(), kFull.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  }

  DeadlineStream::Limits limits_;
  const Descriptor& stop_;
  std::thread::id doorman_{};  ///< the thread that accepts, and has no time for more
};

}  // namespace

struct WebServer::State {
  State(Site served, const WebServerOptions& chosen)
      : site(std::move(served)), options(chosen), stop(::eventfd(0, EFD_CLOEXEC)), server(chosen, stop) {}

  void bind();
  void route();
  void stream(const EventStreamOpener& opener, const HttpRequest& request, httplib::Response& response);
  /// \returns false: there are as many as there may be
  bool begin_stream();
  void end_stream();

  Site site;
  WebServerOptions options;
  Descriptor stop;
  LimitedServer server;
  std::string token;
  std::mutex streams_mutex;
  std::condition_variable stream_ended;
  std::size_t streams{0};
  std::atomic<bool> stopping{false};
  std::thread thread;
};

void WebServer::State::bind() {
  if (!is_loopback(options.address.host)) {
    token = new_access_token();
  }
  int listening = -1;
  server.set_socket_options([&listening](socket_t socket) {
    // A port whose last connection ended a moment ago is free; one that another server holds is not.
    const int on = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    listening = socket;
  });
  const std::string& host = options.address.host;
  bool bound = false;
  if (options.address.port == 0) {
    const int port = server.bind_to_any_port(host);
    bound = port > 0;
    options.address.port = static_cast<std::uint16_t>(bound ? port : 0);
  } else {
    bound = server.bind_to_port(host, options.address.port);
  }
  if (!bound || !stop) {
    throw WebError("cannot serve pages at " + to_text(options.address) +
                   ": the port is taken, or this machine has no such address");
  }
  (void)::listen(listening, kBacklog);
  site.set_access({.loopback = token.empty(),
                   .token = token,
                   .cookie_name = "sensotwin_" + std::to_string(options.address.port)});
}

bool WebServer::State::begin_stream() {
  const std::lock_guard lock(streams_mutex);
  if (streams >= options.streams) {
    return false;
  }
  ++streams;
  return true;
}

void WebServer::State::end_stream() {
  // Told under the lock: whoever waits for the last one takes the whole server away.
  const std::lock_guard lock(streams_mutex);
  --streams;
  stream_ended.notify_all();
}

void WebServer::State::stream(const EventStreamOpener& opener, const HttpRequest& request,
                              httplib::Response& response) {
  if (!begin_stream()) {
    put({.status = 503, .body = "too many event streams are open\n", .headers = {{"Retry-After", "5"}}},
        response);
    return;
  }
  std::shared_ptr<EventStream> events;
  try {
    events = opener(request);
  } catch (...) {
    end_stream();
    throw;
  }
  const auto silent = std::make_shared<std::chrono::milliseconds>(0);
  response.set_content_provider(
      "text/event-stream",
      [this, events, silent](std::size_t, httplib::DataSink& sink) {
        const bool last_words = stopping;
        if (events->ended()) {
          return false;
        }
        std::string news = events->next(last_words ? std::chrono::milliseconds{0} : kStreamLook);
        if (last_words && news.empty()) {
          return false;
        }
        *silent = news.empty() ? *silent + kStreamLook : std::chrono::milliseconds{0};
        if (*silent >= options.heartbeat) {
          *silent = std::chrono::milliseconds{0};
          news = ":\n\n";
        }
        return news.empty() || sink.write(news.data(), news.size());
      },
      [this](bool) { end_stream(); });
}

void WebServer::State::route() {
  using Handled = httplib::Server::HandlerResponse;
  server.set_pre_routing_handler([this](const httplib::Request& from, httplib::Response& to) {
    const HttpRequest request = request_of(from);
    if (auto refused = site.refusal(request)) {
      put(*std::move(refused), to);
    } else if (const EventStreamOpener* opener = site.events_at(request)) {
      stream(*opener, request, to);
    } else {
      return Handled::Unhandled;
    }
    return Handled::Handled;
  });
  const auto answer = [this](const httplib::Request& from, httplib::Response& to) {
    put(site.answer(request_of(from)), to);
  };
  server.Get(".*", answer);
  server.Post(".*", answer);
  server.Put(".*", answer);
  server.set_post_routing_handler(
      [](const httplib::Request&, httplib::Response& to) { set_security_headers(to); });
  server.set_exception_handler([](const httplib::Request&, httplib::Response& to, const std::exception_ptr&) {
    put({.status = 500, .body = "this could not be done\n"}, to);
  });
}

WebServer::WebServer(Site site, const WebServerOptions& options)
    : state_(std::make_unique<State>(std::move(site), options)) {
  state_->bind();
  state_->route();
  state_->thread = std::thread([this] { state_->server.serve(); });
  while (!state_->server.is_running()) {
    std::this_thread::yield();
  }
}

WebServer::~WebServer() {
  state_->stopping = true;
  {
    std::unique_lock lock(state_->streams_mutex);
    state_->stream_ended.wait_for(lock, kLastWords, [this] { return state_->streams == 0; });
  }
  const std::uint64_t one = 1;
  (void)!::write(state_->stop.get(), &one, sizeof one);
  state_->server.stop();
  state_->thread.join();
}

const WebAddress& WebServer::address() const {
  return state_->options.address;
}

std::string WebServer::url() const {
  const std::string page = "http://" + to_text(state_->options.address) + "/";
  return state_->token.empty() ? page : page + "?token=" + state_->token;
}

}  // namespace sensotwin::robot
