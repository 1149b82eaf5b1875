// SPDX-License-Identifier: MIT
#include "twin/serve/status_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "twin/output/progress.hpp"

namespace sensotwin::twin {

std::string status_line(const ServeStatus& status, int columns) {
  std::string line = fmt::format("{}  {:.3g} x real time", duration_text(status.sim_s), status.factor);
  std::uint64_t dropped = 0;
  for (const ServeStatus::OfWire& wire : status.wires) {
    const bool is_base = wire.name == "base";
    line += fmt::format("  {}: {}", wire.name, wire.has_client ? "client" : "-");
    if (is_base) {
      line += fmt::format(" ({})", status.base_mode);
    }
    dropped += wire.tally.bytes_dropped;
  }
  if (dropped > 0) {
    line += fmt::format("  {} bytes not taken", dropped);
  }
  line.resize(std::min(line.size(), static_cast<std::size_t>(std::max(columns, 0))));
  return line;
}

std::string table_of(const ServeStatus& status) {
  const double factor = status.wall_s > 0.0 ? status.sim_s / status.wall_s : 0.0;
  std::string table =
      fmt::format("served {} in {}: {:.3g} x real time, {:.3f} s given up\n", duration_text(status.sim_s),
                  duration_text(status.wall_s), factor, status.given_up_s);
  table += fmt::format("{:<10} {:>8} {:>8} {:>12} {:>12} {:>12}\n", "wire", "clients", "refused", "bytes in",
                       "bytes out", "not taken");
  for (const ServeStatus::OfWire& wire : status.wires) {
    table +=
        fmt::format("{:<10} {:>8} {:>8} {:>12} {:>12} {:>12}\n", wire.name, wire.tally.clients,
                    wire.tally.refused, wire.tally.bytes_in, wire.tally.bytes_out, wire.tally.bytes_dropped);
  }
  return table;
}

}  // namespace sensotwin::twin
