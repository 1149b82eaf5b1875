// SPDX-License-Identifier: MIT
// The Open Interface at a pseudo-terminal, by clients that open it as other programs do.
#include "twin/serve/terminal_wire.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>

#include <fstream>
#include <optional>

#include "serve_bench.hpp"
#include "tests/robot/output/temporary_folder.hpp"
#include "tests/twin/devices/roomba_bench.hpp"
#include "twin/serve/serve_error.hpp"

namespace sensotwin::twin {
namespace {

using robot::Bytes;
using robot::oi::Mode;

/// A mainboard behind a terminal, ticked by hand.
class ServedRoomba : public ::testing::Test {
 protected:
  TerminalWire& serve(EmulatedRoombaConfig config = {}, bool strict = false) {
    roomba_.emplace(config);
    serial_.emplace(*roomba_);
    wire_.emplace("base", folder_ / "base", *serial_,
                  TerminalWireOptions{.baud = roomba_->baud(),
                                      .device_baud = [this] { return roomba_->baud(); },
                                      .strict_baud = strict,
                                      .on_client = [this] { roomba_->pulse_brc(); }});
    return *wire_;
  }
  void tick() {
    roomba_->tick(in_);
    wire_->pump(0.0);
  }
  /// Ticks until the client has heard `size` bytes or more.
  Bytes hear(const PortClient& client, std::size_t size) {
    Bytes all;
    EXPECT_TRUE(eventually([&] { return all.size() >= size; },
                           [&] {
                             tick();
                             const Bytes more = client.hear(1);
                             all.insert(all.end(), more.begin(), more.end());
                           }))
        << all.size() << " of " << size << " bytes";
    return all;
  }
  bool reaches(Mode mode) {
    return eventually([&] { return roomba_->mode() == mode; }, [&] { tick(); });
  }

