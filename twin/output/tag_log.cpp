// SPDX-License-Identifier: MIT
#include "twin/output/tag_log.hpp"

#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "robot/output/text_format.hpp"

namespace sensotwin::twin {
namespace {

char* put_text(char* to, std::string_view text) {
  return to + text.copy(to, text.size());
}

char* put_whole(char* to, double value) {
  return std::to_chars(to, to + 12, std::lround(value)).ptr;
}

}  // namespace

TagLogWriter::TagLogWriter(robot::OutputFile file) : file_(std::move(file)) {
  file_.append("timestamp,reader,antenna,rssi,epc,phase_angle,channel_index,doppler_frequency\n");
}

void TagLogWriter::add(const TagLogRow& row) {
  constexpr double kUnits = 4096.0;
  constexpr std::string_view kDigits = "0123456789abcdef";
  char* const begin = file_.room(192);
  char* to = robot::put_fixed<6>(begin, row.time_s);
  to = put_text(to, ",twin,");
  to = std::to_chars(to, to + 6, row.antenna).ptr;
  *to++ = ',';
  to = put_whole(to, std::trunc(row.rssi_dbm));
  to = put_text(to, ",b'");
  for (const std::uint8_t byte : row.epc.bytes) {
    *to++ = kDigits[byte >> 4];
    *to++ = kDigits[byte & 0xF];
  }
  to = put_text(to, "',");
  to = put_whole(to, std::fmod(std::round(row.phase_rad / (2.0 * std::numbers::pi) * kUnits), kUnits));
  *to++ = ',';
  to = std::to_chars(to, to + 6, row.channel).ptr;
  *to++ = ',';
  to = put_whole(to, 16.0 * row.doppler_hz);
  *to++ = '\n';
  file_.commit(static_cast<std::size_t>(to - begin));
}

}  // namespace sensotwin::twin
