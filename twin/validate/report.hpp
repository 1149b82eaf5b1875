// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "twin/validate/judgement.hpp"

namespace sensotwin::twin {

/// A validation and what it came to. Nothing in it depends on threads, time or machine.
struct Validation {
  std::string scene;                 ///< as given on the command line
  std::string name;                  ///< of the scene
  std::string scene_hash;            ///< scene_hash_of()
  std::string variant;               ///< of the scene; empty: none
  std::vector<std::string> set;      ///< "key.path=value", as given
  std::vector<std::uint64_t> seeds;  ///< asked for, ascending
  std::vector<RunOutcome> runs;      ///< done, ascending
  JudgementOptions options;
  std::vector<JudgedThreshold> judged;  ///< over `runs`
  std::vector<std::uint64_t> worst;     ///< worst_seeds()

  [[nodiscard]] bool complete() const { return runs.size() == seeds.size(); }
};

/// "accepted", "not_accepted", or "interrupted" while a seed is missing.
[[nodiscard]] std::string_view verdict_of(const Validation& validation);

/// "1..200", "3, 7..9".
[[nodiscard]] std::string seeds_text(const std::vector<std::uint64_t>& seeds);
/// "2.98 to 3.41", "98.2 to 100 %" for a share, "above 3" and the like for one end.
[[nodiscard]] std::string interval_text(const JudgedThreshold& judged);
/// "200 of 200", "3.21": the estimate.
[[nodiscard]] std::string estimate_text(const JudgedThreshold& judged);
/// The command that repeats one seed, to be pasted into a shell.
[[nodiscard]] std::string rerun_command(const Validation& validation, std::uint64_t seed);

/// For people: a line for each threshold, failing seeds with the commands that repeat the first few, the
/// verdict.
[[nodiscard]] std::string to_table(const Validation& validation);
/// report.json. Keys in a fixed order; what is not finite is null; ends in a line feed.
[[nodiscard]] std::string to_json(const Validation& validation);

}  // namespace sensotwin::twin
