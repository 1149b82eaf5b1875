// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace sensotwin::robot {

/// What a process says when it ends. The numbers are those of BSD's <sysexits.h> where it has
/// one, and 128 + signal as shells have it; they are stable, scripts and clusters depend on them.
enum class ExitCode : int {
  kDone = 0,         ///< done, and accepted where the scene expects something
  kNotAccepted = 1,  ///< done, but an expectation of the scene was missed
  kWrongCommandLine = 2,
  kInvalidData = 65,   ///< EX_DATAERR: the scene or a file that it names is invalid
  kInputMissing = 66,  ///< EX_NOINPUT
  kUnavailable = 69,   ///< EX_UNAVAILABLE: a device or a part of this machine is not reachable
  kInternal = 70,      ///< EX_SOFTWARE: a mistake of the program's own
  kCannotCreate = 73,  ///< EX_CANTCREAT: an output file or folder cannot be created
  kIoError = 74,       ///< EX_IOERR: writing failed half-way (disk full)
  kTryAgain = 75,      ///< EX_TEMPFAIL: interrupted in an orderly way, to be resumed
  kInterrupted = 130,  ///< 128 + SIGINT
  kTerminated = 143,   ///< 128 + SIGTERM
};

struct ExitCodeMeaning {
  ExitCode code;
  std::string_view meaning;
};

/// One sentence for each code, for --help and `twin list exit-codes`.
inline constexpr std::array<ExitCodeMeaning, 12> kExitCodeMeanings{{
    {ExitCode::kDone, "done, and accepted where the scene expects something"},
    {ExitCode::kNotAccepted, "done, but an expectation of the scene was missed"},
    {ExitCode::kWrongCommandLine, "wrong command line"},
    {ExitCode::kInvalidData, "the scene, or a file that it names, is invalid"},
    {ExitCode::kInputMissing, "an input file is missing"},
    {ExitCode::kUnavailable, "a device, or something this machine needs, is not reachable"},
    {ExitCode::kInternal, "internal error"},
    {ExitCode::kCannotCreate, "an output file or folder cannot be created"},
    {ExitCode::kIoError, "writing failed, for instance because the disk is full"},
    {ExitCode::kTryAgain, "interrupted in an orderly way; can be resumed"},
    {ExitCode::kInterrupted, "interrupted by SIGINT (Ctrl-C); what was done so far is in the folder"},
    {ExitCode::kTerminated, "ended by SIGTERM; what was done so far is in the folder"},
}};

[[nodiscard]] constexpr int as_int(ExitCode code) {
  return static_cast<int>(code);
}

}  // namespace sensotwin::robot
