// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "robot/output/output_file.hpp"

namespace sensotwin::robot {

/// What to do with a folder that already holds something.
enum class Existing : std::uint8_t {
  kRefuse,
  kReplace,  ///< --force: files of the same name are replaced; summary and timing go at once, so that an old
             ///< verdict never lies beside new data
};

/// The folder a run leaves behind. Every file in it is complete or absent under its final name.
class RunFolder {
 public:
  /// Creates `directory` and its parents where missing.
  /// \throws OutputError kCannotCreate: no such place, no permission, not a folder, or not empty and kRefuse
  RunFolder(std::filesystem::path directory, Existing existing);

  [[nodiscard]] const std::filesystem::path& path() const { return directory_; }

  /// Writes a whole file. `name` is relative and may lie in a sub-folder ("snapshots/0001.txt"), which is
  /// made. \throws OutputError
  void write(std::string_view name, std::string_view content);

  /// Begins a file that grows during the run. It appears under `name` when finished; the caller finishes it
  /// also when the run is interrupted, between two lines, and so leaves a valid shorter file. \throws
  /// OutputError
  [[nodiscard]] OutputFile stream(std::string_view name);

  /// For files that another library writes by itself (pictures): `writer` gets a temporary path in the right
  /// folder with the extension of `name`, and the file is renamed when it returns, removed when it throws.
  /// \throws OutputError, and what `writer` throws
  void write_by(std::string_view name, const std::function<void(const std::filesystem::path&)>& writer);

 private:
  [[nodiscard]] std::filesystem::path prepare(std::string_view name);

  std::filesystem::path directory_;
};

/// Where a run goes when nobody said where: runs/<scene>-<seed>-<utc>, below the working directory.
/// \param scene  its name, with the variant's  \param utc  for instance "20260131T235959Z"; main's clock
[[nodiscard]] std::filesystem::path default_run_folder(std::string_view scene, std::uint64_t seed,
                                                       std::string_view utc);

/// Where a validation goes when nobody said where: runs/validate-<scene>-<utc>.
[[nodiscard]] std::filesystem::path default_validation_folder(std::string_view scene, std::string_view utc);

}  // namespace sensotwin::robot
