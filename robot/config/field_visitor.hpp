// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "robot/base/geometry.hpp"

/// The list of the fields of a file is written once and visited three times: to read a file, to show
/// one, to publish the schema. This is what the list speaks to.
namespace sensotwin::robot {

struct Field {
  std::string_view key;
  std::string_view help;  ///< for the schema and for messages: what it is, with its unit
  bool required{false};
};

/// Closed interval in the file's unit.
struct Range {
  double min{std::numeric_limits<double>::lowest()};
  double max{std::numeric_limits<double>::max()};
  bool above_min{false};  ///< min itself is not allowed
};

struct Count {
  std::size_t min{0};
  std::size_t max{100000};  ///< chosen: far above any scene, low enough to keep a slip from eating the memory
};

/// Columns and rows of tiles lie between minus this and this. Chosen: 50 km of carpet.
inline constexpr std::int64_t kFarthestTile = 100000;
/// What a key of free choice may look like, as a regular expression.
inline constexpr const char* kNamePattern = "^[a-z0-9_.]+$";

using Cells = std::vector<std::pair<int, int>>;

class FieldVisitor {
 public:
  virtual ~FieldVisitor() = default;

  virtual void number(const Field& field, double& value, const Range& range) = 0;
  /// `rad` is written in degrees in the file; the range too.
  virtual void angle(const Field& field, double& rad, const Range& range_deg) = 0;
  virtual void integer(const Field& field, std::int64_t& value, std::int64_t min, std::int64_t max) = 0;
  virtual void seed(const Field& field, std::uint64_t& value) = 0;
  virtual void flag(const Field& field, bool& value) = 0;
  virtual void text(const Field& field, std::string& value) = 0;
  virtual void choice(const Field& field, std::size_t& index, std::span<const std::string_view> words) = 0;
  /// [x, y], each within `range`.
  virtual void point(const Field& field, Vec2& value, const Range& range) = 0;
  virtual void points(const Field& field, std::vector<Vec2>& value, const Range& range, Count count) = 0;
  /// Plain numbers, each within `range`.
  virtual void numbers(const Field& field, std::vector<double>& value, const Range& range, Count count) = 0;
  virtual void texts(const Field& field, std::vector<std::string>& value, Count count) = 0;
  /// Two hexadecimal digits for each byte, as long as `value`.
  virtual void hex(const Field& field, std::span<std::uint8_t> value) = 0;
  /// [[column, row], ...]
  virtual void cells(const Field& field, Cells& value) = 0;
  virtual void section(const Field& field, const std::function<void()>& body) = 0;
  /// A section, or one of `words` in its place. `shown`: the word that stands for the present value, if one
  /// does.
  virtual void section_or_word(const Field& field, std::span<const std::string_view> words,
                               std::optional<std::size_t> shown,
                               const std::function<void(std::size_t)>& take_word,
                               const std::function<void()>& body) = 0;
  /// Sections with keys of free choice.
  virtual void named(const Field& field, std::size_t size,
                     const std::function<std::string(std::size_t)>& name,
                     const std::function<std::size_t(const std::string&)>& add,
                     const std::function<void(std::size_t)>& body) = 0;

  /// A field that may be absent and has no default then. `set` makes it present.
  virtual void maybe(const Field& field, bool present, const std::function<void()>& set,
                     const std::function<void()>& body) = 0;
  virtual void list(const Field& field, std::size_t size, const std::function<void(std::size_t)>& resize,
                    const std::function<void(std::size_t)>& body) = 0;
  /// Exactly one of several groups of fields; the key that decides is the first of its group.
  struct Alternative {
    std::string_view key;
    std::function<void()> choose;  ///< makes this the one
    std::function<void()> body;
  };
  virtual void one_of(std::optional<std::size_t> chosen, std::span<const Alternative> alternatives) = 0;
  /// At least one of these keys, all of them visited by maybe() before, must be there.
  virtual void some_of(std::initializer_list<std::string_view> keys) = 0;

  // Shorthands.
  template <class E>
  requires std::is_enum_v<E>
  void choice(const Field& field, E& value, std::span<const std::string_view> words) {
    auto index = static_cast<std::size_t>(value);
    choice(field, index, words);
    value = static_cast<E>(index);
  }
  template <class I>
  requires std::is_integral_v<I>
  void whole(const Field& field, I& value, std::int64_t min, std::int64_t max) {
    std::int64_t wide = static_cast<std::int64_t>(value);
    integer(field, wide, min, max);
    value = static_cast<I>(wide);
  }
  template <class T, class Body>
  void maybe(const Field& field, std::optional<T>& value, const Body& body) {
    maybe(
        field, value.has_value(), [&] { value.emplace(); }, [&] { body(*value); });
  }
  template <class T, class Body>
  void list(const Field& field, std::vector<T>& items, const Body& body) {
    list(
        field, items.size(), [&](std::size_t n) { items.resize(n); }, [&](std::size_t i) { body(items[i]); });
  }
};

}  // namespace sensotwin::robot
