// SPDX-License-Identifier: MIT
#include "robot/telemetry/web/web_server.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "robot/telemetry/web/web_error.hpp"

namespace sensotwin::robot {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr std::array<EmbeddedFile, 1> kFiles{{{"/", "text/html; charset=utf-8", "<!doctype html><p>hello"}}};

/// A client that says exactly what it is told.
class RawClient {
 public:
  explicit RawClient(const WebServer& server) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(server.address().port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{.tv_sec = 5, .tv_usec = 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
  }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;
  ~RawClient() { ::close(socket_); }

  void say(std::string_view bytes) const { (void)::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL); }
  /// All that comes until the server closes, or until `enough` is in it.
  [[nodiscard]] std::string hear(std::string_view enough = {}) const {
    std::string heard;
    std::array<char, 4096> buffer{};
    while (enough.empty() || heard.find(enough) == std::string::npos) {
      const ssize_t got = ::recv(socket_, buffer.data(), buffer.size(), 0);
      if (got <= 0) {
        break;
      }
      heard.append(buffer.data(), static_cast<std::size_t>(got));
    }
    return heard;
  }

 private:
  int socket_;
};

std::string answer_to(const WebServer& server, std::string_view request) {
  const RawClient client(server);
  client.say(request);
  return client.hear();
}

/// Counts up, ten numbers, then waits for ever.
class Counting : public EventStream {
 public:
  std::string next(milliseconds patience) override {
    if (number_ == 10) {
      std::this_thread::sleep_for(patience);
      return {};
    }
    return "data: " + std::to_string(number_++) + "\n\n";
  }
  [[nodiscard]] bool ended() const override { return false; }

 private:
  int number_{0};
};

Site counting_site() {
  Site site(kFiles);
  site.on_events("/events", [](const HttpRequest&) { return std::make_unique<Counting>(); });
  site.on("POST", "/echo", [](const HttpRequest& request) { return HttpResponse{.body = request.body}; });
  return site;
}

constexpr std::string_view kGet = "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n";
constexpr std::string_view kEvents = "GET /events HTTP/1.1\r\nHost: localhost\r\n\r\n";

std::string post(std::string_view body, std::string_view headers = "") {
  return "POST /echo HTTP/1.1\r\nHost: localhost\r\nX-SensoTwin: 1\r\nContent-Length: " +
         std::to_string(body.size()) + "\r\n" + std::string(headers) + "\r\n" + std::string(body);
}

TEST(WebServer, ServesItsPageWithTheSecurityHeaders) {
  const WebServer server(counting_site(), {});
  const std::string answer = answer_to(server, kGet);
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(answer, HasSubstr("<p>hello"));
  EXPECT_THAT(answer, HasSubstr("Content-Security-Policy: default-src 'self'"));
  EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff"));
  EXPECT_THAT(answer, HasSubstr("X-Frame-Options: DENY"));
  EXPECT_THAT(answer, HasSubstr("Referrer-Policy: no-referrer"));
  EXPECT_THAT(answer, HasSubstr("Cache-Control: no-store"));
}

TEST(WebServer, RefusalsCarryTheSecurityHeadersToo) {
  const WebServer server(counting_site(), {});
  const std::string answer = answer_to(server, "GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff"));
}

