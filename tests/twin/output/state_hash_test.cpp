// SPDX-License-Identifier: MIT
#include "twin/output/state_hash.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace sensotwin::twin {
namespace {

TEST(StateHash, IsTheSameOnEveryMachine) {
  StateHash hash;
  hash.add(1.5);
  hash.add(-7);
  hash.add(std::uint8_t{200});
  // Golden: the three steps of the formula in the header, taken by a Python script on big integers.
  EXPECT_EQ(hash.text(), "28510efac511bad7");
}

TEST(StateHash, ChangesWithEveryBitOfAWord) {
  for (int bit = 0; bit < 64; ++bit) {
    StateHash plain;
    StateHash flipped;
    plain.add(std::uint64_t{0});
    flipped.add(std::uint64_t{1} << bit);
    for (int i = 0; i < 3; ++i) {
      plain.add(i);
      flipped.add(i);
    }
    EXPECT_NE(plain.value(), flipped.value()) << bit;
  }
}

TEST(StateHash, TellsOrderApart) {
  StateHash ab;
  StateHash ba;
  ab.add(1);
  ab.add(2);
  ba.add(2);
  ba.add(1);
  EXPECT_NE(ab.value(), ba.value());
}

}  // namespace
}  // namespace sensotwin::twin
