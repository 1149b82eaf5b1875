// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <thread>

#include "twin/study/epsilon_study.hpp"

namespace sensotwin::twin {
namespace {

int all_processors() {
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

TEST(EpsilonSurface, AgreesWithEquationTwoOver96000Rooms) {
  const EpsilonStudy study = *run_epsilon_study({.maps_per_cell = 1000, .jobs = all_processors()});
  const ExplorerEpsilon& idfm = study.explorers.front();
  EXPECT_NEAR(idfm.paper_fit.per_blocked_percent, 0.0765, 0.1 * 0.0765);
  EXPECT_NEAR(idfm.paper_fit.per_chunk, 0.4869, 0.1 * 0.4869);
  EXPECT_NEAR(idfm.paper_fit.constant, -0.3437, 0.2);
  EXPECT_LT(idfm.worst_paper_cell().paper.mean_percent, 11.0);
  // What the paper's counting leaves out: the tags driven over on the way back. A quarter of all moves.
  EXPECT_NEAR(idfm.mean_physical_percent(), 23.9, 0.5);
}

TEST(EpsilonSurface, OfSweepStaysUnderItsGoals) {
  const EpsilonStudy study = *run_epsilon_study(
      {.explorers = {robot::ExplorerKind::kSweep}, .maps_per_cell = 30, .jobs = all_processors()});
  EXPECT_LE(study.explorers.front().mean_physical_percent(), 6.0);
  EXPECT_LE(study.explorers.front().worst_physical_cell().physical.mean_percent, 17.0);
}

}  // namespace
}  // namespace sensotwin::twin