TEST(WebServer, NoPathLeavesThePage) {
  const WebServer server(counting_site(), {});
  for (const char* path :
       {"/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/..%2f..%2fetc/passwd", "/etc/passwd",
        "//etc/passwd", "/%00", "/./../etc/passwd", "http://localhost/etc/passwd"}) {
    const std::string answer =
        answer_to(server, "GET " + std::string(path) + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
    EXPECT_THAT(answer, Not(HasSubstr("root:"))) << path;
    EXPECT_THAT(answer, Not(StartsWith("HTTP/1.1 200"))) << path;
  }
}

TEST(WebServer, SurvivesWhatIsNoRequest) {
  const WebServer server(counting_site(), {.request_time = milliseconds{300}});
  const std::string zeros(3000, '\0');
  const std::string letters(100'000, 'A');
  for (const std::string& bytes :
       {std::string{"\r\n\r\n"}, std::string{"GET\r\n\r\n"}, std::string{"GET / HTTP/9.9\r\n\r\n"}, zeros,
        letters, "GET /" + letters + " HTTP/1.1\r\nHost: localhost\r\n\r\n",
        "GET / HTTP/1.1\r\nHost: localhost\r\nX: " + letters + "\r\n\r\n",
        std::string{"GET / HTTP/1.1\r\nHost localhost\r\n\r\n"},
        std::string{"POST /echo HTTP/1.1\r\nHost: localhost\r\nX-SensoTwin: 1\r\nContent-Length: -5\r\n\r\n"},
        std::string{"POST /echo HTTP/1.1\r\nHost: localhost\r\nX-SensoTwin: 1\r\nContent-Length: "
                    "99999999999999999999\r\n\r\n"},
        std::string{"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03"},
        std::string{"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"},
        std::string{"GET / HTTP/1.1\r\nHost: localhost\r\nRange: bytes=5-1,-0,99-\r\n\r\n"}}) {
    EXPECT_THAT(answer_to(server, bytes), Not(StartsWith("HTTP/1.1 200"))) << bytes.substr(0, 60);
  }
  EXPECT_THAT(answer_to(server, kGet), StartsWith("HTTP/1.1 200"));
}

TEST(WebServer, TakesABodyUpToItsBound) {
  const WebServer server(counting_site(), {.body_bytes = 100});
  EXPECT_THAT(answer_to(server, post(std::string(100, 'x'))), HasSubstr(std::string(100, 'x')));
  EXPECT_THAT(answer_to(server, post(std::string(101, 'x'))), StartsWith("HTTP/1.1 413"));
}

TEST(WebServer, TakesNoBodyWhereThereIsNothingToWrite) {
  const WebServer server(counting_site(), {});
  EXPECT_THAT(answer_to(server, post("x")), StartsWith("HTTP/1.1 413"));
}

TEST(WebServer, ARequestThatDripsIsCutOffInTime) {
  const WebServer server(counting_site(), {.request_time = milliseconds{400}});
  const RawClient dripping(server);
  for (const char c : kGet.substr(0, 12)) {
    dripping.say({&c, 1});
    std::this_thread::sleep_for(milliseconds{50});  // each byte well in time, the whole is not
  }
  EXPECT_EQ(dripping.hear(), "");
}

TEST(WebServer, SilentConnectionsDoNotKeepOthersOut) {
  const WebServer server(counting_site(), {.connections = 4, .request_time = milliseconds{400}});
  std::vector<std::unique_ptr<RawClient>> silent;
  for (int i = 0; i < 4; ++i) {
    silent.push_back(std::make_unique<RawClient>(server));
  }
  std::this_thread::sleep_for(milliseconds{100});
  EXPECT_THAT(answer_to(server, kGet), StartsWith("HTTP/1.1 503"));
  std::this_thread::sleep_for(milliseconds{500});
  EXPECT_THAT(answer_to(server, kGet), StartsWith("HTTP/1.1 200"));
}

TEST(WebServer, StreamsEventsAsTheyCome) {
  const WebServer server(counting_site(), {});
  const RawClient client(server);
  client.say(kEvents);
  const std::string heard = client.hear("data: 9\n\n");
  EXPECT_THAT(heard, HasSubstr("Content-Type: text/event-stream"));
  EXPECT_THAT(heard, HasSubstr("data: 0\n\ndata: 1\n\n"));
}

TEST(WebServer, OpensNoMoreStreamsThanItMay) {
  const WebServer server(counting_site(), {.streams = 2});
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int i = 0; i < 2; ++i) {
    clients.push_back(std::make_unique<RawClient>(server));
    clients.back()->say(kEvents);
    EXPECT_THAT(clients.back()->hear("data: 9\n\n"), HasSubstr("data: 9"));
  }
  EXPECT_THAT(answer_to(server, kEvents), StartsWith("HTTP/1.1 503"));
  EXPECT_THAT(answer_to(server, kGet), StartsWith("HTTP/1.1 200"));
}

TEST(WebServer, AStreamWhoseClientWentAwayIsFreeAgain) {
  const WebServer server(counting_site(), {.streams = 1, .heartbeat = milliseconds{250}});
  {
    const RawClient client(server);
    client.say(kEvents);
    EXPECT_THAT(client.hear("data: 9\n\n"), HasSubstr("data: 9"));
  }
  std::string answer;
  for (int i = 0; i < 20 && !answer.starts_with("HTTP/1.1 200"); ++i) {
    std::this_thread::sleep_for(milliseconds{100});
    const RawClient next(server);
    next.say(kEvents);
    answer = next.hear("\r\n\r\n");
  }
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200"));
}

TEST(WebServer, APortThatIsTakenIsSaidAtOnce) {
  const WebServer first(counting_site(), {});
  EXPECT_THROW(WebServer(counting_site(), {.address = first.address()}), WebError);
}

TEST(WebServer, BeyondLoopbackItAsksForTheTokenInItsAddress) {
  const WebServer server(counting_site(), {.address = {"0.0.0.0", 0}});
  EXPECT_THAT(answer_to(server, kGet), StartsWith("HTTP/1.1 401"));
  EXPECT_THAT(answer_to(server, kEvents), StartsWith("HTTP/1.1 401"));
  const std::string url = server.url();
  const std::string query = url.substr(url.find("/?") + 1);
  const std::string answer = answer_to(server, "GET /" + query + " HTTP/1.1\r\nHost: robot:80\r\n\r\n");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 303"));
  EXPECT_THAT(answer, HasSubstr("HttpOnly"));
}

/// Counts to ten as a program does that is just ending: what is left comes a moment later.
class LastWords : public EventStream {
 public:
  std::string next(milliseconds /*patience*/) override {
    std::this_thread::sleep_for(milliseconds{20});
    return number_ == 10 ? std::string{} : "data: " + std::to_string(number_++) + "\n\n";
  }
  [[nodiscard]] bool ended() const override { return false; }

 private:
  int number_{0};
};

TEST(WebServer, AStreamSaysWhatItHasToSayBeforeTheServerEnds) {
  Site site(kFiles);
  site.on_events("/events", [](const HttpRequest&) { return std::make_unique<LastWords>(); });
  auto server = std::make_unique<WebServer>(std::move(site), WebServerOptions{});
  const RawClient client(*server);
  client.say(kEvents);
  EXPECT_THAT(client.hear("data: 0\n\n"), Not(HasSubstr("data: 9")));
  server.reset();
  EXPECT_THAT(client.hear(), HasSubstr("data: 9\n\n"));
}

TEST(WebServer, EndsPromptlyWithStreamsAndSilentConnectionsOpen) {
  auto server = std::make_unique<WebServer>(counting_site(), WebServerOptions{});
  const RawClient silent(*server);
  const RawClient streaming(*server);
  streaming.say(kEvents);
  EXPECT_THAT(streaming.hear("data: 9\n\n"), HasSubstr("data: 9"));
  const auto begun = std::chrono::steady_clock::now();
  server.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds{3});
}

}  // namespace
}  // namespace sensotwin::robot
