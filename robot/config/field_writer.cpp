// SPDX-License-Identifier: MIT
#include "robot/config/field_writer.hpp"

#include <fmt/format.h>

#include "robot/config/number_text.hpp"

namespace sensotwin::robot {
namespace {

std::string in_quotes(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      result += fmt::format("\\x{:02x}", static_cast<unsigned>(c));
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string in_brackets(const Vec2& p) {
  return fmt::format("[{}, {}]", number_text(p.x()), number_text(p.y()));
}

}  // namespace

void FieldWriter::number(const Field& field, double& value, const Range&) {
  line(field.key, number_text(value));
}

void FieldWriter::angle(const Field& field, double& rad, const Range&) {
  line(field.key, number_text(degrees_for(rad)));
}

void FieldWriter::integer(const Field& field, std::int64_t& value, std::int64_t, std::int64_t) {
  line(field.key, std::to_string(value));
}

void FieldWriter::seed(const Field& field, std::uint64_t& value) {
  line(field.key, std::to_string(value));
}

void FieldWriter::flag(const Field& field, bool& value) {
  line(field.key, value ? "true" : "false");
}

void FieldWriter::text(const Field& field, std::string& value) {
  line(field.key, in_quotes(value));
}

void FieldWriter::choice(const Field& field, std::size_t& index, std::span<const std::string_view> words) {
  line(field.key, std::string(words[index]));
}

void FieldWriter::point(const Field& field, Vec2& value, const Range&) {
  line(field.key, in_brackets(value));
}

void FieldWriter::points(const Field& field, std::vector<Vec2>& value, const Range&, Count) {
  std::string list;
  for (const Vec2& point : value) {
    list += (list.empty() ? "" : ", ") + in_brackets(point);
  }
  line(field.key, "[" + list + "]");
}

void FieldWriter::numbers(const Field& field, std::vector<double>& value, const Range&, Count) {
  std::string list;
  for (const double number : value) {
    list += (list.empty() ? "" : ", ") + number_text(number);
  }
  line(field.key, "[" + list + "]");
}

void FieldWriter::texts(const Field& field, std::vector<std::string>& value, Count) {
  std::string list;
  for (const std::string& word : value) {
    list += (list.empty() ? "" : ", ") + in_quotes(word);
  }
  line(field.key, "[" + list + "]");
}

void FieldWriter::hex(const Field& field, std::span<std::uint8_t> value) {
  std::string digits;
  for (const std::uint8_t byte : value) {
    digits += fmt::format("{:02X}", byte);
  }
  line(field.key, in_quotes(digits));
}

void FieldWriter::cells(const Field& field, Cells& value) {
  std::string list;
  for (const auto& [column, row] : value) {
    list += fmt::format("{}[{}, {}]", list.empty() ? "" : ", ", column, row);
  }
  line(field.key, "[" + list + "]");
}

void FieldWriter::section(const Field& field, const std::function<void()>& body) {
  line(field.key, "");
  indented(body);
}

void FieldWriter::section_or_word(const Field& field, std::span<const std::string_view> words,
                                  std::optional<std::size_t> shown, const std::function<void(std::size_t)>&,
                                  const std::function<void()>& body) {
  if (shown) {
    line(field.key, std::string(words[*shown]));
  } else {
    section(field, body);
  }
}

void FieldWriter::named(const Field& field, std::size_t size,
                        const std::function<std::string(std::size_t)>& name,
                        const std::function<std::size_t(const std::string&)>&,
                        const std::function<void(std::size_t)>& body) {
  if (size == 0) {
    line(field.key, "{}");
    return;
  }
  line(field.key, "");
  indented([&] {
    for (std::size_t i = 0; i < size; ++i) {
      line(in_quotes(name(i)), "");
      indented([&] { body(i); });
    }
  });
}

void FieldWriter::maybe(const Field&, bool present, const std::function<void()>&,
                        const std::function<void()>& body) {
  if (present) {
    body();
  }
}

void FieldWriter::list(const Field& field, std::size_t size, const std::function<void(std::size_t)>&,
                       const std::function<void(std::size_t)>& body) {
  line(field.key, size == 0 ? "[]" : "");
  for (std::size_t i = 0; i < size; ++i) {
    indented([&] {
      dash_ = true;
      indented([&] { body(i); });
    });
  }
}

void FieldWriter::one_of(std::optional<std::size_t> chosen, std::span<const Alternative> alternatives) {
  if (chosen) {
    alternatives[*chosen].body();
  }
}

void FieldWriter::some_of(std::initializer_list<std::string_view>) {}

void FieldWriter::line(std::string_view key, const std::string& value) {
  // The first field of a list's item carries the dash in its indent.
  text_ += std::string(dash_ ? indent_ - 2 : indent_, ' ') + (dash_ ? "- " : "");
  text_ += fmt::format("{}:{}{}\n", key, value.empty() ? "" : " ", value);
  dash_ = false;
}

void FieldWriter::indented(const std::function<void()>& body) {
  indent_ += 2;
  body();
  indent_ -= 2;
}

}  // namespace sensotwin::robot
