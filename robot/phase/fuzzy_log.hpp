// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/base/epc.hpp"
#include "robot/base/time.hpp"

namespace sensotwin::robot {

enum class FuzzyEventKind : std::uint8_t {
  kLegBegun,           ///< this destination is being steered to
  kDestinationHeard,   ///< first phase difference of this destination
  kArrived,            ///< its floor tag was read
  kDestinationSilent,  ///< not heard for a while: stopped, waiting
  kHeardAgain,
  kReaderDown,  ///< stopped, waiting
  kReaderUp,
  kGivenUp,     ///< waited too long: the mission ends here
  kLegTooLong,  ///< never arrived: the mission ends here
  kBumped,      ///< touched something: the mission ends here
  kDone,        ///< all destinations were reached
};

/// The event as a person reads it, in lower case, without a full stop.
[[nodiscard]] constexpr std::string_view words(FuzzyEventKind kind) {
  switch (kind) {
    case FuzzyEventKind::kLegBegun:
      return "steering to the next tag";
    case FuzzyEventKind::kDestinationHeard:
      return "tag heard";
    case FuzzyEventKind::kArrived:
      return "arrived, floor tag read";
    case FuzzyEventKind::kDestinationSilent:
      return "tag no longer heard, waiting";
    case FuzzyEventKind::kHeardAgain:
      return "tag heard again";
    case FuzzyEventKind::kReaderDown:
      return "UHF reader down, waiting";
    case FuzzyEventKind::kReaderUp:
      return "UHF reader up again";
    case FuzzyEventKind::kGivenUp:
      return "waited too long, stopped";
    case FuzzyEventKind::kLegTooLong:
      return "did not arrive in time, stopped";
    case FuzzyEventKind::kBumped:
      return "touched something, stopped";
    case FuzzyEventKind::kDone:
      return "all tags reached";
  }
  return "";
}

struct FuzzyEvent {
  Instant stamp;
  FuzzyEventKind kind{FuzzyEventKind::kDone};
  Epc destination;
};

/// Events since they were last taken. A mission adds a few per leg, and a few more whenever its reader falls
/// silent.
class FuzzyLog {
 public:
  void add(Instant stamp, FuzzyEventKind kind, const Epc& destination) {
    events_.push_back({stamp, kind, destination});
  }
  [[nodiscard]] std::vector<FuzzyEvent> take() { return std::exchange(events_, {}); }
  [[nodiscard]] bool empty() const { return events_.empty(); }

 private:
  std::vector<FuzzyEvent> events_;
};

}  // namespace sensotwin::robot
