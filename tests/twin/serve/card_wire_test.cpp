// SPDX-License-Identifier: MIT
// A card slot, with vpcd played by the test.
#include "twin/serve/card_wire.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <optional>

#include "serve_bench.hpp"
#include "twin/devices/emulated_card_reader.hpp"

namespace sensotwin::twin {
namespace {

using Peer = CardWire::Peer;
using robot::Bytes;

/// vpcd's side of the wire.
class Vpcd {
 public:
  Vpcd() : listener_(listen_at(at_)) {}
  [[nodiscard]] const Endpoint& endpoint() const { return at_; }
  bool accept() {
    card_ = Handle{::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK)};
    return static_cast<bool>(card_);
  }
  void say(const Bytes& message) const {
    Bytes framed{robot::high_byte(static_cast<std::uint16_t>(message.size())),
                 robot::low_byte(static_cast<std::uint16_t>(message.size()))};
    framed.insert(framed.end(), message.begin(), message.end());
    say_raw(framed);
  }
  void say_raw(const Bytes& bytes) const { ::send(card_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL); }
  [[nodiscard]] Bytes hear() const { return heard_at(card_.get()); }
  [[nodiscard]] bool card_is_gone() const {
    std::uint8_t byte = 0;
    return ::recv(card_.get(), &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
  }
  void stop() {
    card_.reset();
    listener_.reset();
  }
  void hang_up() { card_.reset(); }
  /// The kernel takes some kilobytes for us instead of megabytes, and sends what we say at once.
  void keep_little_unread() const {
    const int bytes = 200'000;
    ::setsockopt(card_.get(), SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
    const int on = 1;
    ::setsockopt(card_.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  }

 private:
  Endpoint at_;
  Handle listener_;
  Handle card_;
};

class ServedCard : public ::testing::Test {
 protected:
  ServedCard() {
    tag_.uid = world::icode_sli_uid(5);
    other_.uid = world::icode_sli_uid(6);
  }
  void tick() {
    now_s_ += 0.015;
    reader_.step(robot::Instant{robot::from_s(now_s_)}, field_);
    wire_.pump(now_s_);
  }
  bool until(const std::function<bool()>& done) {
    return eventually(done, [&] { tick(); });
  }
  /// Asks and waits for an answer.
  Bytes ask(const Bytes& message) {
    vpcd_.say(message);
    Bytes answer;
    EXPECT_TRUE(until([&] {
      const Bytes more = vpcd_.hear();
      answer.insert(answer.end(), more.begin(), more.end());
      return !answer.empty();
    }));
    return answer;
  }
  void put_in() {
    field_ = &tag_;
    ASSERT_TRUE(until([&] { return vpcd_.accept(); }));
    ASSERT_EQ(ask({4}).size(), 22u);
    ASSERT_TRUE(wire_.card_is_in());
  }

  world::TagMemory tag_;
  world::TagMemory other_;
  world::TagMemory* field_{nullptr};
  EmulatedCardReader reader_{CardReaderSettings{.exchange = robot::from_s(0.012)}, robot::RandomStream{1}};
  Vpcd vpcd_;
  CardWire wire_{"floor card", reader_, vpcd_.endpoint()};
  double now_s_{0.0};
};

TEST_F(ServedCard, HoldsItsAnswerForASecondWhileTheSlotIsEmptyThenSaysSoByGoing) {
  ASSERT_TRUE(until([&] { return vpcd_.accept(); }));
  EXPECT_EQ(wire_.peer(), Peer::kUnknown);
  vpcd_.say({4});
  ASSERT_TRUE(until([&] { return wire_.peer() == Peer::kServing; }));
  const double asked_s = now_s_;
  ASSERT_TRUE(until([&] { return vpcd_.card_is_gone(); }));
  EXPECT_NEAR(now_s_ - asked_s, 1.0, 0.05);
  EXPECT_TRUE(until([&] { return vpcd_.accept(); })) << "and is there for the next look";
}

TEST_F(ServedCard, AnswersTheMomentATagComes) {
  ASSERT_TRUE(until([&] { return vpcd_.accept(); }));
  vpcd_.say({4});
  ASSERT_TRUE(until([&] { return wire_.peer() == Peer::kServing; }));
  field_ = &tag_;
  tick();
  EXPECT_EQ(vpcd_.hear().size(), 22u);
}

TEST_F(ServedCard, TellsTheAtrOfAnIcodeSliWhileATagIsThere) {
  put_in();
  EXPECT_THAT(icode_sli_atr(), ::testing::SizeIs(20));
  Bytes expected{0, 20};
  const Bytes atr = icode_sli_atr();
  expected.insert(expected.end(), atr.begin(), atr.end());
  EXPECT_EQ(ask({4}), expected);
  std::uint8_t check = 0;
  for (std::size_t i = 1; i < atr.size(); ++i) {
    check = static_cast<std::uint8_t>(check ^ atr[i]);
  }
  EXPECT_EQ(check, 0) << "TCK (ISO/IEC 7816-3, 8.2.5)";
}

TEST_F(ServedCard, PassesCommandsToTheTagAndItsAnswersBack) {
  put_in();
  vpcd_.say({1});
  vpcd_.say({2});
  EXPECT_EQ(ask({0xFF, 0xCA, 0x00, 0x00, 0x00}), (Bytes{0, 10, 0xE0, 4, 1, 0, 0, 0, 0, 5, 0x90, 0}));
  EXPECT_EQ(ask({0xFF, 0xD6, 0x00, 0x03, 0x04, 1, 2, 3, 4}), (Bytes{0, 2, 0x90, 0}));
  EXPECT_EQ(tag_.blocks[3], (world::TagMemory::Block{1, 2, 3, 4}));
  vpcd_.say({0});
  EXPECT_EQ(ask({4}).size(), 22u);
}

TEST_F(ServedCard, TakesMessagesInPieces) {
  put_in();
  for (const std::uint8_t byte : Bytes{0, 5, 0xFF, 0xCA, 0x00, 0x00}) {
    vpcd_.say_raw({byte});
    tick();
  }
  vpcd_.say_raw({0x00});
  Bytes answer;
  EXPECT_TRUE(until([&] {
    answer = vpcd_.hear();
    return !answer.empty();
  }));
  EXPECT_EQ(answer.size(), 12u);
}

TEST_F(ServedCard, VanishesWithTheTagAndAppearsWithTheNext) {
  put_in();
  field_ = nullptr;
  ASSERT_TRUE(until([&] { return vpcd_.card_is_gone(); }));
  EXPECT_FALSE(wire_.card_is_in());
  field_ = &other_;
  ASSERT_TRUE(until([&] { return vpcd_.accept(); }));
  EXPECT_EQ(ask({4}).size(), 22u);
  EXPECT_EQ(ask({0xFF, 0xCA, 0x00, 0x00, 0x00})[9], 6);
}

TEST_F(ServedCard, KnowsWhenPcscdHasNoticed) {
  EXPECT_FALSE(wire_.is_settled(now_s_)) << "nobody knows whether there is a pcscd";
  put_in();
  EXPECT_FALSE(wire_.is_settled(now_s_)) << "its client has not spoken to the tag";
  EXPECT_TRUE(wire_.is_settled(now_s_ + 0.2)) << "and perhaps never will";
  EXPECT_EQ(ask({0xFF, 0xCA, 0x00, 0x00, 0x00}).size(), 12u);
  EXPECT_TRUE(wire_.is_settled(now_s_));
  field_ = nullptr;
  tick();
  EXPECT_FALSE(wire_.is_settled(now_s_));
  EXPECT_TRUE(wire_.is_settled(now_s_ + 2.0)) << "it has had time enough";
  vpcd_.say({4});
  EXPECT_TRUE(vpcd_.card_is_gone());
  vpcd_.hang_up();
  EXPECT_TRUE(until([&] { return wire_.is_settled(now_s_); }));
  field_ = &other_;
  tick();
  EXPECT_FALSE(wire_.is_settled(now_s_));
  ASSERT_TRUE(vpcd_.accept());
  EXPECT_EQ(ask({4}).size(), 22u);
  EXPECT_FALSE(wire_.is_settled(now_s_));
  EXPECT_TRUE(until([&] { return wire_.is_settled(now_s_); }));
}

TEST_F(ServedCard, WaitsForTheFirstWordOfAClientThatHasJustCome) {
  put_in();
  EXPECT_TRUE(until([&] { return wire_.is_settled(now_s_); })) << "nobody drives";
  wire_.await_client(now_s_);
  EXPECT_FALSE(wire_.is_settled(now_s_ + 0.9));
  EXPECT_TRUE(wire_.is_settled(now_s_ + 1.1)) << "it does not care for tags";
  EXPECT_EQ(ask({0xFF, 0xCA, 0x00, 0x00, 0x00}).size(), 12u);
  EXPECT_TRUE(wire_.is_settled(now_s_));
}

TEST_F(ServedCard, ShowsAnExchangedTagAsARemovedOne) {
  put_in();
  field_ = &other_;
  EXPECT_TRUE(until([&] { return vpcd_.card_is_gone(); }));
}

TEST_F(ServedCard, EndsAnExchangeWhoseTagLeavesWithoutAnAnswer) {
  put_in();
  reader_.set_extra_delay(robot::from_s(0.1));
  const std::uint64_t heard = wire_.tally().bytes_in;
  vpcd_.say({0xFF, 0xCA, 0x00, 0x00, 0x00});
  ASSERT_TRUE(eventually([&] { return wire_.tally().bytes_in > heard; }, [&] { wire_.pump(now_s_); }));
  field_ = nullptr;
  EXPECT_TRUE(until([&] { return vpcd_.card_is_gone(); }));
  EXPECT_EQ(reader_.presence(), robot::CardPresence::kEmpty);
}

TEST_F(ServedCard, KeepsOneConnectionForManyTagsThatNobodyLookedAt) {
  for (int i = 0; i < 50; ++i) {
    field_ = i % 2 == 0 ? &tag_ : nullptr;
    tick();
  }
  field_ = &tag_;
  tick();
  ASSERT_TRUE(until([&] { return vpcd_.accept(); }));
  EXPECT_EQ(ask({4}).size(), 22u) << "the first look shows what is there now";
}

TEST_F(ServedCard, SaysThatNobodyListensAndComesWhenSomebodyDoes) {
  const Endpoint at = vpcd_.endpoint();
  vpcd_.stop();
  CardWire wire("floor card", reader_, at);
  ASSERT_TRUE(eventually([&] { return wire.peer() == Peer::kAbsent; }, [&] { wire.pump(0.0); }));
  Endpoint same = at;
  const Handle listener = listen_at(same);
  wire.pump(0.5);
  EXPECT_EQ(wire.peer(), Peer::kAbsent) << "asked once a second only";
  wire.pump(1.1);
  std::optional<Handle> card;
  EXPECT_TRUE(eventually(
      [&] {
        card.emplace(::accept(listener.get(), nullptr, nullptr));
        return static_cast<bool>(*card);
      },
      [&] { wire.pump(1.1); }));
}

TEST_F(ServedCard, SaysThatItIsNotAskedAfterThreeSeconds) {
  tick();
  wire_.pump(now_s_ + 1.0);
  EXPECT_EQ(wire_.peer(), Peer::kUnknown);
  wire_.pump(now_s_ + 4.0);
  EXPECT_EQ(wire_.peer(), Peer::kSilent);
}

TEST_F(ServedCard, ComesBackAfterPcscdWasRestarted) {
  put_in();
  vpcd_.hang_up();
  EXPECT_TRUE(until([&] { return vpcd_.accept(); }));
  EXPECT_EQ(ask({4}).size(), 22u);
}

// TCP sees to it: a peer whose buffer is full is not heard either, so nothing is answered that is not taken.
TEST_F(ServedCard, NeitherStallsNorGrowsForAPeerThatAsksOnAndOnAndNeverReads) {
  put_in();
  vpcd_.keep_little_unread();
  std::uint64_t said = wire_.tally().bytes_in;
  int quiet_ticks = 0;
  for (int i = 0; i < 1'000'000 && quiet_ticks < 1000; ++i) {
    quiet_ticks = wire_.tally().bytes_in == said ? 0 : quiet_ticks + 1;
    if (quiet_ticks == 0) {
      vpcd_.say({0xFF, 0xB0, 0, 0, 0});  // the whole memory: 116 bytes for 7
      said += 7;
    }
    tick();
  }
  EXPECT_EQ(quiet_ticks, 1000) << "it is listened to for ever";
  EXPECT_LT(wire_.tally().bytes_out, 2'000'000u) << "what the kernel took";
  vpcd_.hang_up();
  ASSERT_TRUE(until([&] { return vpcd_.accept(); })) << "the next one is served";
  EXPECT_EQ(ask({4}).size(), 22u);
}

TEST_F(ServedCard, Survives10MegabytesOfRandomBytes) {
  field_ = &tag_;
  const Bytes bytes = noise(10'000'000);
  for (std::size_t at = 0; at < bytes.size(); at += 50'000) {
    vpcd_.say_raw({bytes.begin() + static_cast<std::ptrdiff_t>(at),
                   bytes.begin() + static_cast<std::ptrdiff_t>(at + 50'000)});
    tick();
    if (vpcd_.card_is_gone()) {
      vpcd_.accept();
    }
    static_cast<void>(vpcd_.hear());
  }
  vpcd_.hang_up();
  ASSERT_TRUE(until([&] { return vpcd_.accept(); }));
  EXPECT_EQ(ask({4}).size(), 22u);
}

}  // namespace
}  // namespace sensotwin::twin
