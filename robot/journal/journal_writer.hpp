// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "robot/journal/journal_format.hpp"

namespace sensotwin::robot {

/// Writes a journal, block by block. Throws nothing: a journal that cannot be written must not stop a robot.
class JournalWriter {
 public:
  /// Takes bytes to where they are kept. \returns false when it cannot; nothing more is given to it then
  using Sink = std::function<bool(ByteView)>;

  JournalWriter(Sink sink, std::string_view robot_file);

  /// \pre record.bytes is empty unless has_bytes(word)
  void add(Wire wire, WireWord word, ByteView bytes = {});
  /// Closes the block of a step. \param now  as the step was given it
  void end_step(Instant now) { end_block('T', now); }
  /// Closes the block of shut_down().
  void end_run(Instant now) { end_block('E', now); }

  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] std::uint64_t bytes_written() const { return bytes_written_; }

 private:
  void end_block(char kind, Instant now);
  void give(ByteView bytes);

  Sink sink_;
  bool failed_{false};
  std::uint64_t bytes_written_{0};
  Instant last_;
  Bytes records_;
  Bytes block_;
};

}  // namespace sensotwin::robot
