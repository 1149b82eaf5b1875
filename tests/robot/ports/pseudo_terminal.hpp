// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "robot/base/bytes.hpp"
#include "robot/ports/descriptor.hpp"

namespace sensotwin::robot::testing {

/// A folder that vanishes with the test.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "sensotwin-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw std::runtime_error("no scratch folder");
    }
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The device's end of a serial line, as a pseudo-terminal with a link to it that stays when the device is
/// unplugged and plugged in again.
class PseudoTerminal {
 public:
  explicit PseudoTerminal(std::filesystem::path link) : link_(std::move(link)) { plug_in(); }

  void plug_in() {
    int device = -1;
    int port = -1;
    std::array<char, 64> name{};
    if (::openpty(&device, &port, name.data(), nullptr, nullptr) != 0) {
      throw std::runtime_error("no pseudo-terminal");
    }
    device_ = Descriptor{device};
    port_ = Descriptor{port};
    (void)::fcntl(device, F_SETFL, O_NONBLOCK);
    std::filesystem::remove(link_);
    std::filesystem::create_symlink(name.data(), link_);
  }
  /// Like a USB adapter that is pulled out.
  void pull_out() {
    port_.close();
    device_.close();
    std::filesystem::remove(link_);
  }
  /// In a child of the process that has it: the device is the parent's alone.
  void disown() {
    port_.close();
    device_.close();
  }
  void say(ByteView bytes) const { (void)!::write(device_.get(), bytes.data(), bytes.size()); }
  /// What came from the program, waiting at most so long for its first byte.
  [[nodiscard]] Bytes heard(int wait_ms = 0) const {
    pollfd state{device_.get(), POLLIN, 0};
    (void)::poll(&state, 1, wait_ms);
    std::array<std::uint8_t, 4096> bytes{};
    const ssize_t got = ::read(device_.get(), bytes.data(), bytes.size());
    return {bytes.begin(), bytes.begin() + (got > 0 ? got : 0)};
  }
  [[nodiscard]] std::string path() const { return link_.string(); }
  [[nodiscard]] int port() const { return port_.get(); }

 private:
  std::filesystem::path link_;
  Descriptor device_;
  Descriptor port_;
};

}  // namespace sensotwin::robot::testing
