// SPDX-License-Identifier: MIT
#include <string>

#include "tests/fuzz/fuzzers.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/refusal.hpp"
#include "twin/scene/scene_reader.hpp"
#include "twin/scene/scene_writer.hpp"

namespace sensotwin::fuzz {

/// A scene is refused with reasons and places, or shown as text that reads back to itself.
void scene(robot::ByteView input) {
  const std::string text(input.begin(), input.end());
  std::string shown;
  try {
    shown = twin::scene_yaml(twin::read_scene_text(text, kNowhere));
  } catch (const robot::LoadError& refusal) {
    check_refusal(refusal);
    return;
  }
  try {
    require(twin::scene_yaml(twin::read_scene_text(shown, kNowhere)) == shown,
            "a scene read, shown and read is the same");
  } catch (const robot::LoadError& refusal) {
    throw PropertyBroken(std::string{"a scene that was shown is refused: "} + refusal.what());
  }
}

}  // namespace sensotwin::fuzz
