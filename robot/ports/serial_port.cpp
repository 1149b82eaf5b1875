// SPDX-License-Identifier: MIT
#include "robot/ports/serial_port.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

namespace sensotwin::robot {
namespace {

/// The system's word for a speed. Those of Open Interface, SCI and NMEA boards.
std::optional<speed_t> speed_of(int baud) {
  static constexpr std::array<std::pair<int, speed_t>, 11> kSpeeds{{{300, B300},
                                                                    {600, B600},
                                                                    {1200, B1200},
                                                                    {2400, B2400},
                                                                    {4800, B4800},
                                                                    {9600, B9600},
                                                                    {19200, B19200},
                                                                    {38400, B38400},
                                                                    {57600, B57600},
                                                                    {115200, B115200},
                                                                    {230400, B230400}}};
  for (const auto& [known, speed] : kSpeeds) {
    if (known == baud) {
      return speed;
    }
  }
  return std::nullopt;
}

bool configure(int fd, int baud) {
  termios settings{};
  const auto speed = speed_of(baud);
  if (!speed) {
    errno = EINVAL;
    return false;
  }
  if (tcgetattr(fd, &settings) != 0) {
    return false;
  }
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS | HUPCL);
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
  cfsetispeed(&settings, *speed);
  cfsetospeed(&settings, *speed);
  if (tcsetattr(fd, TCSANOW, &settings) != 0) {
    return false;
  }
  int lines = TIOCM_DTR | TIOCM_RTS;
  (void)ioctl(fd, TIOCMBIS, &lines);  // a pseudo-terminal has no such lines
  return tcflush(fd, TCIOFLUSH) == 0;
}

}  // namespace

SerialPort::SerialPort(SerialPortConfig config)
    : config_(std::move(config)), back_off_(config_.first_retry, config_.last_retry) {}

void SerialPort::do_keep(Instant now) {
  if (descriptor_) {
    pollfd state{descriptor_.get(), 0, 0};
    if (::poll(&state, 1, 0) == 1 && (state.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) {
      lose("the device is gone");
    } else if (!queue_.flush(descriptor_.get())) {
      lose(std::strerror(errno));  // NOLINT(concurrency-mt-unsafe): read at once
    }
  }
  if (!descriptor_ && back_off_.is_due(now)) {
    open();
    if (descriptor_) {
      back_off_.succeeded();
    } else {
      back_off_.failed(now);
    }
  }
}

void SerialPort::open() {
  Descriptor fresh{::open(config_.path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
  // Asked for before anything is changed: whoever has the port already is not disturbed.
  if (!fresh || ioctl(fresh.get(), TIOCEXCL) != 0 || !configure(fresh.get(), config_.baud)) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): read at once
    trouble_ = "cannot open '" + config_.path + "': " + std::strerror(errno);
    return;
  }
  descriptor_ = std::move(fresh);
  queue_.clear();
  trouble_.clear();
  ++health_.opened;
  if (config_.on_open) {
    config_.on_open(descriptor_.get());
  }
}

void SerialPort::lose(const std::string& why) {
  trouble_ = "lost '" + config_.path + "': " + why;
  descriptor_.close();
  queue_.clear();
  ++health_.lost;
}

bool SerialPort::do_write(ByteView bytes) {
  if (!descriptor_ || !queue_.send(descriptor_.get(), bytes)) {
    ++health_.writes_refused;
    return false;
  }
  health_.bytes_written += bytes.size();
  return true;
}

std::size_t SerialPort::do_read(std::span<std::uint8_t> into) {
  if (!descriptor_ || into.empty()) {
    return 0;
  }
  const ssize_t got = ::read(descriptor_.get(), into.data(), into.size());
  if (got > 0) {
    health_.bytes_read += static_cast<std::uint64_t>(got);
    return static_cast<std::size_t>(got);
  }
  // With VMIN 0 a terminal without bytes answers 0; one that hung up too, which keep() tells apart.
  if (got < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) {
    lose(std::strerror(errno));  // NOLINT(concurrency-mt-unsafe): read at once
  }
  return 0;
}

}  // namespace sensotwin::robot
