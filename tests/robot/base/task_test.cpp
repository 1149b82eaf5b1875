// SPDX-License-Identifier: MIT
#include "robot/base/task.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace sensotwin::robot {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Words = std::vector<std::string>;

Task<> say_and_wait(StepSignal& step, Words& said, std::string name, int steps) {
  for (int i = 1; i <= steps; ++i) {
    said.push_back(name + std::to_string(i));
    co_await step;
  }
}

Task<> one_after_the_other(StepSignal& step, Words& said) {
  co_await say_and_wait(step, said, "turn", 2);
  said.emplace_back("between");
  co_await say_and_wait(step, said, "roll", 1);
  said.emplace_back("end");
}

TEST(ABehaviour, DoesNothingBeforeItIsStarted) {
  StepSignal step;
  Words said;
  const Task<> task = one_after_the_other(step, said);
  step.resume();
  EXPECT_THAT(said, IsEmpty());
}

TEST(ABehaviour, RunsFromWaitToWaitInTheOrderItIsWritten) {
  StepSignal step;
  Words said;
  Task<> task = one_after_the_other(step, said);
  task.start();
  EXPECT_THAT(std::exchange(said, {}), ElementsAre("turn1"));
  step.resume();
  EXPECT_THAT(std::exchange(said, {}), ElementsAre("turn2"));
  step.resume();
  EXPECT_THAT(std::exchange(said, {}), ElementsAre("between", "roll1"))
      << "no step is lost between two behaviours";
  EXPECT_FALSE(task.done());
  step.resume();
  EXPECT_THAT(std::exchange(said, {}), ElementsAre("end"));
  EXPECT_TRUE(task.done());
}

TEST(ABehaviour, IsNotDisturbedByStepsAfterItsEnd) {
  StepSignal step;
  Words said;
  Task<> task = say_and_wait(step, said, "roll", 1);
  task.start();
  step.resume();
  ASSERT_TRUE(task.done());
  step.resume();
  EXPECT_THAT(said, ElementsAre("roll1"));
}

Task<int> count_down(StepSignal& step, int n) {
  if (n == 0) {
    co_return 0;
  }
  co_await step;
  const int rest = co_await count_down(step, n - 1);
  co_return rest + 1;
}

Task<> keep(Task<int> task, std::optional<int>& result) {
  result = co_await std::move(task);
}

TEST(NestedBehaviours, HandTheirResultsUp) {
  StepSignal step;
  std::optional<int> result;
  Task<> task = keep(count_down(step, 5), result);
  task.start();
  for (int i = 0; i < 5; ++i) {
    EXPECT_FALSE(result.has_value());
    step.resume();
  }
  EXPECT_EQ(result, 5);
  EXPECT_TRUE(task.done());
}

Task<int> known_at_once() {
  co_return 7;
}

TEST(NestedBehaviours, MayEndWithoutWaiting) {
  std::optional<int> result;
  Task<> task = keep(known_at_once(), result);
  task.start();
  EXPECT_EQ(result, 7);
}

Task<std::unique_ptr<int>> bring() {
  co_return std::make_unique<int>(3);
}
Task<> unwrap(int& result) {
  const std::unique_ptr<int> brought = co_await bring();
  result = *brought;
}

TEST(NestedBehaviours, HandUpWhatCanOnlyBeMoved) {
  int result = 0;
  Task<> task = unwrap(result);
  task.start();
  EXPECT_EQ(result, 3);
}

/// Counts how many of its kind are alive.
class Counted {
 public:
  explicit Counted(int& alive) : alive_(&alive) { ++*alive_; }
  Counted(const Counted& other) : alive_(other.alive_) { ++*alive_; }
  Counted& operator=(const Counted&) = delete;
  ~Counted() { --*alive_; }

 private:
  int* alive_;
};

/// Each level keeps one in its frame; the innermost waits for ever.
Task<> descend(StepSignal& step, int& alive, int levels) {
  const Counted local{alive};
  if (levels > 1) {
    co_await descend(step, alive, levels - 1);
  }
  for (;;) {
    co_await step;
  }
}

TEST(ABehaviourDestroyedInMidWait, FreesEveryLevelOfItsStack) {
  int alive = 0;
  StepSignal step;
  {
    Task<> task = descend(step, alive, 4);
    task.start();
    step.resume();
    EXPECT_EQ(alive, 4);
  }
  EXPECT_EQ(alive, 0);
}

Task<> wait_with(StepSignal& step, Counted) {
  co_await step;
}

TEST(ABehaviour, FreesItsArgumentsEvenIfItIsNeverStarted) {
  int alive = 0;
  StepSignal step;
  {
    const Task<> task = wait_with(step, Counted{alive});
    EXPECT_EQ(alive, 1);
  }
  EXPECT_EQ(alive, 0);
}

Task<> wait_twice(StepSignal& step, int& alive) {
  co_await wait_with(step, Counted{alive});
  co_await step;
}

TEST(ABehaviour, FreesWhatEndedAsSoonAsItEnded) {
  int alive = 0;
  StepSignal step;
  Task<> task = wait_twice(step, alive);
  task.start();
  EXPECT_GE(alive, 1);
  step.resume();
  EXPECT_FALSE(task.done());
  EXPECT_EQ(alive, 0) << "the inner one's frame is gone while the outer one still waits";
}

TEST(ABehaviour, GoesOnWhenItsTaskWasMoved) {
  StepSignal step;
  Words said;
  Task<> first = say_and_wait(step, said, "roll", 2);
  first.start();
  Task<> second = std::move(first);
  step.resume();
  EXPECT_THAT(said, ElementsAre("roll1", "roll2"));
  step.resume();
  EXPECT_TRUE(second.done());
}

}  // namespace
}  // namespace sensotwin::robot
