// SPDX-License-Identifier: MIT
#include "twin/serve/pacer.hpp"

#include <algorithm>

namespace sensotwin::twin {
namespace {

constexpr double kTick_s = robot::to_s(robot::kTick);
/// What is caught up. Chosen: a scheduler's hiccup, below what clients take for a dead line (100 ms).
constexpr double kCaughtUp_s = 0.05;
constexpr double kWindow_s = 1.0;

}  // namespace

Pacer::Pacer(std::optional<double> factor, double wall_s)
    : factor_(factor), due_s_(wall_s), last_s_(wall_s), window_begun_s_(wall_s) {}

double Pacer::wait_s(double wall_s, bool client_follows) const {
  if (factor_) {
    return std::max(0.0, due_s_ - wall_s);
  }
  const double due_s = last_s_ + (client_follows ? kTick_s / kFastestFactor : kTick_s);
  return std::max(0.0, due_s - wall_s);
}

void Pacer::tick(double wall_s) {
  last_s_ = wall_s;
  if (factor_) {
    const double late_s = wall_s - due_s_;
    if (late_s > kCaughtUp_s) {
      given_up_s_ += late_s;
      due_s_ = wall_s;
    }
    due_s_ += kTick_s / *factor_;
  }
  ++window_ticks_;
  if (wall_s - window_begun_s_ >= kWindow_s) {
    achieved_ = static_cast<double>(window_ticks_) * kTick_s / (wall_s - window_begun_s_);
    window_begun_s_ = wall_s;
    window_ticks_ = 0;
  }
}

}  // namespace sensotwin::twin
