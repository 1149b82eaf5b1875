// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace sensotwin::robot {

/// A page cannot be served: its text names the address and the reason, in one line.
class WebError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sensotwin::robot
