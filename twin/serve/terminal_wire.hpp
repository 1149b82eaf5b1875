// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/hal/byte_link.hpp"
#include "twin/serve/pseudo_terminal.hpp"
#include "twin/serve/wire.hpp"

namespace sensotwin::twin {

struct TerminalWireOptions {
  int baud{115200};  ///< that clients find set
  /// The speed the device speaks now; none: any is understood.
  std::function<int()> device_baud{};
  /// Bytes at another speed are lost, both ways, as on a cable; else they pass, and only a status tells.
  bool strict_baud{false};
  /// Somebody has opened the port.
  std::function<void()> on_client{};
};

/// A device that speaks bytes, at a pseudo-terminal.
class TerminalWire final : public Wire {
 public:
  /// \param device  the client's end of the emulated device; must outlive the wire  \throws ServeError
  TerminalWire(std::string name, const std::filesystem::path& link, robot::ByteLink& device,
               TerminalWireOptions options);

  [[nodiscard]] const PseudoTerminal& terminal() const { return terminal_; }
  /// The client has set another speed than the device speaks.
  [[nodiscard]] bool wrong_baud() const { return wrong_baud_; }
  /// A client is there and has read all it was sent.
  [[nodiscard]] bool client_is_up_to_date() const;

 private:
  void do_watch(std::vector<pollfd>& handles) const override;
  void do_pump(double wall_s) override;
  [[nodiscard]] bool do_has_client() const override { return client_; }

  void take_from_client();
  void give_to_client();
  void see_who_is_there();

  robot::ByteLink& device_;
  TerminalWireOptions options_;
  PseudoTerminal terminal_;
  bool client_{false};
  bool wrong_baud_{false};
};

}  // namespace sensotwin::twin
