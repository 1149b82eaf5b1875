// SPDX-License-Identifier: MIT
#include "robot/journal/journal_format.hpp"

namespace sensotwin::robot {

std::string_view name_of(Wire wire) {
  static constexpr std::array<std::string_view, kWires> kNames{"base", "sensors", "UHF reader",
                                                               "floor reader", "forward reader"};
  return kNames[static_cast<std::size_t>(wire)];
}

bool has_bytes(WireWord word) {
  switch (word) {
    case WireWord::kRead:
    case WireWord::kWritten:
    case WireWord::kWriteRefused:
    case WireWord::kBegun:
    case WireWord::kBeginRefused:
    case WireWord::kAnswer:
      return true;
    default:
      return false;
  }
}

std::string text_of(const WireRecord& record) {
  static constexpr std::array<std::string_view, kWireWords> kWords{
      "is up",     "is down",     "read",        "written",          "write refused",
      "no reader", "field empty", "tag there",   "command",          "command refused",
      "answer",    "tag removed", "reader gone", "no answer in time"};
  std::string text{name_of(record.wire)};
  text.append(": ").append(kWords[static_cast<std::size_t>(record.word)]);
  for (const std::uint8_t byte : record.bytes) {
    text.append(" ").append(std::to_string(byte));
  }
  return text;
}

}  // namespace sensotwin::robot
