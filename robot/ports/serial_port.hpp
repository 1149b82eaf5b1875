// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "robot/ports/back_off.hpp"
#include "robot/ports/descriptor.hpp"
#include "robot/ports/port.hpp"
#include "robot/ports/send_queue.hpp"

namespace sensotwin::robot {

struct SerialPortConfig {
  std::string path;  ///< better a link that udev makes than /dev/ttyUSB0, which another device may become
  int baud{115200};
  /// Told of each descriptor as soon as it is open: for the guardian.
  std::function<void(int)> on_open{};
  /// A port that went away is tried again after this, then after twice as long ... Chosen: a USB adapter is
  /// back a second after it was plugged in.
  Duration first_retry{std::chrono::milliseconds{100}};
  Duration last_retry{std::chrono::seconds{2}};
};

/// A serial port: 8 data bits, no parity, 1 stop bit, no flow control, raw; nobody else may open it
/// (TIOCEXCL). DTR and RTS are set where the port has them (a pseudo-terminal has not). Bytes from before the
/// opening are thrown away.
class SerialPort : public Port {
 public:
  explicit SerialPort(SerialPortConfig config);

 private:
  bool do_write(ByteView bytes) override;
  std::size_t do_read(std::span<std::uint8_t> into) override;
  [[nodiscard]] bool do_is_up() const override { return static_cast<bool>(descriptor_); }
  void do_keep(Instant now) override;
  void open();
  void lose(const std::string& why);

  SerialPortConfig config_;
  BackOff back_off_;
  Descriptor descriptor_;
  SendQueue queue_;
};

}  // namespace sensotwin::robot
