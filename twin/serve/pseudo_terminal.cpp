// SPDX-License-Identifier: MIT
#include "twin/serve/pseudo_terminal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "twin/serve/serve_error.hpp"

namespace sensotwin::twin {
namespace {

namespace fs = std::filesystem;

/// Speeds that termios has names for.
constexpr std::array<std::pair<speed_t, int>, 14> kSpeeds{{{B300, 300},
                                                           {B600, 600},
                                                           {B1200, 1200},
                                                           {B2400, 2400},
                                                           {B4800, 4800},
                                                           {B9600, 9600},
                                                           {B19200, 19200},
                                                           {B38400, 38400},
                                                           {B57600, 57600},
                                                           {B115200, 115200},
                                                           {B230400, 230400},
                                                           {B460800, 460800},
                                                           {B500000, 500000},
                                                           {B921600, 921600}}};

[[noreturn]] void fail(const char* what) {
  throw ServeError(fmt::format("no pseudo-terminal: {}: {}; is /dev/pts mounted?", what,
                               std::system_category().message(errno)));
}

Handle open_end(const std::string& device) {
  return Handle{::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
}

/// Under its final name at once, also where an older one stands.
void link_to(const std::string& device, const fs::path& link) {
  const fs::path part = link.parent_path() / ("." + link.filename().string() + ".part");
  std::error_code error;
  if (fs::exists(fs::symlink_status(link)) && !fs::is_symlink(link)) {
    throw ServeError(fmt::format("cannot link {}: something else is there", link.string()));
  }
  fs::remove(part, error);
  fs::create_symlink(device, part, error);
  if (!error) {
    fs::rename(part, link, error);
  }
  if (error) {
    throw ServeError(fmt::format("cannot link {}: {}", link.string(), error.message()));
  }
}

}  // namespace

PseudoTerminal::PseudoTerminal(const fs::path& link, int baud)
    : link_(fs::absolute(link).lexically_normal()),
      baud_(baud),
      master_(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
  if (!master_) {
    fail("posix_openpt");
  }
  if (::grantpt(master_.get()) != 0 || ::unlockpt(master_.get()) != 0) {
    fail("unlockpt");
  }
  std::array<char, 64> name{};
  if (::ptsname_r(master_.get(), name.data(), name.size()) != 0) {
    fail("ptsname_r");
  }
  device_ = name.data();
  renew();
  link_to(device_, link_);
}

PseudoTerminal::~PseudoTerminal() {
  std::error_code error;
  // Another twin may have taken the name over.
  if (fs::read_symlink(link_, error) == device_) {
    fs::remove(link_, error);
  }
}

bool PseudoTerminal::has_client() const {
  pollfd end{.fd = master_.get(), .events = POLLOUT, .revents = 0};
  return ::poll(&end, 1, 0) >= 0 && (end.revents & POLLHUP) == 0;
}

std::size_t PseudoTerminal::read(std::span<std::uint8_t> into) {
  const ssize_t moved = ::read(master_.get(), into.data(), into.size());
  return moved > 0 ? static_cast<std::size_t>(moved) : 0;
}

std::size_t PseudoTerminal::write(robot::ByteView bytes) {
  const ssize_t moved = ::write(master_.get(), bytes.data(), bytes.size());
  return moved > 0 ? static_cast<std::size_t>(moved) : 0;
}

void PseudoTerminal::renew() {
  const Handle end = open_end(device_);
  if (!end) {
    return;  // a client has it for itself (TIOCEXCL)
  }
  ::tcflush(end.get(), TCIFLUSH);
  termios settings{};
  if (::tcgetattr(end.get(), &settings) != 0) {
    return;
  }
  ::cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  for (const auto& [speed, baud] : kSpeeds) {
    if (baud == baud_) {
      ::cfsetispeed(&settings, speed);
      ::cfsetospeed(&settings, speed);
    }
  }
  ::tcsetattr(end.get(), TCSANOW, &settings);
}

std::optional<int> PseudoTerminal::client_baud() const {
  termios settings{};
  if (::tcgetattr(master_.get(), &settings) != 0) {
    return std::nullopt;
  }
  for (const auto& [speed, baud] : kSpeeds) {
    if (speed == ::cfgetospeed(&settings)) {
      return baud;
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> PseudoTerminal::unread() const {
  // Only the client's side knows; a look through a second opening of it leaves no trace.
  const Handle end = open_end(device_);
  int bytes = 0;
  if (!end || ::ioctl(end.get(), FIONREAD, &bytes) != 0) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(bytes);
}

}  // namespace sensotwin::twin
