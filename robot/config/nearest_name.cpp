// SPDX-License-Identifier: MIT
#include "robot/config/nearest_name.hpp"

#include <algorithm>
#include <cstddef>

namespace sensotwin::robot {
namespace {

/// Insertions, deletions, changes and swaps of neighbours between two words (optimal string alignment).
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      const std::size_t change = cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
      }
    }
  }
  return cost[a.size()][b.size()];
}

}  // namespace

std::string did_you_mean(std::string_view given, const std::vector<std::string>& names) {
  // A long word compares in quadratic time and is no slip of the finger.
  constexpr std::size_t kLettersMax = 64;
  if (given.size() > kLettersMax) {
    return "";
  }
  const std::string* nearest = nullptr;
  std::size_t fewest = 0;
  for (const std::string& name : names) {
    const std::size_t edits = edits_between(given, name);
    if (3 * edits <= std::max(given.size(), name.size()) && (nearest == nullptr || edits < fewest)) {
      nearest = &name;
      fewest = edits;
    }
  }
  return nearest == nullptr ? "" : " (did you mean '" + *nearest + "'?)";
}

}  // namespace sensotwin::robot
