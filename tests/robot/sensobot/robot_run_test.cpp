// SPDX-License-Identifier: MIT
// `sensobot run` in a process of its own, behind a pseudo-terminal with a robot at its other end: what
// happens to the wheels when something goes wrong.
#include "robot/sensobot/robot_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>

#include "robot/output/signals.hpp"
#include "robot/replay/journal_file.hpp"
#include "robot/replay/journal_replay.hpp"
#include "tests/robot/sensobot/terminal_roomba.hpp"

namespace sensotwin::robot {
namespace {

using ::testing::HasSubstr;
using testing::ScratchFolder;
using testing::TerminalRoomba;
using Clock = std::chrono::steady_clock;

/// A reader with a tag that always lies there, ICODE SLI of 28 blocks.
class OneTag : public CardSession {
 public:
  Result<std::vector<std::string>, CardFault> readers() override { return std::vector<std::string>{"tag"}; }
  Result<CardField, CardFault> look(const std::string&) override { return CardField{true, 1}; }
  Result<bool, CardFault> connect(const std::string&) override { return true; }
  Result<Bytes, CardFault> transmit(ByteView command) override {
    Bytes answer;
    const std::size_t address = command[3] * 4u;
    if (command[1] == 0xCA) {
      answer = {0xE0, 0x04, 1, 2, 3, 4, 5, 6};
    } else if (command[1] == 0xB0) {
      const auto from = memory_.begin() + static_cast<std::ptrdiff_t>(address);
      answer.assign(from, from + command[4]);
    } else if (command[1] == 0xD6) {
      std::copy(command.begin() + 5, command.end(), memory_.begin() + static_cast<std::ptrdiff_t>(address));
    }
    answer.insert(answer.end(), {0x90, 0x00});
    return answer;
  }
  void disconnect() override {}

