// SPDX-License-Identifier: MIT
#include "robot/ports/card_port.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <atomic>
#include <memory>

namespace sensotwin::robot {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A PC/SC service with one reader, played by the test.
struct FakeService {
  std::mutex mutex;
  bool running{true};
  bool plugged{true};
  bool card{true};
  std::uint16_t changes{1};
  std::optional<CardFault> fault;  ///< of the next exchange
  int sessions{0};
  int connections{0};
  std::vector<Bytes> heard;

  template <class Change>
  void now(const Change& change) {
    const std::lock_guard lock(mutex);
    change(*this);
  }
};

class FakeSession : public CardSession {
 public:
  explicit FakeSession(FakeService& service) : service_(service) {}

  Result<std::vector<std::string>, CardFault> readers() override {
    return std::vector<std::string>{"Fake Reader 00 00"};
  }
  Result<CardField, CardFault> look(const std::string& reader) override {
    const std::lock_guard lock(service_.mutex);
    if (!service_.running) {
      return Unexpected{CardFault::kNoService};
    }
    if (!service_.plugged || reader != "Fake Reader 00 00") {
      return Unexpected{CardFault::kNoReader};
    }
    return CardField{service_.card, service_.changes};
  }
  Result<bool, CardFault> connect(const std::string&) override {
    const std::lock_guard lock(service_.mutex);
    if (!service_.card) {
      return Unexpected{CardFault::kNoCard};
    }
    ++service_.connections;
    return true;
  }
  Result<Bytes, CardFault> transmit(ByteView command) override {
    const std::lock_guard lock(service_.mutex);
    service_.heard.emplace_back(command.begin(), command.end());
    if (const auto fault = std::exchange(service_.fault, std::nullopt)) {
      return Unexpected{*fault};
    }
    if (!service_.running) {
      return Unexpected{CardFault::kNoService};
    }
    return service_.card ? Result<Bytes, CardFault>{Bytes{0x90, 0x00}} : Unexpected{CardFault::kNoCard};
  }
  void disconnect() override {}

 private:
  FakeService& service_;
};

class CardPortOnAService : public ::testing::Test {
 protected:
  /// Waits, two seconds at most, until it holds.
  template <class Condition>
  static bool soon(const Condition& holds) {
    for (int i = 0; i < 400; ++i) {
      if (holds()) {
        return true;
      }
      ::poll(nullptr, 0, 5);
    }
    return false;
  }
  bool becomes(CardPresence presence) {
    return soon([&] { return port.presence() == presence; });
  }
  std::optional<Result<Bytes, CardError>> exchange() {
    EXPECT_TRUE(port.begin(Bytes{0xFF, 0xCA, 0, 0, 0}));
    std::optional<Result<Bytes, CardError>> answer;
    soon([&] {
      answer = port.poll();
      return answer.has_value();
    });
    return answer;
  }

