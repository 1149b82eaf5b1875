// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "robot/base/result.hpp"

namespace sensotwin::render {

/// Why there is no picture. `message` is one sentence for the person at the command line.
struct RenderError {
  enum class Kind : std::uint8_t {
    kBackendMissing,  ///< the library of that backend is not on this machine
    kBackendFailed,   ///< it is there, but gave no context or drew an error
    kBadView,         ///< the view holds a number that cannot be drawn (NaN, infinite), or an impossible size
    kEncoding,        ///< libpng or cairo refused
  };
  Kind kind{Kind::kBadView};
  std::string message;
};

template <class T>
using Rendered = robot::Result<T, RenderError>;
using robot::Unexpected;

}  // namespace sensotwin::render
