// SPDX-License-Identifier: MIT
#include "robot/output/signals.hpp"

#include <unistd.h>

#include <csignal>

namespace sensotwin::robot {
namespace {

// Signals are the process's, so this is the one variable that cannot belong to an object.
volatile std::sig_atomic_t g_signal = 0;

void on_signal(int signal) {
  if (signal == SIGINT && g_signal != 0) {
    ::_exit(as_int(ExitCode::kInterrupted));
  }
  g_signal = signal;
}

void set_handler(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  // Without SA_RESTART a blocking call returns, so that the loop sees the flag at once.
  sigaction(signal, &action, nullptr);
}

}  // namespace

void install_signal_handlers() {
  set_handler(SIGINT, on_signal);
  set_handler(SIGTERM, on_signal);
  set_handler(SIGPIPE, SIG_DFL);
  set_handler(SIGXFSZ, SIG_IGN);
}

void install_machine_signal_handlers() {
  install_signal_handlers();
  set_handler(SIGHUP, on_signal);
  set_handler(SIGPIPE, SIG_IGN);
}

std::optional<ExitCode> pending_interruption() {
  switch (g_signal) {
    case 0:
      return std::nullopt;
    case SIGTERM:
    case SIGHUP:
      return ExitCode::kTerminated;
    default:
      return ExitCode::kInterrupted;
  }
}

}  // namespace sensotwin::robot
