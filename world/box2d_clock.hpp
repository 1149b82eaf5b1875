// SPDX-License-Identifier: MIT
#pragma once

namespace sensotwin::world {

/// Box2D 2.4 reads the machine's clock fourteen times in every step, for a profile that nobody here asks for:
/// half of what a step of our houses costs, and a hidden input. world/ brings a b2Timer of its own that
/// stands still; a linker takes it before that of a shared library. \returns whether it did, in this program
[[nodiscard]] bool box2d_clock_stands();

}  // namespace sensotwin::world
