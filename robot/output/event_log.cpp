// SPDX-License-Identifier: MIT
#include "robot/output/event_log.hpp"

#include <array>
#include <charconv>
#include <utility>

#include "robot/output/text_format.hpp"

namespace sensotwin::robot {
namespace {

void append_number(std::string& to, double value) {
  std::array<char, 32> text;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled below
  char* end = put_fixed<6>(text.data(), value);
  if (end == text.data()) {
    to += "null";
    return;
  }
  while (end[-1] == '0') {
    --end;
  }
  if (end[-1] == '.') {
    --end;
  }
  to.append(text.data(), end);
}

struct AppendValue {
  std::string& to;

  void operator()(bool value) const { to += value ? "true" : "false"; }
  void operator()(std::int64_t value) const { to += std::to_string(value); }
  void operator()(double value) const { append_number(to, value); }
  void operator()(std::string_view value) const { append_json_string(to, value); }
};

}  // namespace

void append_json_fields(std::string& to, std::initializer_list<EventField> fields) {
  for (const EventField& field : fields) {
    to += ',';
    append_json_string(to, field.key);
    to += ':';
    std::visit(AppendValue{to}, field.value);
  }
}

EventLog::EventLog(OutputFile file) : file_(std::move(file)) {}

void EventLog::add(Instant now, std::string_view event, std::initializer_list<EventField> fields) {
  line_ = "{\"t_s\":";
  std::array<char, 32> text;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled below
  line_.append(text.data(), put_fixed<3>(text.data(), to_s(now)));
  line_ += ",\"event\":";
  append_json_string(line_, event);
  append_json_fields(line_, fields);
  line_ += "}\n";
  file_.append(line_);
  ++count_;
  if (listener_) {
    listener_(now, event, fields);
  }
}

}  // namespace sensotwin::robot
