// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "robot/base/bytes.hpp"

/// Parts of the fuzzer `llrp`. All throw PropertyBroken.
namespace sensotwin::fuzz {

/// The emulated reader, a client that says `input`, and tags that come and go.
void llrp_reader(robot::ByteView input, std::size_t piece, std::uint64_t seed);

}  // namespace sensotwin::fuzz
