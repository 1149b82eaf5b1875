// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "twin/output/summary.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// What one run came to: all that a validation knows of it.
struct RunOutcome {
  std::uint64_t seed{0};
  Figures figures;  ///< by name, as `expect:` asks for them
  std::string state_hash;
};

struct RunRequest {
  std::filesystem::path folder;  ///< made for the run, or files in it replaced
  std::string scene_as_given{};  ///< as the run's summary.json names it
  bool pictures{false};
  std::optional<BoundResult> bound{};  ///< of the scene, when it is known: the same for every seed
  /// Asked a few hundred times a simulated hour; false ends the run. Of any thread. Empty: goes on
  std::function<bool()> keep_going{};
};

/// The one seam between a validation and what it validates: runs `scene` from `seed` once, whatever its
/// mission, as `twin run --seed` does, to the bit. Runs in several threads do not touch each other. \returns
/// nothing when `keep_going` ended it  \throws OutputError
[[nodiscard]] std::optional<RunOutcome> run_once(const Scene& scene, std::uint64_t seed,
                                                 const RunRequest& request);

}  // namespace sensotwin::twin
