// SPDX-License-Identifier: MIT
#include "robot/ports/tcp_port.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

#include "robot/ports/descriptor.hpp"

namespace sensotwin::robot {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Instant at(int ms) {
  return Instant{milliseconds{ms}};
}

/// Listens on a port of this machine.
class Peer {
 public:
  explicit Peer(std::uint16_t port = 0) : listener_(::socket(AF_INET, SOCK_STREAM, 0)) {
    const int yes = 1;
    (void)::setsockopt(listener_.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    socklen_t size = sizeof address;
    auto* const plain = reinterpret_cast<sockaddr*>(&address);
    if (::bind(listener_.get(), plain, size) != 0 || ::listen(listener_.get(), 1) != 0 ||
        ::getsockname(listener_.get(), plain, &size) != 0) {
      throw std::runtime_error("cannot listen");
    }
    port_ = ntohs(address.sin_port);
  }
  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// The client's other end, or nothing within a second.
  [[nodiscard]] Descriptor accept() const {
    pollfd state{listener_.get(), POLLIN, 0};
    return ::poll(&state, 1, 1000) == 1 ? Descriptor{::accept(listener_.get(), nullptr, nullptr)}
                                        : Descriptor{};
  }

 private:
  Descriptor listener_;
  std::uint16_t port_{0};
};

bool comes_up(TcpPort& port, int from_ms, int until_ms) {
  for (int ms = from_ms; ms < until_ms; ms += 15) {
    port.keep(at(ms));
    if (port.is_up()) {
      return true;
    }
    ::poll(nullptr, 0, 1);
  }
  return false;
}

/// What comes within a second.
Bytes read_some(ByteLink& port) {
  Bytes bytes(4096);
  for (int i = 0; i < 1000; ++i) {
    if (const std::size_t size = port.read(bytes)) {
      bytes.resize(size);
      return bytes;
    }
    ::poll(nullptr, 0, 1);
  }
  return {};
}

TEST(TcpPort, CarriesBytesBothWays) {
  const Peer peer;
  TcpPort port{{.address = {"127.0.0.1", peer.port()}}};
  ASSERT_TRUE(comes_up(port, 0, 1000));
  const Descriptor other = peer.accept();
  EXPECT_TRUE(port.write(Bytes{1, 2, 3}));
  std::array<std::uint8_t, 8> heard{};
  EXPECT_EQ(::recv(other.get(), heard.data(), 3, MSG_WAITALL), 3);
  EXPECT_EQ(heard[2], 3);
  ASSERT_EQ(::send(other.get(), "ab", 2, 0), 2);
  EXPECT_THAT(read_some(port), ElementsAre('a', 'b'));
}

TEST(TcpPort, ConnectsAgainAfterThePeerClosed) {
  const Peer peer;
  TcpPort port{{.address = {"127.0.0.1", peer.port()}}};
  ASSERT_TRUE(comes_up(port, 0, 1000));
  peer.accept().close();
  EXPECT_TRUE(read_some(port).empty());
  EXPECT_FALSE(port.is_up());
  EXPECT_THAT(port.trouble(), HasSubstr("closed by the peer"));
  EXPECT_FALSE(port.write(Bytes{1}));
  ASSERT_TRUE(comes_up(port, 1000, 3000));
  EXPECT_TRUE(peer.accept());
  EXPECT_EQ(port.health().opened, 2u);
}

TEST(TcpPort, WaitsForAReaderThatBootsWithPausesThatGrow) {
  std::uint16_t number = 0;
  {
    const Peer peer;
    number = peer.port();
  }
  TcpPort port{{.address = {"127.0.0.1", number}}};
  EXPECT_FALSE(comes_up(port, 0, 900));
  EXPECT_THAT(port.trouble(), HasSubstr("Connection refused"));
  const Peer peer(number);
  // The second attempt was at 0.5 s, so the third comes one second after it.
  EXPECT_FALSE(comes_up(port, 900, 1400));
  EXPECT_TRUE(comes_up(port, 1400, 2000));
}

TEST(TcpPort, GivesUpAPeerThatDoesNotAnswerAndTriesAgain) {
  // A full backlog answers nothing: this machine's own black hole.
  const Descriptor listener{::socket(AF_INET, SOCK_STREAM, 0)};
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const plain = reinterpret_cast<sockaddr*>(&address);
  ASSERT_EQ(::bind(listener.get(), plain, size), 0);
  ASSERT_EQ(::listen(listener.get(), 0), 0);
  ASSERT_EQ(::getsockname(listener.get(), plain, &size), 0);
  std::vector<Descriptor> crowd;
  for (int i = 0; i < 8; ++i) {
    crowd.emplace_back(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0));
    (void)::connect(crowd.back().get(), plain, size);
  }
  TcpPort port{{.address = {"127.0.0.1", ntohs(address.sin_port)}}};
  EXPECT_FALSE(comes_up(port, 0, 3200));
  EXPECT_THAT(port.trouble(), HasSubstr("no answer"));
}

TEST(TcpPort, BoundsWhatAPeerThatNeverReadsLeavesBehind) {
  const Peer peer;
  TcpPort port{{.address = {"127.0.0.1", peer.port()}}};
  ASSERT_TRUE(comes_up(port, 0, 1000));
  const Descriptor deaf = peer.accept();
  const Bytes chunk(1024, 0x55);
  int taken = 0;
  while (taken < 100000 && port.write(chunk)) {
    ++taken;
  }
  EXPECT_LT(taken, 100000) << "the queue took 100 MB";
  EXPECT_TRUE(port.is_up());
}

TEST(TcpPort, SaysThatAHostCannotBeFound) {
  TcpPort port{{.address = {"no.such.host.invalid", 5084}}};
  port.keep(at(0));
  EXPECT_FALSE(port.is_up());
  EXPECT_THAT(port.trouble(), HasSubstr("cannot find 'no.such.host.invalid'"));
}

TEST(TcpAddress, IsHostAndPortOrHostAlone) {
  const auto read = [](const char* text) {
    const auto address = tcp_address(text);
    return address ? address->host + " " + std::to_string(address->port) : "none";
  };
  EXPECT_EQ(read("192.168.1.20:5085"), "192.168.1.20 5085");
  EXPECT_EQ(read("speedway-11-22-33"), "speedway-11-22-33 5084");
  EXPECT_EQ(read("[::1]:6000"), "::1 6000");
  EXPECT_EQ(read("[::1]"), "::1 5084");
  EXPECT_EQ(read("fe80::1"), "fe80::1 5084");
  for (const char* wrong : {"", ":5084", "host:", "host:0", "host:70000", "host:50a", "[::1", "[::1]5084"}) {
    EXPECT_EQ(read(wrong), "none") << wrong;
  }
}

}  // namespace
}  // namespace sensotwin::robot
