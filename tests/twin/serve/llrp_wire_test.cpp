// SPDX-License-Identifier: MIT
// The emulated reader at a TCP port, by clients as the network has them.
#include "twin/serve/llrp_wire.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "robot/wire/llrp/codec.hpp"
#include "serve_bench.hpp"
#include "tests/twin/devices/uhf_bench.hpp"

namespace sensotwin::twin {
namespace {

namespace llrp = robot::llrp;
using robot::Bytes;

class ServedReader : public ::testing::Test {
 protected:
  ServedReader() { bench_.reader.link().cut(); }
  /// 15 ms of the reader's time, and of ours as the wire sees it.
  void tick() {
    now_s_ += 0.015;
    bench_.reader.step(robot::Instant{robot::from_s(now_s_)});
    wire_.pump(now_s_);
  }
  /// Ticks until `size` bytes have been heard.
  Bytes hear(const TcpClient& client, std::size_t size) {
    Bytes all;
    EXPECT_TRUE(eventually([&] { return all.size() >= size; },
                           [&] {
                             tick();
                             const Bytes more = client.hear();
                             all.insert(all.end(), more.begin(), more.end());
                           }))
        << all.size() << " of " << size << " bytes";
    return all;
  }
  /// What the message of the connection event says.
  static int connection_status(const Bytes& bytes) {
    EXPECT_EQ(bytes.size(), 32u);
    return bytes.size() == 32 ? robot::u16_from_be(bytes[30], bytes[31]) : -1;
  }
  bool ends(const TcpClient& client) {
    return eventually([&] { return client.is_over(); }, [&] { tick(); });
  }

