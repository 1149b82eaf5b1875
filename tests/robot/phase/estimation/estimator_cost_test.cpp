// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <new>

#include "tests/robot/phase/estimation/mission_runs.hpp"

namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) {
    return memory;
  }
  throw std::bad_alloc{};
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace sensotwin::robot::testing {
namespace {

TEST(EstimatorCost, StaysUnderFiftyMicrosecondsAStepAndAllocatesNothingInTheHallway) {
  // The project's goal for the mean over a run on one core.
  const PhaseExperiment experiment = hallway();
  CeilingMission mission{mission_for(experiment, {}, true)};
  KinematicRobot robot{experiment.tags, experiment.X_WR_start, {}, {}, 1};
  PhaseCommand command;
  std::chrono::nanoseconds spent{0};
  std::chrono::nanoseconds longest{0};
  long steps = 0;
  long allocated = 0;
  while (!mission.done() && to_s(robot.now()) < 400.0) {
    const PhaseSensed& sensed = robot.step(command);
    const long before = allocations;
    const auto begun = std::chrono::steady_clock::now();
    command = mission.step(sensed);
    const auto took = std::chrono::steady_clock::now() - begun;
    allocated += allocations - before;
    mission.forget_events();
    spent += took;
    longest = std::max<std::chrono::nanoseconds>(longest, took);
    ++steps;
  }
  ASSERT_TRUE(mission.arrived());
  const double mean_us = static_cast<double>(spent.count()) / 1000.0 / static_cast<double>(steps);
  std::cout << "estimator and follower: mean " << mean_us << " us a step, longest "
            << static_cast<double>(longest.count()) / 1000.0 << " us\n";
  EXPECT_LT(mean_us, 50.0);
  EXPECT_EQ(allocated, 0);
}

}  // namespace
}  // namespace sensotwin::robot::testing
