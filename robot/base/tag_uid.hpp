// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace sensotwin::robot {

/// 64-bit unique number of an ISO 15693 tag; its most significant byte is E0 (ISO/IEC 15693-3, section 4.1).
using TagUid = std::uint64_t;

}  // namespace sensotwin::robot
