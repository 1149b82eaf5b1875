// SPDX-License-Identifier: MIT
#include "twin/serve/tcp.hpp"

#include <gtest/gtest.h>

#include "twin/serve/serve_error.hpp"

namespace sensotwin::twin {
namespace {

TEST(EndpointText, IsHostAndPort) {
  EXPECT_EQ(endpoint_from("127.0.0.1:5084"), (Endpoint{"127.0.0.1", 5084}));
  EXPECT_EQ(endpoint_from("5084"), (Endpoint{"127.0.0.1", 5084}));
  EXPECT_EQ(endpoint_from("[::1]:0"), (Endpoint{"::1", 0}));
  EXPECT_EQ(to_text({"::1", 5084}), "[::1]:5084");
  EXPECT_EQ(to_text({"0.0.0.0", 1}), "0.0.0.0:1");
}

TEST(EndpointText, OfAnotherFormIsRefused) {
  for (const char* text : {"", ":", "host:", ":5084", "host:70000", "host:-1", "::1:5084", "host:12x"}) {
    EXPECT_EQ(endpoint_from(text), std::nullopt) << text;
  }
}

TEST(TcpListener, FindsAFreePortAndSaysWhich) {
  Endpoint at;
  const Handle first = listen_at(at);
  EXPECT_TRUE(first);
  EXPECT_GT(at.port, 0);
}

TEST(TcpListener, RefusesAPortThatIsTakenAndNamesIt) {
  Endpoint at;
  const Handle first = listen_at(at);
  try {
    Endpoint same = at;
    static_cast<void>(listen_at(same));
    FAIL() << "listens twice";
  } catch (const ServeError& error) {
    EXPECT_NE(std::string(error.what()).find(to_text(at)), std::string::npos) << error.what();
  }
}

TEST(TcpListener, AsksNoNameServer) {
  Endpoint at{"reader.example", 5084};
  EXPECT_THROW(static_cast<void>(listen_at(at)), ServeError);
}

}  // namespace
}  // namespace sensotwin::twin
