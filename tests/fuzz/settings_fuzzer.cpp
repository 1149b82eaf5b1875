// SPDX-License-Identifier: MIT
#include <string>

#include "robot/settings/hallway_file.hpp"
#include "robot/settings/robot_file.hpp"
#include "tests/fuzz/fuzzers.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/refusal.hpp"

namespace sensotwin::fuzz {
namespace {

/// `shown_of` reads a text and shows it again: what is shown has to read back to itself.
template <class ShownOf>
void check(const std::string& text, ShownOf&& shown_of) {
  std::string shown;
  try {
    shown = shown_of(text);
  } catch (const robot::LoadError& refusal) {
    check_refusal(refusal);
    return;
  }
  try {
    require(shown_of(shown) == shown, "a file read, shown and read is the same");
  } catch (const robot::LoadError& refusal) {
    throw PropertyBroken(std::string{"a file that was shown is refused: "} + refusal.what());
  }
}

}  // namespace

void settings(robot::ByteView input) {
  const std::string text(input.begin(), input.end());
  check(text, [](const std::string& hallways) {
    return robot::hallway_yaml(robot::read_hallway_text(hallways, kNowhere));
  });
  check(text, [](const std::string& machine) {
    return robot::robot_yaml(robot::read_robot_text(machine, kNowhere, {}, robot::RobotFileUse::kCheck));
  });
}

}  // namespace sensotwin::fuzz
