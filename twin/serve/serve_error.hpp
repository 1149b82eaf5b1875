// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace sensotwin::twin {

/// A wire could not be opened: no pseudo-terminal, a port that is taken. Ends `twin serve` with kUnavailable.
class ServeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sensotwin::twin
