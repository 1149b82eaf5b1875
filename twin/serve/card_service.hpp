// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace sensotwin::twin {

/// The PC/SC service of this machine. While this lives, a service that was started on demand stays up: one
/// that is left alone for a minute ends, and takes vpcd's ports with it.
class CardService {
 public:
  /// Connects, which starts a service that waits for its first client. Without one, it is empty.
  CardService();
  ~CardService();
  CardService(const CardService&) = delete;
  CardService& operator=(const CardService&) = delete;

  [[nodiscard]] bool is_there() const;
  /// Connects again when there was no service, or it has gone.
  void renew();
  /// All readers it knows.
  [[nodiscard]] std::vector<std::string> readers() const;

 private:
  struct Session;
  std::unique_ptr<Session> session_;
};

/// The names of vpcd's slots 0 and 1 among `readers`, for instance "Virtual PCD 00 00" and "Virtual PCD 00
/// 01"; those of a machine without other readers when they are not among them.
[[nodiscard]] std::vector<std::string> virtual_slots_among(const std::vector<std::string>& readers);

}  // namespace sensotwin::twin
