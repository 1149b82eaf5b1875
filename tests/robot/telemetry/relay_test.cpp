// SPDX-License-Identifier: MIT
#include "robot/telemetry/relay.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "robot/telemetry/monitor.hpp"
#include "robot/telemetry/program_tap.hpp"
#include "robot/telemetry/web/web_error.hpp"

namespace sensotwin::robot {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// All that a page is told, once `wanted` is in it or five seconds are over.
std::string told(TelemetryHub& hub, const std::string& wanted) {
  std::string text;
  for (int i = 0; i < 100 && text.find(wanted) == std::string::npos; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds{50});
    hub.flush();
    text = hub.log().after(0, 1U << 20U).text;
  }
  return text;
}

RobotCard card(const std::string& name) {
  RobotCard card;
  card.name = name;
  return card;
}

TEST(Relay, ShowsTheRobotsOfOtherMonitorsSideBySide) {
  Monitor kitchen{WebAddress{}};
  Monitor hall{WebAddress{.host = "0.0.0.0"}};  // asks for its token
  ProgramTap in_kitchen(kitchen.hub(), card("kitchen"));
  ProgramTap in_hall(hall.hub(), card("hall"));
  TelemetryHub page("page");
  const Relay first(page, 0, kitchen.url());
  const Relay second(page, 1, hall.url());
  EXPECT_THAT(told(page, "kitchen"), HasSubstr(R"({"r":0,"key":"robot","k":"robot","name":"kitchen")"));
  EXPECT_THAT(told(page, "hall"), HasSubstr(R"({"r":1,"key":"robot","k":"robot","name":"hall")"));
  in_hall.publish("tile/3,4", "tile", R"(,"c":3,"w":4)");
  EXPECT_THAT(told(page, "tile/3,4"), HasSubstr(R"({"r":1,"key":"tile/3,4","k":"tile","c":3,"w":4})"));
}

TEST(Relay, ComesBackToAMonitorThatWasStartedAgainAndForgetsTheOldRun) {
  auto monitor = std::make_unique<Monitor>(WebAddress{});
  const std::string url = monitor->url();
  const std::string port = url.substr(url.rfind(':') + 1);
  ProgramTap first(monitor->hub(), card("first"));
  TelemetryHub page("page");
  const Relay relay(page, 0, url);
  EXPECT_THAT(told(page, "first"), HasSubstr("first"));
  monitor.reset();
  EXPECT_THAT(told(page, R"("up":false)"), HasSubstr(R"("up":false)"));
  monitor = std::make_unique<Monitor>(WebAddress{.port = static_cast<std::uint16_t>(std::stoi(port))});
  ProgramTap second(monitor->hub(), card("second"));
  const std::string text = told(page, "second");
  EXPECT_THAT(text, HasSubstr("second"));
  EXPECT_THAT(text, HasSubstr(R"("k":"restarted")"));
  EXPECT_THAT(text, Not(HasSubstr("first")));
}

TEST(Relay, SaysThatAMonitorAnswersAgainWhoseRunWentOnMeanwhile) {
  const auto serve = [](const TelemetryHub& hub, std::uint16_t port) {
    Site site({});
    site.on_events("/events", [&hub](const HttpRequest& request) {
      return hub.stream(request.header("Last-Event-ID"));
    });
    return std::make_unique<WebServer>(std::move(site), WebServerOptions{.address = {.port = port}});
  };
  TelemetryHub robot("run");
  ProgramTap tap(robot, card("robot"));
  auto server = serve(robot, 0);
  const std::uint16_t port = server->address().port;
  TelemetryHub page("page");
  const Relay relay(page, 0, server->url());
  const std::string there = R"("up":true,"at":"http://127.0.0.1:)" + std::to_string(port) + "\"";
  EXPECT_THAT(told(page, there), HasSubstr(there));
  EXPECT_THAT(told(page, R"("name":"robot")"), HasSubstr(R"("name":"robot")"));
  server.reset();
  EXPECT_THAT(told(page, R"("up":false)"), HasSubstr(R"("up":false)"));
  server = serve(robot, port);
  EXPECT_THAT(told(page, there), HasSubstr(there));
}

TEST(Relay, SaysWhereAMonitorIsThatDoesNotAnswerAndNeverItsToken) {
  TelemetryHub page("page");
  const Relay relay(page, 0, "http://127.0.0.1:1/?token=secret");
  const std::string text = told(page, "127.0.0.1:1");
  EXPECT_THAT(text, HasSubstr(R"("up":false,"at":"http://127.0.0.1:1")"));
  EXPECT_THAT(text, Not(HasSubstr("secret")));
}

TEST(Relay, TakesAddressesOfMonitorsOnly) {
  EXPECT_EQ(page_url("http://127.0.0.1:8420/").origin, "http://127.0.0.1:8420");
  EXPECT_EQ(page_url("http://robot:8420/?token=ab").token, "ab");
  for (const char* other : {"", "127.0.0.1:8420", "https://robot/", "http://", "http:///x",
                            "http://robot/events", "file:///etc/passwd"}) {
    EXPECT_THROW((void)page_url(other), WebError) << other;
  }
}

}  // namespace
}  // namespace sensotwin::robot
