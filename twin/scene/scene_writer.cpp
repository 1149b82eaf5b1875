// SPDX-License-Identifier: MIT
#include "twin/scene/scene_writer.hpp"

#include <fmt/format.h>

#include "twin/scene/fields.hpp"
#include "twin/scene/number_text.hpp"

namespace sensotwin::twin {
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

std::string in_brackets(const robot::Vec2& p) {
  return fmt::format("[{}, {}]", number_text(p.x()), number_text(p.y()));
}

class FieldWriter : public FieldVisitor {
 public:
  [[nodiscard]] const std::string& text() const { return text_; }

  void number(const Field& field, double& value, const Range&) override {
    line(field.key, number_text(value));
  }
  void angle(const Field& field, double& rad, const Range&) override {
    line(field.key, number_text(degrees_for(rad)));
  }
  void integer(const Field& field, std::int64_t& value, std::int64_t, std::int64_t) override {
    line(field.key, std::to_string(value));
  }
  void seed(const Field& field, std::uint64_t& value) override { line(field.key, std::to_string(value)); }
  void flag(const Field& field, bool& value) override { line(field.key, value ? "true" : "false"); }
  void text(const Field& field, std::string& value) override { line(field.key, in_quotes(value)); }
  void choice(const Field& field, std::size_t& index, std::span<const std::string_view> words) override {
    line(field.key, std::string(words[index]));
  }
  void point(const Field& field, robot::Vec2& value, const Range&) override {
    line(field.key, in_brackets(value));
  }
  void points(const Field& field, std::vector<robot::Vec2>& value, const Range&, Count) override {
    std::string list;
    for (const robot::Vec2& point : value) {
      list += (list.empty() ? "" : ", ") + in_brackets(point);
    }
    line(field.key, "[" + list + "]");
  }
  void numbers(const Field& field, std::vector<double>& value, const Range&, Count) override {
    std::string list;
    for (const double number : value) {
      list += (list.empty() ? "" : ", ") + number_text(number);
    }
    line(field.key, "[" + list + "]");
  }
  void texts(const Field& field, std::vector<std::string>& value, Count) override {
    std::string list;
    for (const std::string& word : value) {
      list += (list.empty() ? "" : ", ") + in_quotes(word);
    }
    line(field.key, "[" + list + "]");
  }
  void hex(const Field& field, std::span<std::uint8_t> value) override {
    std::string digits;
    for (const std::uint8_t byte : value) {
      digits += fmt::format("{:02X}", byte);
    }
    line(field.key, in_quotes(digits));
  }
  void cells(const Field& field, Cells& value) override {
    std::string list;
    for (const auto& [column, row] : value) {
      list += fmt::format("{}[{}, {}]", list.empty() ? "" : ", ", column, row);
    }
    line(field.key, "[" + list + "]");
  }
  void section(const Field& field, const std::function<void()>& body) override {
    line(field.key, "");
    indented(body);
  }
  void section_or_word(const Field& field, std::span<const std::string_view> words,
                       std::optional<std::size_t> shown, const std::function<void(std::size_t)>&,
                       const std::function<void()>& body) override {
    if (shown) {
      line(field.key, std::string(words[*shown]));
    } else {
      section(field, body);
    }
  }
  void named(const Field& field, std::size_t size, const std::function<std::string(std::size_t)>& name,
             const std::function<std::size_t(const std::string&)>&,
             const std::function<void(std::size_t)>& body) override {
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
  void maybe(const Field&, bool present, const std::function<void()>&,
             const std::function<void()>& body) override {
    if (present) {
      body();
    }
  }
  void list(const Field& field, std::size_t size, const std::function<void(std::size_t)>&,
            const std::function<void(std::size_t)>& body) override {
    line(field.key, size == 0 ? "[]" : "");
    for (std::size_t i = 0; i < size; ++i) {
      indented([&] {
        dash_ = true;
        indented([&] { body(i); });
      });
    }
  }
  void one_of(std::optional<std::size_t> chosen, std::span<const Alternative> alternatives) override {
    if (chosen) {
      alternatives[*chosen].body();
    }
  }
  void some_of(std::initializer_list<std::string_view>) override {}

 private:
  void line(std::string_view key, const std::string& value) {
    // The first field of a list's item carries the dash in its indent.
    text_ += std::string(dash_ ? indent_ - 2 : indent_, ' ') + (dash_ ? "- " : "");
    text_ += fmt::format("{}:{}{}\n", key, value.empty() ? "" : " ", value);
    dash_ = false;
  }
  void indented(const std::function<void()>& body) {
    indent_ += 2;
    body();
    indent_ -= 2;
  }

  std::string text_;
  std::size_t indent_{0};
  bool dash_{false};
};

}  // namespace

std::string scene_yaml(const Scene& scene, const std::filesystem::path& folder) {
  Scene shown = scene;
  if (shown.layout.map && !folder.empty()) {
    const std::filesystem::path map =
        std::filesystem::path(scene.file).parent_path() / scene.layout.map->file;
    shown.layout.map->file = std::filesystem::proximate(map, folder).string();
  }
  FieldWriter writer;
  visit_fields(writer, shown);
  return writer.text();
}

}  // namespace sensotwin::twin
