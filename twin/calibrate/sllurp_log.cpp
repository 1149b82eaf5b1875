// SPDX-License-Identifier: MIT
#include "twin/calibrate/sllurp_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>

#include "robot/config/problem.hpp"
#include "robot/config/text_file.hpp"

namespace sensotwin::twin {
namespace {

struct Cell {
  std::string_view text;
  int column{1};
};

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back({line.substr(begin, end - begin), static_cast<int>(begin) + 1});
    if (end == line.size()) {
      return cells;
    }
    begin = end + 1;
  }
}

/// Walks through the lines of a CSV and keeps the mistakes.
class CsvReader {
 public:
  CsvReader(std::string_view text, std::string source) : text_(text), source_(std::move(source)) {}

  /// The next line that is not empty; nothing at the end, or when nobody would read further mistakes.
  std::optional<std::vector<Cell>> next() {
    while (begin_ < text_.size() && problems_.size() < robot::LoadError::kProblemsMax) {
      const std::size_t end = std::min(text_.find('\n', begin_), text_.size());
      std::string_view line = text_.substr(begin_, end - begin_);
      begin_ = end + 1;
      ++line_;
      if (line.ends_with('\r')) {
        line.remove_suffix(1);
      }
      if (!line.empty()) {
        return cells_of(line);
      }
    }
    return std::nullopt;
  }

  void fault(int column, std::string path, std::string what, std::string hint) {
    problems_.push_back(
        {{source_, std::max(line_, 1), column}, std::move(path), std::move(what), std::move(hint)});
  }
  [[nodiscard]] bool faulty() const { return !problems_.empty(); }
  [[noreturn]] void throw_faults() { throw robot::LoadError(std::move(problems_), robot::kExitInvalid); }

  /// A number of the cell, from `low` to `high`.
  std::optional<double> number(const Cell& cell, std::string_view name, double low, double high) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.text.data(), cell.text.data() + cell.text.size(), value);
    if (error != std::errc{} || end != cell.text.data() + cell.text.size() ||
        !(value >= low && value <= high)) {
      fault(cell.column, std::string{name}, fmt::format("'{}'", cell.text.substr(0, 40)),
            fmt::format("a number from {:g} to {:g} was expected", low, high));
      return std::nullopt;
    }
    return value;
  }

 private:
  std::string_view text_;
  std::string source_;
  std::size_t begin_{0};
  int line_{0};
  std::vector<robot::Problem> problems_;
};

/// 2025-04-28T17:50:55.460336 as seconds; nothing for other text.
std::optional<double> iso_seconds(std::string_view text) {
  if (text.size() < 19 || text[4] != '-' || text[7] != '-' || text[10] != 'T' || text[13] != ':' ||
      text[16] != ':') {
    return std::nullopt;
  }
  const auto part = [&](std::size_t begin, std::size_t size) {
    int value = -1;
    const char* const end = text.data() + begin + size;
    return std::from_chars(text.data() + begin, end, value).ptr == end ? value : -1;
  };
  double seconds = 0.0;
  const char* const end = text.data() + text.size();
  if (std::from_chars(text.data() + 17, end, seconds).ptr != end || !(seconds >= 0.0 && seconds < 61.0)) {
    return std::nullopt;
  }
  const int hour = part(11, 2);
  const int minute = part(14, 2);
  const std::chrono::year_month_day day{std::chrono::year{part(0, 4)},
                                        std::chrono::month{static_cast<unsigned>(part(5, 2))},
                                        std::chrono::day{static_cast<unsigned>(part(8, 2))}};
  if (!day.ok() || hour < 0 || hour > 23 || minute < 0 || minute > 59) {
    return std::nullopt;
  }
  const auto days = std::chrono::sys_days{day}.time_since_epoch().count();
  return 86400.0 * static_cast<double>(days) + 3600.0 * hour + 60.0 * minute + seconds;
}

constexpr std::array<std::string_view, 7> kColumns = {
    "timestamp", "antenna", "rssi", "epc", "phase_angle", "channel_index", "doppler_frequency"};
enum Column : std::size_t { kTime, kAntenna, kRssi, kEpc, kPhase, kChannel, kDoppler };

/// Where each of kColumns stands; nothing when the header is not one of sllurp.
std::optional<std::array<std::size_t, kColumns.size()>> order_of(const std::vector<Cell>& header,
                                                                 CsvReader& csv) {
  std::array<std::size_t, kColumns.size()> order{};
  for (std::size_t c = 0; c < kColumns.size(); ++c) {
    const auto at = std::find_if(header.begin(), header.end(),
                                 [&](const Cell& cell) { return cell.text == kColumns[c]; });
    if (at == header.end()) {
      csv.fault(1, "", fmt::format("no column '{}'", kColumns[c]),
                "a log of sllurp was expected: timestamp,reader,antenna,rssi,epc,phase_angle,channel_index,"
                "doppler_frequency");
      return std::nullopt;
    }
    order[c] = static_cast<std::size_t>(at - header.begin());
  }
  for (const Cell& cell : header) {
    if (cell.text != "reader" && std::find(kColumns.begin(), kColumns.end(), cell.text) == kColumns.end()) {
      csv.fault(cell.column, "", fmt::format("unknown column '{}'", cell.text.substr(0, 40)),
                "the columns of sllurp were expected");
      return std::nullopt;
    }
  }
  return order;
}

