// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/config/field_visitor.hpp"

namespace sensotwin::robot {

/// Writes a struct as YAML that FieldReader reads back to the same values, defaults included.
class FieldWriter : public FieldVisitor {
 public:
  [[nodiscard]] const std::string& text() const { return text_; }

  void number(const Field& field, double& value, const Range& range) override;
  void angle(const Field& field, double& rad, const Range& range_deg) override;
  void integer(const Field& field, std::int64_t& value, std::int64_t min, std::int64_t max) override;
  void seed(const Field& field, std::uint64_t& value) override;
  void flag(const Field& field, bool& value) override;
  void text(const Field& field, std::string& value) override;
  void choice(const Field& field, std::size_t& index, std::span<const std::string_view> words) override;
  void point(const Field& field, Vec2& value, const Range& range) override;
  void points(const Field& field, std::vector<Vec2>& value, const Range& range, Count count) override;
  void numbers(const Field& field, std::vector<double>& value, const Range& range, Count count) override;
  void texts(const Field& field, std::vector<std::string>& value, Count count) override;
  void hex(const Field& field, std::span<std::uint8_t> value) override;
  void cells(const Field& field, Cells& value) override;
  void section(const Field& field, const std::function<void()>& body) override;
  void section_or_word(const Field& field, std::span<const std::string_view> words,
                       std::optional<std::size_t> shown, const std::function<void(std::size_t)>& take_word,
                       const std::function<void()>& body) override;
  void named(const Field& field, std::size_t size, const std::function<std::string(std::size_t)>& name,
             const std::function<std::size_t(const std::string&)>& add,
             const std::function<void(std::size_t)>& body) override;
  void maybe(const Field& field, bool present, const std::function<void()>& set,
             const std::function<void()>& body) override;
  void list(const Field& field, std::size_t size, const std::function<void(std::size_t)>& resize,
            const std::function<void(std::size_t)>& body) override;
  void one_of(std::optional<std::size_t> chosen, std::span<const Alternative> alternatives) override;
  void some_of(std::initializer_list<std::string_view> keys) override;

 private:
  void line(std::string_view key, const std::string& value);
  void indented(const std::function<void()>& body);

  std::string text_;
  std::size_t indent_{0};
  bool dash_{false};  ///< the next line is the first of a list's item
};

}  // namespace sensotwin::robot
