// SPDX-License-Identifier: MIT
// Equal runs are equal to the last byte, whatever surrounds them.
#include <gtest/gtest.h>

#include <string>
#include <thread>

#include "mapping_case.hpp"

namespace sensotwin::twin {
namespace {

// Every bit of every tick of scenes/lesson_2x2.yaml. Changing it means that the twin's physics, devices or
// robot behave differently: say in the commit's message what and why, in a sentence.
constexpr const char* kLessonHash = "61e58bef94b2ef31";

TEST(Determinism, LessonKeepsItsGoldenHash) {
  const std::string hash = run_of(published("lesson_2x2")).state_hash;
  EXPECT_EQ(hash, kLessonHash) << "The new one is " << hash << ". Was the change meant?";
}

TEST(Determinism, EqualRunsLeaveByteIdenticalFoldersPicturesIncluded) {
  const TemporaryFolder folder;
  const Scene scene = published("lesson_2x2");
  (void)run_into(folder / "one", scene, true);
  (void)run_into(folder / "two", scene, true);
  const auto one = files_in(folder / "one");
  const auto two = files_in(folder / "two");
  ASSERT_EQ(one.size(), two.size());
  EXPECT_GE(one.count("floorplan.png") + one.count("progress.png") + one.count("tags_over_time.png"), 3u);
  for (const auto& [name, bytes] : one) {
    ASSERT_TRUE(two.contains(name)) << name;
    EXPECT_TRUE(two.at(name) == bytes) << name << " differs";
  }
}

TEST(Determinism, EqualRunsOfTheHouseLeaveEqualTracesEventsAndMaps) {
  const TemporaryFolder folder;
  const Scene scene = published("house");
  (void)run_into(folder / "one", scene);
  (void)run_into(folder / "two", scene);
  EXPECT_TRUE(files_in(folder / "one") == files_in(folder / "two"));
}

TEST(Determinism, ARunDoesNotDependOnWhatRanBefore) {
  const std::string alone = run_of(published("lesson_2x2")).state_hash;
  (void)run_of(published("house", {"time_limit_s=300"}));
  EXPECT_EQ(run_of(published("lesson_2x2")).state_hash, alone);
}

TEST(Determinism, TwoRunsInTwoThreadsEqualASingleOne) {
  const Scene scene = published("house", {"time_limit_s=600"});
  const Scene other = published("lesson_2x2");
  const std::string alone = run_of(scene).state_hash;
  const std::string other_alone = run_of(other).state_hash;
  std::string beside;
  std::string other_beside;
  std::thread first([&] { beside = run_of(scene).state_hash; });
  std::thread second([&] { other_beside = run_of(other).state_hash + " " + run_of(scene).state_hash; });
  first.join();
  second.join();
  EXPECT_EQ(beside, alone);
  EXPECT_EQ(other_beside, other_alone + " " + alone);
}

TEST(Determinism, AnotherSeedIsAnotherRun) {
  EXPECT_NE(run_of(published("lesson_2x2", {}, 8)).state_hash, run_of(published("lesson_2x2")).state_hash);
}

}  // namespace
}  // namespace sensotwin::twin