  UhfBench bench_;
  LlrpWire wire_{"llrp", bench_.reader, Endpoint{}};
  double now_s_{0.0};
};

TEST_F(ServedReader, SpeaksFirst) {
  const TcpClient client(wire_.endpoint());
  EXPECT_EQ(connection_status(hear(client, 32)), 0);
  EXPECT_TRUE(wire_.has_client());
}

TEST_F(ServedReader, SendsASecondClientAwayAndTellsTheFirst) {
  const TcpClient first(wire_.endpoint());
  EXPECT_EQ(connection_status(hear(first, 32)), 0);
  const TcpClient second(wire_.endpoint());
  EXPECT_EQ(connection_status(hear(second, 32)), 2) << "a client initiated connection already exists";
  EXPECT_TRUE(ends(second));
  EXPECT_EQ(connection_status(hear(first, 32)), 4) << "another connection attempted";
  first.say(llrp::encode(llrp::GetRoSpecs{}, 5));
  EXPECT_EQ(hear(first, 18).size(), 18u) << "the first is served on";
  EXPECT_EQ(wire_.tally().refused, 1u);
}

TEST_F(ServedReader, IsFreeAgainAsSoonAsItsClientIsGone) {
  for (int i = 0; i < 3; ++i) {
    const TcpClient client(wire_.endpoint());
    EXPECT_EQ(connection_status(hear(client, 32)), 0) << "client " << i;
  }
}

TEST_F(ServedReader, IsFreeAgainAfterAClientThatLeftInMidMessage) {
  {
    const TcpClient client(wire_.endpoint());
    hear(client, 32);
    client.say(Bytes{0x04, 0x01, 0x00, 0x00});
    tick();
  }
  const TcpClient next(wire_.endpoint());
  EXPECT_EQ(connection_status(hear(next, 32)), 0);
  next.say(llrp::encode(llrp::GetRoSpecs{}, 5));
  EXPECT_EQ(hear(next, 18).size(), 18u);
}

TEST_F(ServedReader, AnswersCloseConnectionAndThenCloses) {
  const TcpClient client(wire_.endpoint());
  hear(client, 32);
  client.say(llrp::encode(llrp::CloseConnection{}, 9));
  const Bytes answer = hear(client, 18);
  EXPECT_EQ(answer[1], 4) << "CLOSE_CONNECTION_RESPONSE";
  EXPECT_TRUE(ends(client));
  EXPECT_FALSE(wire_.has_client());
}

TEST_F(ServedReader, TakesMessagesInPiecesAndSeveralAtOnce) {
  const TcpClient client(wire_.endpoint());
  hear(client, 32);
  const Bytes one = llrp::encode(llrp::GetRoSpecs{}, 5);
  for (const std::uint8_t byte : one) {
    client.say({&byte, 1});
    tick();
  }
  Bytes two = one;
  two.insert(two.end(), one.begin(), one.end());
  client.say(two);
  EXPECT_EQ(hear(client, 54).size(), 54u);
}

TEST_F(ServedReader, SaysThatItClosesWhenItIsShutDown) {
  auto wire = std::make_unique<LlrpWire>("llrp", bench_.reader, Endpoint{});
  const TcpClient client(wire->endpoint());
  ASSERT_TRUE(eventually([&] { return wire->has_client(); }, [&] { wire->pump(0.0); }));
  EXPECT_EQ(client.hear(1000).size(), 32u);
  wire.reset();
  const Bytes last = client.hear(1000);
  ASSERT_EQ(last.size(), 30u);
  EXPECT_EQ(robot::u16_from_be(last[26], last[27]), 257) << "ConnectionCloseEvent";
  EXPECT_TRUE(client.is_over());
}

TEST_F(ServedReader, LosesReportsAndNoMemoryForAClientThatNeverReads) {
  const TcpClient client(wire_.endpoint());
  hear(client, 32);
  client.say(llrp::encode(llrp::AddRoSpec{plain_ro_spec()}, 1));
  client.say(llrp::encode(llrp::EnableRoSpec{7}, 2));
  ASSERT_TRUE(eventually([&] { return !bench_.reader.antennas().empty(); }, [&] { tick(); }));
  for (int i = 0; i < 200'000; ++i) {
    bench_.reader.report({.at = robot::Instant{robot::from_s(now_s_)}, .epc = {1}});
    if (i % 100 == 0) {
      tick();
    }
  }
  tick();
  EXPECT_GT(wire_.tally().reports_lost, 0u);
  EXPECT_TRUE(wire_.has_client()) << "it may yet read";
  EXPECT_LT(client.hear().size(), 8'000'000u) << "the kernel's buffers and ours";
}

TEST_F(ServedReader, ThrowsOutAClientThatAsksOnAndOnAndNeverReads) {
  const TcpClient client(wire_.endpoint());
  hear(client, 32);
  const Bytes ask = llrp::encode(llrp::GetReaderCapabilities{}, 5);
  bool thrown_out = false;
  for (int i = 0; i < 100'000 && !thrown_out; ++i) {
    client.say(ask);
    tick();
    thrown_out = !wire_.has_client();
  }
  EXPECT_TRUE(thrown_out);
  const TcpClient next(wire_.endpoint());
  EXPECT_EQ(connection_status(hear(next, 32)), 0);
}

TEST_F(ServedReader, Survives10MegabytesOfRandomBytes) {
  const Bytes bytes = noise(10'000'000);
  std::size_t sent = 0;
  int connections = 0;
  while (sent < bytes.size()) {
    const TcpClient client(wire_.endpoint());
    ++connections;
    // It is closed at the first thing that cannot be a header, and the next one goes on.
    for (int i = 0; i < 50 && sent < bytes.size() && !client.is_over(); ++i) {
      const std::size_t chunk = std::min<std::size_t>(bytes.size() - sent, 65536);
      sent += client.say(robot::ByteView{bytes}.subspan(sent, chunk));
      tick();
      static_cast<void>(client.hear());
    }
  }
  EXPECT_GT(connections, 1);
  const TcpClient client(wire_.endpoint());
  EXPECT_EQ(connection_status(hear(client, 32)), 0);
}

}  // namespace
}  // namespace sensotwin::twin
