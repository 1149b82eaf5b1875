// SPDX-License-Identifier: MIT
#include "robot/telemetry/web/web_address.hpp"

#include <gtest/gtest.h>

namespace sensotwin::robot {
namespace {

TEST(WebAddress, IsHostAndPortOrEitherOfThem) {
  EXPECT_EQ(web_address("8080"), (WebAddress{"127.0.0.1", 8080}));
  EXPECT_EQ(web_address(":8080"), (WebAddress{"127.0.0.1", 8080}));
  EXPECT_EQ(web_address("localhost:81"), (WebAddress{"127.0.0.1", 81}));
  EXPECT_EQ(web_address("0.0.0.0:0"), (WebAddress{"0.0.0.0", 0}));
  EXPECT_EQ(web_address("192.168.1.7"), (WebAddress{"192.168.1.7", 0}));
  EXPECT_EQ(web_address("[::1]:8080"), (WebAddress{"::1", 8080}));
  EXPECT_EQ(web_address("[::1]"), (WebAddress{"::1", 0}));
}

TEST(WebAddress, IsNothingElse) {
  for (const char* text :
       {"", ":", "host:80", "127.0.0.1:", "127.0.0.1:x", "127.0.0.1:65536", "::1:80", "[::1", "[::1]80",
        "[127.0.0.1]:80", "1.2.3.4.5:80", "127.0.0.1:-1", "127.0.0.1:80 "}) {
    EXPECT_FALSE(web_address(text)) << text;
  }
}

TEST(WebAddress, IsWrittenAsItIsRead) {
  for (const char* text : {"127.0.0.1:8080", "[::1]:9", "0.0.0.0:0"}) {
    EXPECT_EQ(to_text(web_address(text).value()), text);
  }
}

}  // namespace
}  // namespace sensotwin::robot
