// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

namespace sensotwin::robot {

/// One file being written. It bears a temporary name (".<name>.part", same folder) until finish() renames it,
/// so a file under its final name is always complete: a reader never meets half of one, whatever happened to
/// us.
///
/// Destroyed unfinished, it removes what it wrote. After an error it removes that at once and is closed.
class OutputFile {
 public:
  /// \throws OutputError kCannotCreate
  explicit OutputFile(std::filesystem::path final_path);
  ~OutputFile();
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&& other) noexcept;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// \throws OutputError kIoError
  void append(std::string_view text);

  /// Room for `size` characters at the end of the file, for writers that format in place; valid until the
  /// next call of any member. `used` of them become part of the file by commit(used). \pre size <= kRoomMax
  /// \throws OutputError kIoError
  [[nodiscard]] char* room(std::size_t size);
  void commit(std::size_t used) { fill_ += used; }

  /// Writes what is left and gives the file its final name, replacing a file that has it.
  /// \pre not finished yet  \throws OutputError kIoError
  void finish();

  [[nodiscard]] const std::filesystem::path& final_path() const { return final_path_; }

  static constexpr std::size_t kRoomMax = 4096;

 private:
  void flush();
  void discard() noexcept;
  [[noreturn]] void fail(int error_number);

  std::filesystem::path final_path_;
  std::filesystem::path part_path_;
  std::unique_ptr<char[]> buffer_;
  std::size_t fill_{0};
  int descriptor_{-1};
};

/// The name that `final_path` bears while it is being written.
[[nodiscard]] std::filesystem::path part_path_of(const std::filesystem::path& final_path);

}  // namespace sensotwin::robot
