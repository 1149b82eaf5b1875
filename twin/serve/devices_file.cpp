// SPDX-License-Identifier: MIT
#include "twin/serve/devices_file.hpp"

#include <fmt/format.h>

#include <string_view>

namespace sensotwin::twin {
namespace {

/// Double-quoted YAML: any path and any reader's name.
std::string in_quotes(std::string_view text) {
  std::string out{'"'};
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
    }
    out += c;
  }
  return out + '"';
}

}  // namespace

std::string to_yaml(const Devices& devices, const std::string& scene) {
  std::string yaml = fmt::format("# The wires of twin serve {}\n", scene);
  yaml += fmt::format("base: {}\n", in_quotes(devices.base.string()));
  yaml += fmt::format("sensors: {}\n", in_quotes(devices.sensors.string()));
  if (devices.llrp) {
    yaml += fmt::format("llrp: {}\n", in_quotes(*devices.llrp));
  }
  if (!devices.card_readers.empty()) {
    yaml += "card_readers:   # floor, forward\n";
    for (const std::string& name : devices.card_readers) {
      yaml += fmt::format("  - {}\n", in_quotes(name));
    }
  }
  return yaml;
}

}  // namespace sensotwin::twin
