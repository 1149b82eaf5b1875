// SPDX-License-Identifier: MIT
#include "robot/ports/guardian.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "robot/ports/serial_port.hpp"
#include "tests/robot/ports/pseudo_terminal.hpp"

namespace sensotwin::robot {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::PseudoTerminal;
using testing::ScratchFolder;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kSilentAfter{60};
const GuardianConfig kConfig{.silent_after = kSilentAfter, .stop = {145, 0, 0, 0, 0}, .farewell = {173}};

/// A program in a process of its own: it has the guardian, opens the port, says "drive", and then does
/// `behave` until it is ended.
class Program {
 public:
  Program(const std::string& path, void (*behave)(Guardian&)) : pid_(::fork()) {
    if (pid_ == 0) {
      auto guardian = Guardian::begin(kConfig);
      SerialPort port{{.path = path, .on_open = [&](int fd) { guardian->watch(fd); }}};
      port.keep(Instant{});
      (void)port.write(Bytes{145, 0, 200, 0, 200});
      behave(*guardian);
      ::_exit(0);
    }
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    end(SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  void end(int signal) const { ::kill(pid_, signal); }

 private:
  pid_t pid_;
};

void beat_for_ever(Guardian& guardian) {
  for (;;) {
    guardian.beat();
    ::poll(nullptr, 0, 15);
  }
}

class GuardianAtATerminal : public ::testing::Test {
 protected:
  /// Milliseconds until `wanted` has been heard, up to a second.
  long ms_until(const Bytes& wanted) {
    const auto begun = Clock::now();
    Bytes heard;
    while (Clock::now() - begun < std::chrono::seconds{1} && heard.size() < wanted.size()) {
      const Bytes more = device.heard(5);
      heard.insert(heard.end(), more.begin(), more.end());
    }
    EXPECT_EQ(heard, wanted);
    return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begun).count();
  }

  ScratchFolder folder;
  PseudoTerminal device{folder.path() / "roomba"};
};

TEST_F(GuardianAtATerminal, StopsTheRobotWhenTheProgramIsKilled) {
  const Program program(device.path(), beat_for_ever);
  ASSERT_THAT(device.heard(1000), ElementsAre(145, 0, 200, 0, 200));
  program.end(SIGKILL);
  EXPECT_LT(ms_until({145, 0, 0, 0, 0, 173}), 100);
}

TEST_F(GuardianAtATerminal, StopsTheRobotWhenTheProgramCrashes) {
  const Program program(device.path(), [](Guardian& guardian) {
    guardian.beat();
    (void)std::signal(SIGABRT, SIG_DFL);
    std::abort();
  });
  ASSERT_THAT(device.heard(1000).size(), ::testing::Ge(5u));
  const Bytes rest = device.heard(500);
  EXPECT_TRUE(rest.empty() || rest == Bytes({145, 0, 0, 0, 0, 173}));
}

TEST_F(GuardianAtATerminal, StopsTheRobotWithoutEndingTheTalkWhenTheProgramHangs) {
  const Program program(device.path(), beat_for_ever);
  ASSERT_THAT(device.heard(1000), ElementsAre(145, 0, 200, 0, 200));
  ::poll(nullptr, 0, 50);
  program.end(SIGSTOP);
  EXPECT_LT(ms_until({145, 0, 0, 0, 0}), 100);
  EXPECT_THAT(device.heard(150), IsEmpty()) << "once is enough";
  program.end(SIGCONT);
  ::poll(nullptr, 0, 50);
  program.end(SIGSTOP);
  EXPECT_LT(ms_until({145, 0, 0, 0, 0}), 100) << "beats arm it again";
}

TEST_F(GuardianAtATerminal, OutlivesTheSignalsOfATerminal) {
  const Program program(device.path(), [](Guardian& guardian) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
      ::kill(guardian.pid(), signal);
    }
    beat_for_ever(guardian);
  });
  ASSERT_THAT(device.heard(1000), ElementsAre(145, 0, 200, 0, 200));
  ::poll(nullptr, 0, 50);
  program.end(SIGKILL);
  EXPECT_LT(ms_until({145, 0, 0, 0, 0, 173}), 100);
}

TEST_F(GuardianAtATerminal, SaysNothingWhenItIsReleased) {
  const Program program(device.path(), [](Guardian& guardian) {
    guardian.beat();
    guardian.release();
  });
  ASSERT_THAT(device.heard(1000), ElementsAre(145, 0, 200, 0, 200));
  EXPECT_THAT(device.heard(200), IsEmpty());
}

TEST_F(GuardianAtATerminal, IsMissedByItsProgramWhenItIsKilled) {
  auto guardian = Guardian::begin(kConfig);
  ASSERT_TRUE(guardian);
  EXPECT_TRUE(guardian->beat());
  ::kill(guardian->pid(), SIGKILL);
  ::waitpid(guardian->pid(), nullptr, 0);
  EXPECT_FALSE(guardian->beat());
}

}  // namespace
}  // namespace sensotwin::robot
