// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>

#include "robot/config/problem.hpp"
#include "tests/fuzz/harness.hpp"

namespace sensotwin::fuzz {

/// Where a text is said to stand: files that it names are not there.
inline constexpr const char* kNowhere = "no_such_folder/text.yaml";

/// A refusal gives people a reason each time.
inline void check_refusal(const robot::LoadError& refusal) {
  require(!refusal.problems().empty() && std::strlen(refusal.what()) > 0, "who refuses a file says why");
  for (const robot::Problem& problem : refusal.problems()) {
    require(!problem.what.empty() && !problem.place.source.empty(), "a problem has words and a place");
  }
}

}  // namespace sensotwin::fuzz
