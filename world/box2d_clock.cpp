// SPDX-License-Identifier: MIT
#include "world/box2d_clock.hpp"

#include <box2d/b2_timer.h>
#include <box2d/b2_world.h>

// All that the library defines of b2Timer; nothing in a step depends on what it says.
b2Timer::b2Timer() {
  Reset();
}
void b2Timer::Reset() {
  m_start_sec = 0;
  m_start_usec = 0;
}
float b2Timer::GetMilliseconds() const {
  return 0.0F;
}

namespace sensotwin::world {

bool box2d_clock_stands() {
  constexpr float kStep_s = 0.005F;
  b2World empty(b2Vec2{0.0F, 0.0F});
  empty.Step(kStep_s, 1, 1);
  return empty.GetProfile().step == 0.0F;
}

}  // namespace sensotwin::world
