// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <chrono>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "robot/base/random.hpp"
#include "robot/telemetry/telemetry_hub.hpp"
#include "robot/telemetry/telemetry_log.hpp"

namespace sensotwin::robot {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr milliseconds kNoPatience{0};

void append(TelemetryLog& log, const std::string& key, const std::string& json) {
  std::vector<TelemetryMessage> one{{key, json}};
  log.append(one);
}

/// The data lines of server-sent events.
std::vector<std::string> data_of(const std::string& text) {
  std::vector<std::string> data;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("data: ")) {
      data.push_back(line.substr(6));
    }
  }
  return data;
}

TEST(TelemetryLog, KeepsTheNewestOfEachKeyInTheOrderOfHappening) {
  TelemetryLog log("run");
  append(log, "pose", "1");
  append(log, "tile/0,0", "2");
  append(log, "pose", "3");
  EXPECT_THAT(data_of(log.after(0, 1000).text), ElementsAre("2", "3"));
}

TEST(TelemetryLog, GoesOnBehindWhatAReaderHasHad) {
  TelemetryLog log("run");
  append(log, "a", "1");
  append(log, "b", "2");
  const auto first = log.after(0, 1);
  EXPECT_THAT(data_of(first.text), ElementsAre("1"));
  EXPECT_THAT(first.text, HasSubstr("id: run.1\n"));
  EXPECT_THAT(data_of(log.after(first.last, 1000).text), ElementsAre("2"));
}

TEST(TelemetryLog, KnowsItsOwnNumbersOnly) {
  TelemetryLog log("run");
  append(log, "a", "1");
  EXPECT_EQ(log.number_of("run.1"), 1U);
  for (const char* other :
       {"", "run", "run.", "run.2", "run.x", "other.1", "run.1x", "run.-1", "run.99999999999999999999"}) {
    EXPECT_EQ(log.number_of(other), 0U) << other;
  }
}

TEST(TelemetryLog, TakesNoMoreKeysThanItMayAndCountsTheRest) {
  TelemetryLog log("run", 2);
  append(log, "a", "1");
  append(log, "b", "2");
  append(log, "c", "3");
  append(log, "a", "4");
  EXPECT_THAT(data_of(log.after(0, 1000).text), ElementsAre("2", "4"));
  EXPECT_EQ(log.dropped(), 1U);
}

/// What a page has drawn: of each key the newest. Here a message is "key=value".
using Picture = std::map<std::string, std::string>;
void draw(Picture& picture, const std::string& text) {
  for (const std::string& data : data_of(text)) {
    if (const auto equals = data.find('='); equals != std::string::npos) {
      picture[data.substr(0, equals)] = data.substr(equals + 1);
    }
  }
}

TEST(TelemetryHub, ALateReaderAndASlowOneSeeThePictureOfTheOneWhoSawItAll) {
  TelemetryHub hub("run");
  const auto live = hub.stream("");
  const auto slow = hub.stream("");
  Picture seen_live;
  Picture seen_slowly;
  Picture truth;
  RandomStream random(7);
  for (int i = 0; i < 5000; ++i) {
    const std::string key = "tile/" + std::to_string(static_cast<int>(random.uniform(0.0, 200.0)));
    truth[key] = std::to_string(i);
    hub.publish({key, key + "=" + std::to_string(i)});
    if (i % 10 == 0) {
      hub.flush();
      draw(seen_live, live->next(kNoPatience));
    }
    if (i % 1700 == 0) {
      draw(seen_slowly, slow->next(kNoPatience));
    }
  }
  hub.flush();
  const auto late = hub.stream("");
  Picture seen_late;
  draw(seen_live, live->next(kNoPatience));
  draw(seen_slowly, slow->next(kNoPatience));
  draw(seen_late, late->next(kNoPatience));
  EXPECT_EQ(seen_live, truth);
  EXPECT_EQ(seen_slowly, truth);
  EXPECT_EQ(seen_late, truth);
}

TEST(TelemetryHub, AReaderThatComesBackGoesOnWhereItWas) {
  TelemetryHub hub("run");
  hub.publish({"a", "1"});
  hub.publish({"b", "2"});
  hub.flush();
  EXPECT_THAT(data_of(hub.stream("run.1")->next(kNoPatience)), ElementsAre("2"));
}

TEST(TelemetryHub, AReaderOfAnotherRunIsToldToBeginAnew) {
  TelemetryHub hub("run");
  hub.publish({"a", "1"});
  hub.flush();
  EXPECT_THAT(data_of(hub.stream("yesterday.7")->next(kNoPatience)), ElementsAre(R"({"k":"reset"})", "1"));
}

TEST(TelemetryHub, SpreadsByItself) {
  TelemetryHub hub("run");
  const auto stream = hub.stream("run.0");
  hub.publish({"a", "1"});
  std::string text;
  for (int i = 0; i < 50 && data_of(text).size() < 2; ++i) {
    text += stream->next(milliseconds{100});
  }
  EXPECT_THAT(data_of(text), ElementsAre(R"({"k":"reset"})", "1"));
}

TEST(TelemetryHub, NoMessageOfABusyLoopIsLostHoweverManyRead) {
  TelemetryHub hub("run");
  std::vector<std::thread> readers;
  std::vector<Picture> pictures(4);
  for (Picture& picture : pictures) {
    readers.emplace_back([&hub, &picture] {
      const auto stream = hub.stream("");
      while (!picture.contains("last")) {
        draw(picture, stream->next(milliseconds{50}));
      }
    });
  }
  for (int i = 0; i < 60'000; ++i) {
    const std::string key = "tile/" + std::to_string(i % 3000);
    hub.publish({key, key + "=" + std::to_string(i)});
  }
  hub.publish({"last", "last=1"});
  for (std::thread& reader : readers) {
    reader.join();
  }
  for (const Picture& picture : pictures) {
    EXPECT_EQ(picture.size(), 3001U);
    EXPECT_EQ(picture.at("tile/2999"), "59999");
    EXPECT_EQ(picture.at("tile/0"), "57000");
  }
}

TEST(TelemetryHub, AStreamEndsWithTheLog) {
  auto hub = std::make_unique<TelemetryHub>("run");
  const auto stream = hub->stream("");
  EXPECT_FALSE(stream->ended());
  EXPECT_THAT(data_of(stream->next(kNoPatience)), ElementsAre(R"({"k":"reset"})"));
  EXPECT_THAT(stream->next(kNoPatience), IsEmpty());
}

}  // namespace
}  // namespace sensotwin::robot