/// Hexadecimal digits of b'3034...' or 3034...; empty when it is neither.
std::string_view epc_digits(std::string_view text) {
  if (text.size() > 3 && text.starts_with("b'") && text.ends_with('\'')) {
    text = text.substr(2, text.size() - 3);
  }
  const bool hexadecimal =
      text.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos && text.size() % 2 == 0;
  return hexadecimal ? text : std::string_view{};
}

int index_of_epc(TagLog& log, std::string_view digits) {
  // Neighbouring rows mostly name the same tag, and a room holds some dozens.
  const auto known = std::find(log.epcs.begin(), log.epcs.end(), digits);
  if (known == log.epcs.end()) {
    log.epcs.emplace_back(digits);
    return static_cast<int>(log.epcs.size()) - 1;
  }
  return static_cast<int>(known - log.epcs.begin());
}

std::optional<LogRow> row_of(const std::vector<Cell>& cells,
                             const std::array<std::size_t, kColumns.size()>& order, CsvReader& csv,
                             TagLog& log) {
  const auto cell = [&](Column column) { return cells[order[column]]; };
  std::optional<double> time_s = iso_seconds(cell(kTime).text);
  if (!time_s) {
    time_s = csv.number(cell(kTime), "timestamp", 0.0, 1e12);
  }
  const auto antenna = csv.number(cell(kAntenna), "antenna", 1.0, 65535.0);
  const auto rssi_dbm = csv.number(cell(kRssi), "rssi", -128.0, 60.0);
  const auto phase = csv.number(cell(kPhase), "phase_angle", 0.0, 4095.0);
  const auto channel = csv.number(cell(kChannel), "channel_index", 1.0, 1000.0);
  const auto doppler = csv.number(cell(kDoppler), "doppler_frequency", -32768.0, 32767.0);
  const std::string_view digits = epc_digits(cell(kEpc).text);
  if (digits.empty()) {
    csv.fault(cell(kEpc).column, "epc", fmt::format("'{}'", cell(kEpc).text.substr(0, 60)),
              "hexadecimal digits were expected, or b'...' about them");
  }
  if (!time_s || !antenna || !rssi_dbm || !phase || !channel || !doppler || digits.empty()) {
    return std::nullopt;
  }
  return LogRow{.time_s = *time_s,
                .antenna = static_cast<int>(*antenna),
                .channel = static_cast<int>(*channel),
                .epc = index_of_epc(log, digits),
                .phase_rad = *phase / 4096.0 * 2.0 * std::numbers::pi,
                .rssi_dbm = *rssi_dbm,
                .doppler_hz = *doppler / 16.0};
}

}  // namespace

TagLog parse_sllurp_log(std::string_view text, const std::filesystem::path& file) {
  CsvReader csv(text, file.string());
  TagLog log{.name = file.filename().string(), .epcs = {}, .rows = {}};
  const auto header = csv.next();
  if (!header) {
    csv.fault(1, "", "the file is empty", "a log of sllurp was expected");
    csv.throw_faults();
  }
  const auto order = order_of(*header, csv);
  if (!order) {
    csv.throw_faults();
  }
  while (const auto cells = csv.next()) {
    if (cells->size() != header->size()) {
      csv.fault(1, "", fmt::format("{} cells", cells->size()),
                fmt::format("{} were expected, as in the header", header->size()));
    } else if (const auto row = row_of(*cells, *order, csv, log)) {
      log.rows.push_back(*row);
    }
  }
  if (log.rows.empty() && !csv.faulty()) {
    csv.fault(1, "", "no rows below the header", "a log with reads was expected");
  }
  if (csv.faulty()) {
    csv.throw_faults();
  }
  return log;
}

TagLog read_sllurp_log(const std::filesystem::path& file) {
  return parse_sllurp_log(robot::read_text_file(file, "log"), file);
}

std::vector<KeyedNumber> read_keyed_numbers(const std::filesystem::path& file, std::string_view key,
                                            std::string_view value) {
  const std::string text = robot::read_text_file(file, "table");
  CsvReader csv(text, file.string());
  const auto header = csv.next();
  std::vector<KeyedNumber> numbers;
  if (!header || header->size() != 2 || (*header)[0].text != key || (*header)[1].text != value) {
    csv.fault(1, "", "another header", fmt::format("'{},{}' was expected", key, value));
    csv.throw_faults();
  }
  while (const auto cells = csv.next()) {
    if (cells->size() != 2) {
      csv.fault(1, "", fmt::format("{} cells", cells->size()), "2 were expected");
      continue;
    }
    const Cell& name = cells->front();
    const bool twice =
        std::any_of(numbers.begin(), numbers.end(), [&](const KeyedNumber& n) { return n.key == name.text; });
    if (name.text.empty() || twice) {
      csv.fault(name.column, std::string{key}, fmt::format("'{}'", name.text),
                "a name of its own was expected");
    } else if (const auto number = csv.number(cells->back(), value, 0.0, 1e12)) {
      numbers.push_back({std::string{name.text}, *number});
    }
  }
  if (csv.faulty()) {
    csv.throw_faults();
  }
  return numbers;
}

}  // namespace sensotwin::twin
