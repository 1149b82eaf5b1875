// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "twin/scene/scene.hpp"
#include "twin/validate/seed_table.hpp"

namespace sensotwin::twin {

struct SeedRunsOptions {
  std::vector<std::uint64_t> seeds;  ///< ascending, each once
  int jobs{1};                       ///< threads; the table does not depend on their number
  std::filesystem::path scratch;     ///< a folder for what runs leave behind, removed at the end
  std::string scene_as_given;        ///< as the summaries of runs name it
  /// False ends everything within a fraction of a second; runs that are not done are dropped. Asked by every
  /// thread. Empty: goes on
  std::function<bool()> keep_going;
  /// Called after each run, one call at a time, with the table so far and the number of `seeds` in it.
  std::function<void(const SeedTable&, int)> ran;
};

/// Runs the seeds that `table` lacks and adds them. \returns whether all are there
/// \throws what a run throws, once all threads have come to rest; what was done stays in the table
[[nodiscard]] bool run_seeds(const Scene& scene, const SeedRunsOptions& options, SeedTable& table);

}  // namespace sensotwin::twin