 private:
  Bytes memory_ = Bytes(28 * 4);
};

class RunOnATerminal : public ::testing::Test {
 protected:
  /// Where it runs: as a daemon, or in a window of its own, whose other end is ours.
  enum class Console { kNone, kOwn };
  /// Starts the program; its output goes to a file.
  void start(double patience_s = 5.0, double rate = 1.0, Console console = Console::kNone) {
    pid_ = console == Console::kOwn ? ::forkpty(&console_, nullptr, nullptr, nullptr) : ::fork();
    if (pid_ != 0) {
      return;
    }
    roomba.terminal.disown();
    install_machine_signal_handlers();
    int code = 70;
    {
      std::ofstream said(folder_.path() / "said");
      const RobotFile robot = read_robot_text(
          "version: 1\ndevices: { base: " + roomba.terminal.path() + ", card_readers: [tag] }\nmap_id: 5\n",
          "robot.yaml");
      RunFolder results(folder_.path() / "run", Existing::kRefuse);
      RobotRunOptions options{.rate = rate, .wait_s = 2.0, .patience_s = patience_s};
      options.journal = folder_.path() / "run/journal";
      options.card_service = []() -> Result<std::unique_ptr<CardSession>, CardFault> {
        return std::unique_ptr<CardSession>{std::make_unique<OneTag>()};
      };
      options.interruption = pending_interruption;
      options.say = [&](std::string_view line) { said << line << '\n' << std::flush; };
      code = as_int(run_robot(robot, results, options).exit_code);
    }
    ::_exit(code);
  }
  void TearDown() override {
    if (pid_ > 0 && !code_) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
  }
  /// The robot lives, 15 ms a tick, until `done`. \returns whether that was within so many seconds
  template <class Condition>
  bool live_until(const Condition& done, double limit_s = 5.0) {
    auto next = Clock::now();
    const auto limit = next + std::chrono::duration<double>(limit_s);
    while (!done()) {
      if (Clock::now() > limit) {
        return false;
      }
      roomba.tick();
      next += std::chrono::milliseconds{15};
      while (Clock::now() < next) {
        ::poll(nullptr, 0, 1);
        roomba.listen();
      }
    }
    return true;
  }
  bool live_until_it_moves() {
    return live_until([&] { return roomba.moves(); });
  }
  void live_for(double seconds) {
    (void)live_until([] { return false; }, seconds);
  }
  /// Milliseconds until the wheels stand, whether or not the robot goes on saying frames.
  double ms_until_it_stands(bool frames) {
    const auto begun = Clock::now();
    const auto since_ms = [&] {
      return std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
    };
    while (roomba.moves() && since_ms() < 2000.0) {
      frames ? roomba.tick() : roomba.listen();
      ::poll(nullptr, 0, frames ? 15 : 1);
    }
    RecordProperty("ms_until_it_stands", std::to_string(since_ms()));
    return since_ms();
  }
  [[nodiscard]] bool has_ended() {
    int status = 0;
    if (!code_ && ::waitpid(pid_, &status, WNOHANG) == pid_) {
      code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    return code_.has_value();
  }
  [[nodiscard]] std::string text_in(const std::string& name) const {
    std::ifstream in(folder_.path() / name);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  void tell(int signal) const { ::kill(pid_, signal); }

  ScratchFolder folder_;
  TerminalRoomba roomba{folder_.path() / "roomba"};
  pid_t pid_{-1};
  int console_{-1};
  std::optional<int> code_;
};

TEST_F(RunOnATerminal, StopsTheWheelsWithin100MillisecondsOfSigkill) {
  start();
  ASSERT_TRUE(live_until_it_moves());
  tell(SIGKILL);
  EXPECT_LT(ms_until_it_stands(false), 100.0);
  EXPECT_TRUE(live_until([&] { return !roomba.streams(); })) << "the guardian ends the talk too";
  // What was written before it died is a journal.
  const Journal journal = journal_in(folder_.path() / "run/journal");
  EXPECT_GT(journal.blocks.size(), 10u);
  EXPECT_FALSE(replay(journal, "journal").difference);
}

TEST_F(RunOnATerminal, StopsTheWheelsWithin100MillisecondsOfHangingAndGoesOnAfterwards) {
  start();
  ASSERT_TRUE(live_until_it_moves());
  tell(SIGSTOP);
  EXPECT_LT(ms_until_it_stands(false), 100.0);
  tell(SIGCONT);
  EXPECT_TRUE(live_until_it_moves());
}

TEST_F(RunOnATerminal, StopsTheWheelsWithin100MillisecondsOfTheLastFrame) {
  start();
  ASSERT_TRUE(live_until_it_moves());
  roomba.mute = true;
  EXPECT_LT(ms_until_it_stands(false), 100.0);
  roomba.mute = false;
  EXPECT_TRUE(live_until_it_moves());
}

TEST_F(RunOnATerminal, DrivesInSlowMotionWithoutAStopBetweenTwoSteps) {
  start(5.0, 0.2);
  ASSERT_TRUE(live_until_it_moves());
  // Steps are 75 ms apart now: more than the guardian waits for a sign of life.
  EXPECT_FALSE(live_until([&] { return !roomba.moves(); }, 0.8));
  tell(SIGSTOP);
  EXPECT_LT(ms_until_it_stands(true), 100.0);
  tell(SIGCONT);
}

TEST_F(RunOnATerminal, EndsInOrderOnSigtermWithAWholeFolder) {
  start();
  ASSERT_TRUE(live_until_it_moves());
  tell(SIGTERM);
  EXPECT_LT(ms_until_it_stands(true), 100.0);
  ASSERT_TRUE(live_until([&] { return has_ended(); }));
  EXPECT_EQ(*code_, 143);
  EXPECT_FALSE(roomba.streams());
  EXPECT_THAT(text_in("run/summary.json"), HasSubstr("\"outcome\": \"interrupted\""));
  EXPECT_THAT(text_in("run/map.yaml"), HasSubstr("image: map.pgm"));
  EXPECT_THAT(text_in("run/events.jsonl"), HasSubstr("tile_found"));
  const Journal journal = journal_in(folder_.path() / "run/journal");
  EXPECT_EQ(journal.bytes_torn, 0u);
  EXPECT_TRUE(journal.blocks.back().end);
  EXPECT_FALSE(replay(journal, "journal").difference);
}

TEST_F(RunOnATerminal, EndsInOrderWhenItsTerminalGoesAway) {
  start();
  ASSERT_TRUE(live_until_it_moves());
  tell(SIGHUP);
  EXPECT_LT(ms_until_it_stands(true), 100.0);
  ASSERT_TRUE(live_until([&] { return has_ended(); }));
  EXPECT_EQ(*code_, 143);
}

TEST_F(RunOnATerminal, EndsInOrderWhenTheWindowThatItRunsInIsClosed) {
  start(5.0, 1.0, Console::kOwn);
  ASSERT_TRUE(live_until_it_moves());
  ::close(console_);
  EXPECT_LT(ms_until_it_stands(true), 100.0);
  ASSERT_TRUE(live_until([&] { return has_ended(); }));
  EXPECT_EQ(*code_, 143);
  EXPECT_FALSE(roomba.streams());
}

TEST_F(RunOnATerminal, SaysPlainlyThatThePortVanishedAndDrivesOnWhenItIsBack) {
  start();
  ASSERT_TRUE(live_until_it_moves());
  roomba.terminal.pull_out();
  ::poll(nullptr, 0, 300);
  roomba.reset();
  roomba.terminal.plug_in();
  EXPECT_TRUE(live_until_it_moves()) << "a robot that lost its power is started again";
  EXPECT_THAT(text_in("said"), HasSubstr("the Roomba is gone"));
  EXPECT_THAT(text_in("said"), HasSubstr("the Roomba is back"));
}

TEST_F(RunOnATerminal, GivesUpADeviceThatDoesNotComeBack) {
  start(0.5);
  ASSERT_TRUE(live_until_it_moves());
  roomba.terminal.pull_out();
  for (int i = 0; i < 300 && !has_ended(); ++i) {
    ::poll(nullptr, 0, 10);
  }
  ASSERT_TRUE(has_ended());
  EXPECT_EQ(*code_, 69);
  EXPECT_THAT(text_in("run/summary.json"), HasSubstr("\"outcome\": \"device_lost\""));
}

TEST_F(RunOnATerminal, NamesARoombaThatDoesNotAnswer) {
  roomba.mute = true;
  start();
  ASSERT_TRUE(live_until([&] { return has_ended(); }, 8.0));
  EXPECT_EQ(*code_, 69);
  EXPECT_THAT(text_in("said"), HasSubstr("does not answer: is it switched on"));
}

TEST_F(RunOnATerminal, OutlivesLossAndCorruptionOfOneByteInAHundred) {
  roomba.faults = {.loss = 0.01, .corruption = 0.01};
  start();
  ASSERT_TRUE(live_until_it_moves());
  live_for(1.5);
  EXPECT_FALSE(has_ended());
  tell(SIGTERM);
  // A stop can be lost like any other byte; the driver says it at once and the shutdown again.
  ASSERT_TRUE(live_until([&] { return has_ended(); }));
  EXPECT_EQ(*code_, 143);
  EXPECT_FALSE(replay(journal_in(folder_.path() / "run/journal"), "journal").difference);
}

TEST_F(RunOnATerminal, OutlivesStallsOf200Milliseconds) {
  start();
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(live_until_it_moves());
    ::poll(nullptr, 0, 200);
  }
  ASSERT_TRUE(live_until_it_moves());
  EXPECT_FALSE(has_ended());
}

}  // namespace
}  // namespace sensotwin::robot
