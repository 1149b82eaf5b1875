// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "robot/config/field_visitor.hpp"
#include "robot/config/problem.hpp"
#include "robot/config/yaml_tree.hpp"

namespace sensotwin::robot {

/// Fills a struct from a YAML tree and finds every mistake in one pass: unknown, duplicate and missing keys,
/// wrong types, numbers out of range. A field that is wrong keeps its default.
class FieldReader : public FieldVisitor {
 public:
  /// \param root  must outlive the reader
  FieldReader(const YamlNode& root, std::vector<Problem>& problems);
  /// Reports the keys of the root that nobody asked for. Call once, after the visit.
  void finish();

  /// Where `path` was written; where its nearest section was, when it was not. "" is the start of the file.
  [[nodiscard]] Place place(std::string path) const;
  /// True when `path` was written.
  [[nodiscard]] bool has(const std::string& path) const { return places_.count(path) != 0; }

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
  /// A section being read.
  struct Frame {
    const YamlNode* node;
    std::string path;
    Place place;                     ///< of its key
    std::vector<std::string> known;  ///< keys asked for so far
  };

  void enter(const YamlNode& node, const std::string& path, const Place& place,
             const std::function<void()>& body);
  void leave();
  /// The value of a field, or null when it is absent (a problem when required) or belongs to a group not
  /// chosen.
  const YamlNode* take(const Field& field);
  void know(std::string_view key);
  void add(const Place& place, const std::string& path, std::string what, std::string hint);
  void wrong(const YamlNode& node, const std::string& path, const std::string& expected);
  /// The number in `node` if it is one and lies in range.
  std::optional<double> number_in(const YamlNode& node, const std::string& path, const Range& range);
  std::optional<std::int64_t> integer_in(const YamlNode& node, const std::string& path, std::int64_t min,
                                         std::int64_t max);
  std::optional<Vec2> point_in(const YamlNode& node, const std::string& path, const Range& range);
  /// Each item of a list and its path, in order. \returns false when there is no such list
  bool each_item(const Field& field, Count count, const std::string& of_what,
                 const std::function<void(const YamlNode&, const std::string&)>& take_in);
  bool list_in(const YamlNode& node, const std::string& path, Count count, const std::string& of_what);
  [[nodiscard]] std::string path_of(std::string_view key) const;

  std::vector<Problem>& problems_;
  std::vector<Frame> frames_;
  std::map<std::string, Place> places_;
  /// Not empty while a group that was not chosen is walked: the key that was chosen instead of it.
  std::string instead_of_;
};

}  // namespace sensotwin::robot
