// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "twin/scene/scene.hpp"
#include "twin/validate/run_once.hpp"

namespace sensotwin::twin {

/// What a row of seeds.csv is a result of. Rows of other origins never mix.
struct Origin {
  std::string scene_hash;    ///< scene_hash_of()
  std::string program_hash;  ///< of the running program's file
  friend bool operator==(const Origin&, const Origin&) = default;
};

/// Fingerprint of everything in a scene that decides how its runs go: all fields but the seed, the title and
/// what is expected, and the floor that an imported map came to. So thresholds may change while runs stay.
[[nodiscard]] std::string scene_hash_of(const Scene& scene);
/// Fingerprint of a file's bytes; empty when it cannot be read.
[[nodiscard]] std::string file_hash_of(const std::filesystem::path& file);

/// Runs by seed.
using SeedTable = std::map<std::uint64_t, RunOutcome>;

/// A seeds.csv that cannot be gone on with. what() is "file:line: reason".
class SeedTableError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// seed, scene_hash, program_hash, state_hash, then every figure, ascending by seed. Numbers read back to the
/// same bits; a figure that is not finite is an empty cell.
[[nodiscard]] std::string to_csv(const SeedTable& table, const Origin& origin);
/// \param file  for messages  \throws SeedTableError: not of this form, or a row of another origin
[[nodiscard]] SeedTable seed_table_from(std::string_view csv, const Origin& origin, const std::string& file);

/// The runs of `seeds` that are there, in that order.
[[nodiscard]] std::vector<RunOutcome> runs_of(const SeedTable& table,
                                              const std::vector<std::uint64_t>& seeds);

}  // namespace sensotwin::twin
