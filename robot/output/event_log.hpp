// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "robot/base/time.hpp"
#include "robot/output/output_file.hpp"

namespace sensotwin::robot {

/// One key of an event. Keys of quantities end in their unit. Views must live through the call only.
struct EventField {
  using Value = std::variant<bool, std::int64_t, double, std::string_view>;

  EventField(std::string_view k, bool v) : key(k), value(v) {}
  template <std::integral T>
  requires(!std::same_as<T, bool>) EventField(std::string_view k, T v)
      : key(k), value(static_cast<std::int64_t>(v)) {}
  EventField(std::string_view k, double v) : key(k), value(v) {}
  EventField(std::string_view k, std::string_view v) : key(k), value(v) {}
  EventField(std::string_view k, const char* v) : key(k), value(std::string_view{v}) {}
  EventField(std::string_view k, const std::string& v) : key(k), value(std::string_view{v}) {}

  std::string_view key;
  Value value;
};

/// Appends `,"key":value` for each field, as EventLog writes them.
void append_json_fields(std::string& to, std::initializer_list<EventField> fields);

/// events.jsonl: one JSON object a line, {"t_s":..., "event":..., fields in the order given}. UTF-8. Numbers
/// with at most six decimals; one that is not finite becomes null, since JSON has no NaN.
class EventLog {
 public:
  /// \param file  not yet written to
  explicit EventLog(OutputFile file);

  /// Something happened. \param event  a past participle or noun: "tag_found", "bump", "write_torn"
  /// \throws OutputError
  void add(Instant now, std::string_view event, std::initializer_list<EventField> fields = {});
  /// Told of every event after it was written, in the thread that wrote it.
  using Listener = std::function<void(Instant, std::string_view, std::initializer_list<EventField>)>;
  void set_listener(Listener listener) { listener_ = std::move(listener); }
  /// \throws OutputError
  void finish() { file_.finish(); }
  [[nodiscard]] std::int64_t count() const { return count_; }

 private:
  OutputFile file_;
  std::string line_;
  Listener listener_;
  std::int64_t count_{0};
};

}  // namespace sensotwin::robot
