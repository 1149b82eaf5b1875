// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

/// The built program as a process.
namespace sensotwin::twin {

struct Outcome {
  int code{-1};
  std::string out{};
  std::string err{};
};

/// The content of a file, which is removed.
inline std::string take(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  std::filesystem::remove(file);
  return text.str();
}

/// Runs `twin <arguments>` in a shell. \param before  environment and such, for instance "NO_COLOR=1"
inline Outcome twin(const std::string& arguments, const std::string& before = "") {
  const std::string base = ::testing::TempDir() + "twin-program-" + std::to_string(getpid());
  const std::string line = before + " '" + TWIN_PROGRAM + "' " + arguments + " >'" + base + ".out' 2>'" +
                           base + ".err' </dev/null";
  const int status = std::system(line.c_str());  // NOLINT(cert-env33-c): a shell is what users have
  return {WEXITSTATUS(status), take(base + ".out"), take(base + ".err")};
}

/// `twin` running beside the test, silent, without a shell in between: signals reach it and nobody else.
class BackgroundTwin {
 public:
  explicit BackgroundTwin(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), TWIN_PROGRAM);
    std::vector<char*> argv;
    for (std::string& argument : arguments) {
      argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    process_ = ::fork();
    if (process_ < 0) {
      throw std::runtime_error("cannot fork");
    }
    if (process_ == 0) {
      if (std::freopen("/dev/null", "w", stdout) != nullptr &&
          std::freopen("/dev/null", "w", stderr) != nullptr) {
        ::execv(argv[0], argv.data());
      }
      ::_exit(127);
    }
  }
  ~BackgroundTwin() {
    if (process_ > 0) {
      ::kill(process_, SIGKILL);
      ::waitpid(process_, nullptr, 0);
    }
  }
  BackgroundTwin(const BackgroundTwin&) = delete;
  BackgroundTwin& operator=(const BackgroundTwin&) = delete;

  /// Waits until `file` is there or the program has ended. \returns whether it is there
  [[nodiscard]] bool wait_for(const std::filesystem::path& file) const {
    for (int i = 0; i < 3000 &&
                    ::waitid(P_PID, static_cast<id_t>(process_), &ended_, WEXITED | WNOHANG | WNOWAIT) == 0 &&
                    ended_.si_pid == 0;
         ++i) {
      if (std::filesystem::exists(file)) {
        return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return std::filesystem::exists(file);
  }

  [[nodiscard]] pid_t process() const { return process_; }

  struct End {
    int code{-1};  ///< -1: by a signal that it did not handle
    double after_s{0.0};
  };
  /// Sends a signal and waits for the end.
  [[nodiscard]] End stop(int signal) {
    const auto begun = std::chrono::steady_clock::now();
    ::kill(process_, signal);
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = -1;
    const std::chrono::duration<double> after = std::chrono::steady_clock::now() - begun;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, after.count()};
  }

 private:
  pid_t process_{-1};
  mutable siginfo_t ended_{};
};

}  // namespace sensotwin::twin