  FakeService service;
  CardPort port{{.reader = "Fake Reader 00 00",
                 .look_every = std::chrono::milliseconds{2},
                 .retry_every = std::chrono::milliseconds{5}},
                [this]() -> Result<std::unique_ptr<CardSession>, CardFault> {
                  const std::lock_guard lock(service.mutex);
                  if (!service.running) {
                    return Unexpected{CardFault::kNoService};
                  }
                  ++service.sessions;
                  return std::unique_ptr<CardSession>{std::make_unique<FakeSession>(service)};
                }};
};

TEST_F(CardPortOnAService, BringsACommandToTheCardAndItsAnswerBackOnce) {
  ASSERT_TRUE(becomes(CardPresence::kPresent));
  const auto answer = exchange();
  ASSERT_TRUE(answer && *answer);
  EXPECT_THAT(**answer, ElementsAre(0x90, 0x00));
  EXPECT_FALSE(port.poll());
  service.now([](FakeService& s) { EXPECT_THAT(s.heard, ElementsAre(Bytes{0xFF, 0xCA, 0, 0, 0})); });
}

TEST_F(CardPortOnAService, TakesOneCommandAtATime) {
  ASSERT_TRUE(becomes(CardPresence::kPresent));
  EXPECT_TRUE(port.begin(Bytes{1}));
  EXPECT_FALSE(port.begin(Bytes{2}));
}

TEST_F(CardPortOnAService, SeesTheCardGoAndComeAndConnectsAnew) {
  ASSERT_TRUE(becomes(CardPresence::kPresent));
  ASSERT_TRUE(exchange());
  service.now([](FakeService& s) { s.card = false, ++s.changes; });
  ASSERT_TRUE(becomes(CardPresence::kEmpty));
  EXPECT_FALSE(port.begin(Bytes{1}));
  service.now([](FakeService& s) { s.card = true, ++s.changes; });
  ASSERT_TRUE(becomes(CardPresence::kPresent));
  ASSERT_TRUE(exchange());
  service.now([](FakeService& s) { EXPECT_EQ(s.connections, 2); });
}

TEST_F(CardPortOnAService, ShowsAnEmptyFieldOnceWhenOneCardTookAnothersPlaceBetweenTwoLooks) {
  ASSERT_TRUE(becomes(CardPresence::kPresent));
  service.now([](FakeService& s) { s.changes = static_cast<std::uint16_t>(s.changes + 2); });
  EXPECT_TRUE(becomes(CardPresence::kEmpty));
  EXPECT_EQ(port.presence(), CardPresence::kPresent);
}

TEST_F(CardPortOnAService, NamesWhatWentWrongInAnExchange) {
  ASSERT_TRUE(becomes(CardPresence::kPresent));
  service.now([](FakeService& s) { s.fault = CardFault::kNoCard; });
  auto answer = exchange();
  ASSERT_TRUE(answer && !*answer);
  EXPECT_EQ(answer->error(), CardError::kRemoved);
  service.now([](FakeService& s) { s.fault = CardFault::kNoAnswer; });
  answer = exchange();
  ASSERT_TRUE(answer && !*answer);
  EXPECT_EQ(answer->error(), CardError::kTimeout);
}

TEST_F(CardPortOnAService, RepeatsACommandThatAnotherProgramsResetCutOff) {
  ASSERT_TRUE(becomes(CardPresence::kPresent));
  service.now([](FakeService& s) { s.fault = CardFault::kReset; });
  const auto answer = exchange();
  EXPECT_TRUE(answer && *answer);
  service.now([](FakeService& s) { EXPECT_EQ(s.connections, 2); });
}

TEST_F(CardPortOnAService, WaitsForAReaderThatWasUnpluggedAndSaysSo) {
  ASSERT_TRUE(becomes(CardPresence::kPresent));
  service.now([](FakeService& s) { s.plugged = false; });
  ASSERT_TRUE(becomes(CardPresence::kNoReader));
  EXPECT_THAT(port.trouble(), HasSubstr("no such PC/SC reader"));
  service.now([](FakeService& s) { s.plugged = true; });
  EXPECT_TRUE(becomes(CardPresence::kPresent));
  EXPECT_TRUE(port.trouble().empty());
  service.now([](FakeService& s) { EXPECT_EQ(s.sessions, 1); });
}

TEST_F(CardPortOnAService, BeginsANewSessionAfterTheServiceWasRestarted) {
  ASSERT_TRUE(becomes(CardPresence::kPresent));
  service.now([](FakeService& s) { s.running = false; });
  ASSERT_TRUE(becomes(CardPresence::kNoReader));
  EXPECT_THAT(port.trouble(), HasSubstr("pcscd does not answer"));
  service.now([](FakeService& s) { s.running = true; });
  ASSERT_TRUE(becomes(CardPresence::kPresent));
  EXPECT_TRUE(exchange());
  service.now([](FakeService& s) { EXPECT_EQ(s.sessions, 2); });
}

TEST_F(CardPortOnAService, AnswersThatTheReaderIsGoneWhenTheServiceDiesInAnExchange) {
  ASSERT_TRUE(becomes(CardPresence::kPresent));
  service.now([](FakeService& s) { s.fault = CardFault::kNoService; });
  const auto answer = exchange();
  ASSERT_TRUE(answer && !*answer);
  EXPECT_EQ(answer->error(), CardError::kReaderGone);
}

}  // namespace
}  // namespace sensotwin::robot