  TemporaryFolder folder_;
  world::RoombaInputs in_ = at_rest();
  std::optional<EmulatedRoomba> roomba_;
  std::optional<EmulatedSerial> serial_;
  std::optional<TerminalWire> wire_;
};

TEST_F(ServedRoomba, AnswersAClientThatSetsNothingWithoutAnEcho) {
  serve();
  const PortClient client(folder_ / "base");
  client.say({128, 131, 142, 35});
  EXPECT_EQ(hear(client, 1), Bytes{2});
  EXPECT_EQ(wire_->tally().bytes_in, 4u);
}

TEST_F(ServedRoomba, IgnoresWhatComesBeforeStart) {
  serve();
  const PortClient client(folder_ / "base");
  client.say({142, 35, 145, 0, 100, 0, 100, 131, 142, 35, 128, 142, 35});
  EXPECT_EQ(hear(client, 1), Bytes{1});
}

TEST_F(ServedRoomba, WaitsForTheRestOfACommandHoweverLongItTakes) {
  serve({.speed_step_mps = 0.0});
  const PortClient client(folder_ / "base");
  client.say({128, 131, 145, 0, 100});
  ASSERT_TRUE(reaches(Mode::kSafe));
  for (int i = 0; i < 1000; ++i) {
    tick();
  }
  EXPECT_EQ(roomba_->tick(in_).wheel_left_mps, 0.0);
  client.say({0, 100});
  EXPECT_TRUE(eventually([&] { return roomba_->tick(in_).wheel_left_mps == 0.1; }, [&] { tick(); }));
}

TEST_F(ServedRoomba, StreamsAFrameEachTick) {
  serve();
  const PortClient client(folder_ / "base", B115200);
  client.say({128, 148, 1, 35});
  ASSERT_EQ(hear(client, 5).size() % 5, 0u);
  for (int i = 0; i < 10; ++i) {
    tick();
  }
  EXPECT_EQ(hear(client, 50).size() % 5, 0u);
}

TEST_F(ServedRoomba, SpeaksSciAt57600AsA400) {
  EmulatedRoombaConfig config;
  config.body.kind = world::RoombaKind::kRoomba400;
  serve(config);
  const PortClient client(folder_ / "base");
  termios found{};
  ::tcgetattr(client.descriptor(), &found);
  EXPECT_EQ(::cfgetospeed(&found), static_cast<speed_t>(B57600));
  client.say({128, 130, 142, 0});
  EXPECT_EQ(hear(client, 26).size(), 26u);
}

TEST_F(ServedRoomba, KeepsModeAndStreamWhenItsClientGoesAndTheNextFindsNoStaleBytes) {
  serve();
  {
    const PortClient first(folder_ / "base");
    first.say({128, 131, 148, 1, 35});
    hear(first, 5);
    tick();  // frames that the first never reads
    tick();
  }
  ASSERT_TRUE(eventually([&] { return !wire_->has_client(); }, [&] { tick(); }));
  for (int i = 0; i < 1000; ++i) {
    tick();
  }
  const std::uint64_t said = wire_->tally().bytes_out;
  const PortClient second(folder_ / "base");
  EXPECT_TRUE(second.hear().empty());
  EXPECT_EQ(hear(second, 5), (Bytes{19, 2, 35, 2, 198}));
  EXPECT_EQ(roomba_->mode(), Mode::kSafe);
  EXPECT_EQ(wire_->tally().clients, 2u);
  EXPECT_EQ(wire_->tally().bytes_out, said + 5) << "said to nobody is not sent";
  EXPECT_EQ(wire_->tally().bytes_dropped, 0u) << "nor dropped";
}

TEST_F(ServedRoomba, HearsAClientThatOpensWritesAndLeavesAtOnce) {
  serve();
  PortClient{folder_ / "base"}.say({128, 131});
  EXPECT_TRUE(reaches(Mode::kSafe));
}

TEST_F(ServedRoomba, IsWokenByWhoeverOpensThePort) {
  serve();
  {
    const PortClient client(folder_ / "base");
    client.say({128, 133});
    ASSERT_TRUE(eventually([&] { return roomba_->asleep(); }, [&] { tick(); }));
  }
  ASSERT_TRUE(eventually([&] { return !wire_->has_client(); }, [&] { tick(); }));
  const PortClient client(folder_ / "base");
  EXPECT_TRUE(eventually([&] { return !roomba_->asleep(); }, [&] { tick(); }));
}

TEST_F(ServedRoomba, NeitherStallsNorGrowsForAClientThatNeverReads) {
  serve();
  const PortClient client(folder_ / "base");
  client.say({128, 148, 1, 100});
  ASSERT_TRUE(eventually([&] { return wire_->tally().bytes_out > 0; }, [&] { tick(); }));
  for (int i = 0; i < 10000; ++i) {
    tick();
  }
  EXPECT_GT(wire_->tally().bytes_dropped, 100'000u);
  // A terminal holds some kilobytes; the rest is lost, and a late reader finds whole frames again.
  EXPECT_LT(client.hear().size(), 200'000u);
  EXPECT_GE(hear(client, 84).size(), 84u);
}

TEST_F(ServedRoomba, Survives10MegabytesOfRandomBytes) {
  serve();
  const Bytes bytes = noise(10'000'000);
  const PortClient client(folder_ / "base");
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const std::size_t chunk = std::min<std::size_t>(bytes.size() - sent, 4096);
    sent += client.say({bytes.begin() + static_cast<std::ptrdiff_t>(sent),
                        bytes.begin() + static_cast<std::ptrdiff_t>(sent + chunk)});
    tick();
  }
  // Whatever it was told, it can be told to begin anew; a long command may have eaten the first words.
  roomba_->pulse_brc();
  for (int i = 0; i < 600; ++i) {
    client.say({7});
    tick();
  }
  static_cast<void>(client.hear());
  EXPECT_TRUE(eventually([&] { return roomba_->mode() == Mode::kPassive; },
                         [&] {
                           client.say({128});
                           tick();
                         }));
}

TEST_F(ServedRoomba, SaysWhenItsClientSetsAnotherSpeedThanItsOwn) {
  serve();
  const PortClient client(folder_ / "base", B9600);
  tick();
  EXPECT_TRUE(wire_->wrong_baud());
  client.say({128, 142, 35});
  EXPECT_EQ(hear(client, 1), Bytes{1}) << "told, and understood all the same";
}

TEST_F(ServedRoomba, UnderstandsNothingAtAWrongSpeedWhenAskedToBeStrict) {
  serve({}, true);
  const PortClient client(folder_ / "base", B9600);
  client.say({128, 142, 35});
  EXPECT_TRUE(eventually([&] { return wire_->tally().bytes_dropped == 3; }, [&] { tick(); }));
  EXPECT_EQ(roomba_->mode(), Mode::kOff);
}

TEST_F(ServedRoomba, SpeaksTheSpeedItIsTold) {
  serve({}, true);
  const PortClient client(folder_ / "base", B115200);
  client.say({128, 129, 7});
  ASSERT_TRUE(eventually([&] { return roomba_->baud() == 19200; }, [&] { tick(); }));
  tick();
  EXPECT_TRUE(wire_->wrong_baud());
  const PortClient slower(folder_ / "base", B19200);
  tick();
  EXPECT_FALSE(wire_->wrong_baud());
}

TEST_F(ServedRoomba, KnowsWhetherItsClientHasReadAll) {
  serve();
  EXPECT_FALSE(wire_->client_is_up_to_date()) << "nobody there";
  const PortClient client(folder_ / "base");
  client.say({128, 142, 100});
  const auto unread = [&] {
    int bytes = 0;
    ::ioctl(client.descriptor(), FIONREAD, &bytes);
    return bytes;
  };
  ASSERT_TRUE(eventually([&] { return unread() == 80; }, [&] { tick(); }));
  EXPECT_FALSE(wire_->client_is_up_to_date());
  EXPECT_EQ(client.hear().size(), 80u);
  EXPECT_TRUE(wire_->client_is_up_to_date());
}

TEST(PseudoTerminalTest, ReplacesALinkButNothingElse) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/nowhere", folder / "base");
  {
    const PseudoTerminal terminal(folder / "base", 115200);
    EXPECT_EQ(std::filesystem::read_symlink(folder / "base"), terminal.device());
  }
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(folder / "base")))
      << "removed at the end";
  std::ofstream{folder / "base"} << "precious\n";
  EXPECT_THROW(PseudoTerminal(folder / "base", 115200), ServeError);
  EXPECT_EQ(content_of(folder / "base"), "precious\n");
}

}  // namespace
}  // namespace sensotwin::twin
