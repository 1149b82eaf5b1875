// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <string_view>

#include "robot/output/exit_codes.hpp"
#include "twin/output/progress.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace sensotwin::twin {

enum class Verbosity : std::uint8_t { kQuiet, kNormal, kVerbose };

/// What a command gets from the process: two streams, the user's wishes, and time, since only main has a
/// clock.
struct Context {
  std::ostream& out;   ///< stdout: results, nothing else
  std::ostream& talk;  ///< stderr: everything that is said on the way
  bool json{false};
  Verbosity verbosity{Verbosity::kNormal};
  bool color{false};  ///< whether `talk` may be coloured
  ProgressStyle progress{};
  std::function<double()> wall_s;    ///< monotonic seconds since main began
  std::function<std::string()> utc;  ///< now, as "20260131T235959Z", for the names of folders

  /// A line on stderr, unless quiet.
  void say(std::string_view line) const;
  /// A line on stderr, when verbose.
  void say_more(std::string_view line) const;
  /// "warning: ..." on stderr, always.
  void warn(std::string_view line) const;
};

/// A command ends here, with this code and one message. For what the user can mend; a mistake of the twin's
/// own is any other exception and ends in kInternal.
class CommandError : public std::runtime_error {
 public:
  /// \param complete  `what` is lines of the form "file:line:col: error: ...": printed as they are
  CommandError(robot::ExitCode exit_code, const std::string& what, bool complete = false)
      : std::runtime_error(what), exit_code_(exit_code), complete_(complete) {}
  [[nodiscard]] robot::ExitCode exit_code() const { return exit_code_; }
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  robot::ExitCode exit_code_;
  bool complete_;
};

/// One word behind `twin`.
struct Command {
  std::string name;
  std::string summary;                    ///< one line, small letter first, no full stop
  std::string examples;                   ///< command lines, one a line; help opens with them
  std::function<void(CLI::App&)> set_up;  ///< declares options and operands
  std::function<robot::ExitCode(Context&)>
      run;  ///< after a successful parse; may throw OutputError, CommandError
};

}  // namespace sensotwin::twin
