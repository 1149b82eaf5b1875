// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include "tests/robot/drivers/card_transcript.hpp"
#include "twin/devices/emulated_card_reader.hpp"

namespace sensotwin::twin {

/// The tag of the transcripts, before they write it.
inline world::TagMemory transcript_tag() {
  world::TagMemory tag;
  tag.uid = testing::kTranscriptUid;
  for (std::size_t i = 0; i < testing::kOldData.size(); ++i) {
    tag.blocks[i / 4][i % 4] = testing::kOldData[i];
  }
  tag.locked.set(9);
  return tag;
}
/// Its first three blocks, where a record lies.
inline robot::Bytes record_bytes(const world::TagMemory& tag) {
  const auto bytes = [&](std::size_t block) {
    return robot::Bytes(tag.blocks[block].begin(), tag.blocks[block].end());
  };
  return testing::joined({bytes(0), bytes(1), bytes(2)});
}

/// One reader and its time.
class CardReaderBench : public ::testing::Test {
 protected:
  void step(world::TagMemory* tag, robot::Duration dt = robot::kTick) {
    now_ += dt;
    reader_.step(now_, tag);
  }

  EmulatedCardReader reader_{card_reader_settings({}), robot::RandomStream{1}};
  robot::Instant now_{};
};

}  // namespace sensotwin::twin
