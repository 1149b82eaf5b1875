// SPDX-License-Identifier: MIT
#include "twin/validate/seed_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <iterator>
#include <mutex>

#include "twin/run/scene_bound.hpp"
#include "twin/study/parallel.hpp"

namespace sensotwin::twin {
namespace {

/// The scratch folder goes with the validation, however it ends.
class Scratch {
 public:
  explicit Scratch(const std::filesystem::path& path) : path_(path) { remove(); }
  ~Scratch() { remove(); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

 private:
  void remove() const {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path_;
};

}  // namespace

bool run_seeds(const Scene& scene, const SeedRunsOptions& options, SeedTable& table) {
  std::vector<std::uint64_t> missing;
  std::copy_if(options.seeds.begin(), options.seeds.end(), std::back_inserter(missing),
               [&](std::uint64_t seed) { return !table.contains(seed); });
  int there = static_cast<int>(options.seeds.size() - missing.size());
  const Scratch scratch(options.scratch);
  std::atomic<bool> failed{false};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto go_on = [&] { return !failed && (!options.keep_going || options.keep_going()); };
  // The same for every seed: found once.
  std::optional<BoundResult> bound;
  if (scene.mission.phase && scene.mission.phase->controller == PhaseController::kOwn && !missing.empty()) {
    if (const auto found = bound_of(scene)) {
      bound = figures_of(*found);
    }
  }
  const auto run_one = [&](int index) {
    const std::uint64_t seed = missing[static_cast<std::size_t>(index)];
    const std::filesystem::path folder = options.scratch / fmt::format("seed_{}", seed);
    try {
      const auto outcome = run_once(
          scene, seed,
          {.folder = folder, .scene_as_given = options.scene_as_given, .bound = bound, .keep_going = go_on});
      std::error_code ignored;
      std::filesystem::remove_all(folder, ignored);
      const std::scoped_lock lock{mutex};
      if (outcome) {
        table[seed] = *outcome;
        ++there;
        if (options.ran) {
          options.ran(table, there);
        }
      }
    } catch (...) {
      const std::scoped_lock lock{mutex};
      failure = failed ? failure : std::current_exception();
      failed = true;
    }
  };
  (void)run_in_parallel(static_cast<int>(missing.size()), options.jobs, run_one,
                        [&](int, int) { return go_on(); });
  if (failure) {
    std::rethrow_exception(failure);
  }
  return there == static_cast<int>(options.seeds.size());
}

}  // namespace sensotwin::twin
