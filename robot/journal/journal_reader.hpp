// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "robot/base/result.hpp"
#include "robot/journal/journal_format.hpp"

namespace sensotwin::robot {

/// Reads a journal whole. What stands behind the last good block is counted as torn: a journal that a crash
/// cut off is as good as its last block.
/// \returns the journal, or why it is none, for people
[[nodiscard]] Result<Journal, std::string> read_journal(ByteView file);

}  // namespace sensotwin::robot
