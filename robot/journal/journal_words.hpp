// SPDX-License-Identifier: MIT
#pragma once

#include "robot/hal/card_link.hpp"
#include "robot/journal/journal_format.hpp"

/// What a CardLink says, as journals spell it: the words follow one another in the order of the enumerations.
namespace sensotwin::robot {

[[nodiscard]] constexpr WireWord word_of(CardPresence presence) {
  return static_cast<WireWord>(static_cast<int>(WireWord::kNoReader) + static_cast<int>(presence));
}
[[nodiscard]] constexpr WireWord word_of(CardError error) {
  return static_cast<WireWord>(static_cast<int>(WireWord::kAnswerRemoved) + static_cast<int>(error));
}
static_assert(word_of(CardPresence::kPresent) == WireWord::kPresent);
static_assert(word_of(CardError::kTimeout) == WireWord::kAnswerTimeout);

}  // namespace sensotwin::robot
