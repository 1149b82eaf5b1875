// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "robot/journal/journal_writer.hpp"

namespace sensotwin::robot {

/// A journal on disk, under its final name from the first byte on: a run that is killed leaves what it had
/// written, to the last step. Neither copies nor moves.
class JournalFile {
 public:
  /// \param file  none: no journal is written  \throws OutputError kCannotCreate
  JournalFile(const std::optional<std::filesystem::path>& file, std::string_view robot_file);
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// None when there is no journal.
  [[nodiscard]] JournalWriter* writer() { return writer_ ? &*writer_ : nullptr; }

 private:
  std::ofstream stream_;
  std::optional<JournalWriter> writer_;
};

/// The journal in a file. \throws LoadError
[[nodiscard]] Journal journal_in(const std::filesystem::path& file);

}  // namespace sensotwin::robot
