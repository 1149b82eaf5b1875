// SPDX-License-Identifier: MIT
#include "robot/output/signals.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace sensotwin::robot {
namespace {

// Signals are the process's, so each case runs in one of its own.
[[noreturn]] void raise_and_exit_orderly(int signal) {
  install_signal_handlers();
  if (pending_interruption()) {
    std::_Exit(1);
  }
  std::raise(signal);
  const auto code = pending_interruption();
  std::_Exit(code ? as_int(*code) : 2);
}

TEST(SignalsDeathTest, AnInterruptIsPendingAfterSigint) {
  EXPECT_EXIT(raise_and_exit_orderly(SIGINT), ::testing::ExitedWithCode(130), "");
}

TEST(SignalsDeathTest, ATerminationIsPendingAfterSigterm) {
  EXPECT_EXIT(raise_and_exit_orderly(SIGTERM), ::testing::ExitedWithCode(143), "");
}

TEST(SignalsDeathTest, TheSecondSigintEndsAtOnce) {
  EXPECT_EXIT(
      {
        install_signal_handlers();
        std::raise(SIGINT);
        std::raise(SIGINT);
        std::_Exit(3);
      },
      ::testing::ExitedWithCode(130), "");
}

TEST(SignalsDeathTest, ABrokenPipeEndsTheProcessWithoutAWord) {
  EXPECT_EXIT(
      {
        install_signal_handlers();
        std::raise(SIGPIPE);
        std::_Exit(3);
      },
      ::testing::KilledBySignal(SIGPIPE), "^$");
}

}  // namespace
}  // namespace sensotwin::robot
