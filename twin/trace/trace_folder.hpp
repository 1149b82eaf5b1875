// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sensotwin::twin {

/// A file of the folder, as the page lists it.
struct TraceFile {
  std::string name;
  std::string kind;  ///< "tracing", "hallways", "scene", "map" or "picture"
};

/// What to write, by name.
using FileContents = std::map<std::string, std::string>;
/// What the page believes to lie in the folder, by name; a name that is missing: no such file.
using FileStamps = std::map<std::string, std::string>;

/// The one folder that a tracing session reads and writes. Names of files come from the page and are not
/// trusted: a name is one path component, does not begin with a dot, and names a plain file that lies in the
/// folder itself, links that lead out of it refused.
class TraceFolder {
 public:
  /// Makes the folder when it is not there. \throws OutputError kCannotCreate
  explicit TraceFolder(std::filesystem::path folder);

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

  /// What the page could open, by name. Folders with very many files are cut at kListedMax.
  [[nodiscard]] std::vector<TraceFile> files() const;
  /// Where that file lies. \throws TraceError kBadRequest for a name that is none, kNotFound
  [[nodiscard]] std::filesystem::path file(const std::string& name) const;
  /// \throws TraceError as file(), kTooLarge
  [[nodiscard]] std::string read(const std::string& name) const;

  /// Names that somebody else has written since `known` was taken, and that would be replaced by something
  /// else.
  [[nodiscard]] std::vector<std::string> conflicts(const FileContents& contents,
                                                   const FileStamps& known) const;
  /// Writes every file whole, each replaced at once (robot::OutputFile). \returns the new stamps
  /// \throws TraceError kBadRequest, kCannotWrite: with the system's reason; files before it are written
  FileStamps write(const FileContents& contents);

  /// Chosen: more than anybody's plans.
  static constexpr std::size_t kListedMax = 500;

 private:
  [[nodiscard]] std::optional<std::string> stamp_of(const std::string& name) const;

  std::filesystem::path folder_;
};

/// Whether a name may be used below the folder: letters, digits, '_', '-', '.', blanks and letters beyond
/// ASCII; no dot in front, 100 bytes at most.
[[nodiscard]] bool is_file_name(std::string_view name);

/// Of a file's content: differs when the content does (FNV-1a, 64 bits).
[[nodiscard]] std::string stamp_of_content(std::string_view content);

}  // namespace sensotwin::twin
