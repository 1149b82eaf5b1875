// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "twin/serve/card_service.hpp"
#include "twin/serve/card_wire.hpp"
#include "twin/serve/devices_file.hpp"
#include "twin/serve/llrp_wire.hpp"
#include "twin/serve/served_twin.hpp"
#include "twin/serve/terminal_wire.hpp"

namespace sensotwin::twin {

struct WireSettings {
  bool strict_baud{false};  ///< see TerminalWireOptions
  /// Where the UHF reader listens. None: 5084, LLRP's own port, of loopback, or any other one when it is
  /// taken.
  std::optional<Endpoint> llrp{};
  /// Where vpcd's first slot listens; the second one is a port higher. None: no card slots.
  std::optional<Endpoint> vpcd{Endpoint{.port = 35963}};
};

/// All wires of a served scene.
class ServedWires {
 public:
  using Say = std::function<void(std::string_view)>;

  /// Opens them. \param twin  must outlive the wires  \param folder  for the terminals' links
  /// \throws ServeError
  ServedWires(ServedTwin& twin, const WireSettings& settings, const std::filesystem::path& folder,
              const Say& warn);

  void pump(double wall_s);
  void watch(std::vector<pollfd>& handles) const;

  /// Whether pcscd knows of the tags what there is to know: see CardWire::is_settled().
  [[nodiscard]] bool cards_are_settled(double wall_s) const;

  [[nodiscard]] const TerminalWire& base() const { return *base_; }
  [[nodiscard]] const std::vector<std::unique_ptr<Wire>>& all() const { return wires_; }
  /// What there is now; nothing while it is not known yet whether there are card slots.
  [[nodiscard]] std::optional<Devices> devices();
  /// Says who has come and gone since the last call, and what is amiss.
  void tell(const Say& say, const Say& warn);

 private:
  void open_terminals(const WireSettings& settings, const std::filesystem::path& folder);
  void open_llrp(const WireSettings& settings, const Say& warn);
  void open_cards(const Endpoint& vpcd);
  void tell_of_baud(const Say& warn);
  void tell_of_cards(const Say& warn);

  ServedTwin& twin_;
  std::vector<std::unique_ptr<Wire>> wires_;
  TerminalWire* base_{nullptr};
  std::vector<CardWire*> cards_;
  std::optional<CardService> card_service_;
  Devices devices_;
  std::vector<bool> had_client_;
  bool driven_{false};  ///< the base has a client
  bool told_of_baud_{false};
  CardWire::Peer told_of_cards_{CardWire::Peer::kUnknown};
};

}  // namespace sensotwin::twin
