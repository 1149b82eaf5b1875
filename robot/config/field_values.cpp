// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>
#include <vector>

#include "robot/config/field_reader.hpp"
#include "robot/config/nearest_name.hpp"

/// The half of the reader that turns written values into numbers, points and words.
namespace sensotwin::robot {
namespace {

std::string in_words(const Range& range) {
  const bool low = range.min > std::numeric_limits<double>::lowest();
  const bool high = range.max < std::numeric_limits<double>::max();
  if (low && high) {
    return range.above_min ? fmt::format("a number above {} and at most {}", range.min, range.max)
                           : fmt::format("a number from {} to {}", range.min, range.max);
  }
  return "a number";
}

std::string in_words(Count count, const std::string& of_what) {
  if (count.min == 0) {
    return "a list of " + of_what;
  }
  return count.min == count.max ? fmt::format("a list of {} {}", count.min, of_what)
                                : fmt::format("a list of {} to {} {}", count.min, count.max, of_what);
}

/// Why a text that looks like a number is none; empty when it does not look like one.
std::string number_trap(const std::string& text) {
  static const std::vector<std::string> not_finite{".nan", ".NaN",  ".NAN",     "nan",      "NaN",
                                                   ".inf", "-.inf", "+.inf",    ".Inf",     "-.Inf",
                                                   "inf",  "-inf",  "Infinity", "-Infinity"};
  if (std::find(not_finite.begin(), not_finite.end(), text) != not_finite.end()) {
    return " (it must be finite)";
  }
  if (text.size() > 1 && text.find_first_not_of("0123456789") == std::string::npos) {
    return " (a leading zero means octal to some readers: leave it out)";
  }
  if (text.find(',') != std::string::npos && text.find_first_not_of("-+0123456789,") == std::string::npos) {
    return " (the decimal mark is a point)";
  }
  std::size_t letters = text.find_first_not_of("-+.0123456789");
  if (letters != std::string::npos && letters > 0 && is_json_number(text.substr(0, letters))) {
    return " (the unit is in the key: write the number alone)";
  }
  return "";
}

std::string quoted_list(std::span<const std::string_view> words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::optional<double> FieldReader::number_in(const YamlNode& node, const std::string& path,
                                             const Range& range) {
  if (node.kind != YamlKind::kNumber) {
    const std::string trap = node.kind == YamlKind::kText && !node.quoted ? number_trap(node.text) : "";
    wrong(node, path, in_words(range) + (node.quoted ? ", without quotes" : trap));
    return std::nullopt;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(node.text.data(), node.text.data() + node.text.size(), value);
  if (error != std::errc{} || end != node.text.data() + node.text.size() || value < range.min ||
      value > range.max || (range.above_min && value == range.min)) {
    wrong(node, path, in_words(range));
    return std::nullopt;
  }
  return value;
}

std::optional<std::int64_t> FieldReader::integer_in(const YamlNode& node, const std::string& path,
                                                    std::int64_t min, std::int64_t max) {
  const std::string expected =
      min == max ? fmt::format("{}", min) : fmt::format("a whole number from {} to {}", min, max);
  std::int64_t value = 0;
  const char* last = node.text.data() + node.text.size();
  const auto [end, error] = std::from_chars(node.text.data(), last, value);
  if (node.kind != YamlKind::kNumber || error != std::errc{} || end != last || value < min || value > max) {
    const std::string trap = node.kind == YamlKind::kText && !node.quoted ? number_trap(node.text) : "";
    wrong(node, path, expected + (node.quoted ? ", without quotes" : trap));
    return std::nullopt;
  }
  return value;
}

bool FieldReader::list_in(const YamlNode& node, const std::string& path, Count count,
                          const std::string& of_what) {
  if (node.kind != YamlKind::kList) {
    wrong(node, path, in_words(count, of_what));
    return false;
  }
  if (node.items.size() < count.min || node.items.size() > count.max) {
    add(node.place, path, fmt::format("has {} of them", node.items.size()),
        "expected " + in_words(count, of_what));
    return false;
  }
  return true;
}

std::optional<Vec2> FieldReader::point_in(const YamlNode& node, const std::string& path, const Range& range) {
  if (!list_in(node, path, {2, 2}, "numbers [x, y]")) {
    return std::nullopt;
  }
  const std::optional<double> x = number_in(node.items[0], path + "[0]", range);
  const std::optional<double> y = number_in(node.items[1], path + "[1]", range);
  if (!x || !y) {
    return std::nullopt;
  }
  return Vec2{*x, *y};
}

void FieldReader::number(const Field& field, double& value, const Range& range) {
  if (const YamlNode* node = take(field)) {
    value = number_in(*node, path_of(field.key), range).value_or(value);
  }
}

void FieldReader::angle(const Field& field, double& rad, const Range& range_deg) {
  if (const YamlNode* node = take(field)) {
    if (const std::optional<double> deg = number_in(*node, path_of(field.key), range_deg)) {
      rad = robot::rad_from_deg(*deg);
    }
  }
}

void FieldReader::integer(const Field& field, std::int64_t& value, std::int64_t min, std::int64_t max) {
  if (const YamlNode* node = take(field)) {
    value = integer_in(*node, path_of(field.key), min, max).value_or(value);
  }
}

void FieldReader::seed(const Field& field, std::uint64_t& value) {
  const YamlNode* node = take(field);
  if (node == nullptr) {
    return;
  }
  std::uint64_t read = 0;
  const char* last = node->text.data() + node->text.size();
  const auto [end, error] = std::from_chars(node->text.data(), last, read);
  if (node->kind != YamlKind::kNumber || error != std::errc{} || end != last) {
    wrong(*node, path_of(field.key),
          "a whole number from 0 to 18446744073709551615" + number_trap(node->text));
    return;
  }
  value = read;
}

void FieldReader::flag(const Field& field, bool& value) {
  if (const YamlNode* node = take(field)) {
    if (node->kind != YamlKind::kFlag) {
      wrong(*node, path_of(field.key), "true or false");
      return;
    }
    value = node->text == "true";
  }
}

void FieldReader::text(const Field& field, std::string& value) {
  if (const YamlNode* node = take(field)) {
    if (node->kind != YamlKind::kText || node->text.empty()) {
      const bool scalar = node->kind == YamlKind::kNumber || node->kind == YamlKind::kFlag;
      wrong(*node, path_of(field.key), scalar ? "a text: put it in quotes" : "a text");
      return;
    }
    value = node->text;
  }
}

void FieldReader::choice(const Field& field, std::size_t& index, std::span<const std::string_view> words) {
  const YamlNode* node = take(field);
  if (node == nullptr) {
    return;
  }
  const auto found = std::find(words.begin(), words.end(), node->text);
  if (node->kind != YamlKind::kText || found == words.end()) {
    wrong(*node, path_of(field.key),
          "one of: " + quoted_list(words) + did_you_mean(node->text, {words.begin(), words.end()}));
    return;
  }
  index = static_cast<std::size_t>(found - words.begin());
}

void FieldReader::point(const Field& field, Vec2& value, const Range& range) {
  if (const YamlNode* node = take(field)) {
    value = point_in(*node, path_of(field.key), range).value_or(value);
  }
}

bool FieldReader::each_item(const Field& field, Count count, const std::string& of_what,
                            const std::function<void(const YamlNode&, const std::string&)>& take_in) {
  const YamlNode* node = take(field);
  const std::string path = path_of(field.key);
  if (node == nullptr || !list_in(*node, path, count, of_what)) {
    return false;
  }
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const std::string item_path = fmt::format("{}[{}]", path, i);
    places_[item_path] = node->items[i].place;
    take_in(node->items[i], item_path);
  }
  return true;
}

void FieldReader::points(const Field& field, std::vector<Vec2>& value, const Range& range, Count count) {
  std::vector<Vec2> read;
  if (each_item(field, count, "points [x, y]", [&](const YamlNode& item, const std::string& path) {
        read.push_back(point_in(item, path, range).value_or(Vec2{0.0, 0.0}));
      })) {
    value = std::move(read);
  }
}

void FieldReader::numbers(const Field& field, std::vector<double>& value, const Range& range, Count count) {
  std::vector<double> read;
  if (each_item(field, count, "numbers", [&](const YamlNode& item, const std::string& path) {
        read.push_back(number_in(item, path, range).value_or(0.0));
      })) {
    value = std::move(read);
  }
}

void FieldReader::texts(const Field& field, std::vector<std::string>& value, Count count) {
  std::vector<std::string> read;
  if (each_item(field, count, "texts", [&](const YamlNode& item, const std::string& path) {
        if (item.kind != YamlKind::kText || item.text.empty()) {
          const bool scalar = item.kind == YamlKind::kNumber || item.kind == YamlKind::kFlag;
          wrong(item, path, scalar ? "a text: put it in quotes" : "a text");
        }
        read.push_back(item.text);
      })) {
    value = std::move(read);
  }
}

void FieldReader::hex(const Field& field, std::span<std::uint8_t> value) {
  const YamlNode* node = take(field);
  if (node == nullptr) {
    return;
  }
  // Digits alone look like a number to YAML; as written they are what is meant.
  const bool scalar = node->kind == YamlKind::kText || node->kind == YamlKind::kNumber;
  if (!scalar || node->text.size() != 2 * value.size() ||
      node->text.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
    wrong(*node, path_of(field.key), fmt::format("{} hexadecimal digits", 2 * value.size()));
    return;
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    const char* digits = node->text.data() + 2 * i;
    std::from_chars(digits, digits + 2, value[i], 16);
  }
}

void FieldReader::cells(const Field& field, Cells& value) {
  const YamlNode* node = take(field);
  const std::string path = path_of(field.key);
  if (node == nullptr || !list_in(*node, path, {}, "tiles [column, row]")) {
    return;
  }
  value.clear();
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const YamlNode& item = node->items[i];
    const std::string item_path = fmt::format("{}[{}]", path, i);
    places_[item_path] = item.place;
    if (!list_in(item, item_path, {2, 2}, "numbers [column, row]")) {
      continue;
    }
    const auto column = integer_in(item.items[0], item_path + "[0]", -kFarthestTile, kFarthestTile);
    const auto row = integer_in(item.items[1], item_path + "[1]", -kFarthestTile, kFarthestTile);
    if (column && row) {
      value.emplace_back(static_cast<int>(*column), static_cast<int>(*row));
    }
  }
}

}  // namespace sensotwin::robot
