// SPDX-License-Identifier: MIT
#include "robot/ports/serial_port.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <termios.h>

#include "tests/robot/ports/pseudo_terminal.hpp"

namespace sensotwin::robot {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::PseudoTerminal;
using testing::ScratchFolder;
using ::testing::SizeIs;

Instant at(int ms) {
  return Instant{milliseconds{ms}};
}

Bytes read_all(ByteLink& port) {
  Bytes bytes(4096);
  bytes.resize(port.read(bytes));
  return bytes;
}

class SerialPortOnATerminal : public ::testing::Test {
 protected:
  ScratchFolder folder;
  PseudoTerminal device{folder.path() / "roomba"};
  SerialPort port{{.path = device.path()}};
};

TEST_F(SerialPortOnATerminal, CarriesEveryByteBothWaysUnchanged) {
  port.keep(at(0));
  ASSERT_TRUE(port.is_up());
  Bytes all(256);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = static_cast<std::uint8_t>(i);
  }
  EXPECT_TRUE(port.write(all));
  EXPECT_EQ(device.heard(100), all);
  device.say(all);
  EXPECT_EQ(read_all(port), all);
}

TEST_F(SerialPortOnATerminal, IsSetTo115200Baud8N1WithoutFlowControl) {
  port.keep(at(0));
  termios settings{};
  ASSERT_EQ(tcgetattr(device.port(), &settings), 0);
  EXPECT_EQ(cfgetospeed(&settings), static_cast<speed_t>(B115200));
  EXPECT_EQ(settings.c_cflag & CSIZE, static_cast<tcflag_t>(CS8));
  EXPECT_EQ(settings.c_cflag & (PARENB | CSTOPB | CRTSCTS), 0u);
  EXPECT_EQ(settings.c_iflag & (IXON | IXOFF | ICRNL), 0u);
  EXPECT_EQ(settings.c_lflag & (ICANON | ECHO | ISIG), 0u);
}

TEST_F(SerialPortOnATerminal, ThrowsAwayWhatWasSaidBeforeItWasOpen) {
  device.say(Bytes{1, 2, 3});
  port.keep(at(0));
  EXPECT_THAT(read_all(port), SizeIs(0));
}

TEST_F(SerialPortOnATerminal, ReadsNothingWithoutWaitingWhenNothingWasSaid) {
  port.keep(at(0));
  EXPECT_THAT(read_all(port), SizeIs(0));
  EXPECT_TRUE(port.is_up());
}

TEST_F(SerialPortOnATerminal, IsOpenToNobodyElse) {
  if (::geteuid() == 0) {
    GTEST_SKIP() << "the system lets root open a port that is taken";
  }
  port.keep(at(0));
  SerialPort second{{.path = device.path()}};
  second.keep(at(0));
  EXPECT_FALSE(second.is_up());
  EXPECT_THAT(second.trouble(), HasSubstr("busy"));
}

TEST_F(SerialPortOnATerminal, SaysThatItWasPulledOutAndComesBackWithThePort) {
  port.keep(at(0));
  device.pull_out();
  port.keep(at(15));
  EXPECT_FALSE(port.is_up());
  EXPECT_FALSE(port.write(Bytes{1}));
  EXPECT_THAT(read_all(port), SizeIs(0));
  port.keep(at(500));
  EXPECT_THAT(port.trouble(), HasSubstr("cannot open"));
  device.plug_in();
  for (int ms = 515; ms < 3000 && !port.is_up(); ms += 15) {
    port.keep(at(ms));
  }
  ASSERT_TRUE(port.is_up());
  EXPECT_TRUE(port.trouble().empty());
  EXPECT_TRUE(port.write(Bytes{7}));
  EXPECT_THAT(device.heard(100), ElementsAre(7));
  EXPECT_EQ(port.health().opened, 2u);
  EXPECT_EQ(port.health().lost, 1u);
}

TEST_F(SerialPortOnATerminal, TellsOfEachDescriptorThatItOpens) {
  std::vector<int> told;
  SerialPort watched{{.path = device.path(), .on_open = [&](int fd) { told.push_back(fd); }}};
  watched.keep(at(0));
  device.pull_out();
  watched.keep(at(15));
  device.plug_in();
  watched.keep(at(5000));
  watched.keep(at(10000));
  EXPECT_THAT(told, SizeIs(2));
}

TEST_F(SerialPortOnATerminal, RefusesWhatADeafPeerLeavesNoRoomFor) {
  port.keep(at(0));
  const Bytes chunk(512, 0xAA);
  int taken = 0;
  while (taken < 1000 && port.write(chunk)) {
    ++taken;
  }
  // A pseudo-terminal holds some kilobytes, the queue two chunks; far from the 512 kB of a thousand.
  EXPECT_LT(taken, 200);
  EXPECT_TRUE(port.is_up());
  EXPECT_GT(port.health().writes_refused, 0u);
  Bytes heard;
  for (int i = 0; i < 2000 && heard.size() < static_cast<std::size_t>(taken) * chunk.size(); ++i) {
    const Bytes more = device.heard(10);
    heard.insert(heard.end(), more.begin(), more.end());
    port.keep(at(15 * (i + 1)));
  }
  EXPECT_EQ(heard, Bytes(static_cast<std::size_t>(taken) * chunk.size(), 0xAA));
}

TEST(SerialPort, SaysWhyItCannotOpenAndTriesEverMoreSeldom) {
  SerialPort port{{.path = "/nowhere/ttyUSB9"}};
  port.keep(at(0));
  EXPECT_FALSE(port.is_up());
  EXPECT_EQ(port.trouble(), "cannot open '/nowhere/ttyUSB9': No such file or directory");
}

TEST(SerialPort, RefusesABaudRateThatNoPortHas) {
  const ScratchFolder folder;
  const PseudoTerminal device{folder.path() / "port"};
  SerialPort port{{.path = device.path(), .baud = 12345}};
  port.keep(at(0));
  EXPECT_FALSE(port.is_up());
  EXPECT_THAT(port.trouble(), HasSubstr("Invalid argument"));
}

}  // namespace
}  // namespace sensotwin::robot
