// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace sensotwin::robot {

/// Where something was written: a place in a file, or an option of the command line.
struct Place {
  std::string source;  ///< file as the user spelt it, or "--set key=value"
  int line{0};         ///< from 1; 0: `source` is no file, or the whole of it is meant
  int column{0};       ///< from 1

  /// "file:line:col", or the source alone.
  [[nodiscard]] std::string text() const;
};

/// One mistake of a person, found while loading.
struct Problem {
  Place place;
  std::string path;  ///< of the key: "world.furniture[0].mass_kg"; may be empty
  std::string what;  ///< what is wrong
  std::string hint;  ///< what was expected, with "(did you mean ...?)" where a near name exists

  /// "file:line:col: error: path: what; hint".
  [[nodiscard]] std::string text() const;
};

/// Exit codes of sysexits.h that loading can end in (design: command line).
inline constexpr int kExitUsage = 2;
inline constexpr int kExitInvalid = 65;
inline constexpr int kExitMissing = 66;

/// A scene, map or robot file cannot be used. what() holds one line per problem, in the order of the file.
class LoadError : public std::runtime_error {
 public:
  /// \pre !problems.empty(). Sorted by place here; all but the first kProblemsMax are dropped.
  LoadError(std::vector<Problem> problems, int exit_code);
  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }
  /// kExitInvalid, kExitMissing (a file is not there) or kExitUsage (an option is not of the form key=value).
  [[nodiscard]] int exit_code() const { return exit_code_; }

  /// Chosen: what fits on a screen; more are seldom independent mistakes.
  static constexpr std::size_t kProblemsMax = 20;

 private:
  std::vector<Problem> problems_;
  int exit_code_;
};

}  // namespace sensotwin::robot
