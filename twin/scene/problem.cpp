// SPDX-License-Identifier: MIT
#include "twin/scene/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <tuple>
#include <utility>

namespace sensotwin::twin {
namespace {

/// Problems of options come after those of files; files stay in the order in which they were opened.
std::vector<Problem> sorted(std::vector<Problem> problems) {
  std::vector<std::string> files;
  const auto rank = [&files](const Problem& problem) {
    const auto known = std::find(files.begin(), files.end(), problem.place.source);
    if (problem.place.line != 0 && known == files.end()) {
      files.push_back(problem.place.source);
      return files.size() - 1;
    }
    return problem.place.line != 0 ? static_cast<std::size_t>(known - files.begin())
                                   : std::numeric_limits<std::size_t>::max();
  };
  using Keyed = std::pair<std::tuple<std::size_t, int, int>, Problem>;
  std::vector<Keyed> keyed;
  keyed.reserve(problems.size());
  for (Problem& problem : problems) {
    keyed.emplace_back(std::tuple{rank(problem), problem.place.line, problem.place.column},
                       std::move(problem));
  }
  std::stable_sort(keyed.begin(), keyed.end(),
                   [](const Keyed& a, const Keyed& b) { return a.first < b.first; });
  problems.clear();
  for (Keyed& next : keyed) {
    if (problems.size() < SceneError::kProblemsMax) {
      problems.push_back(std::move(next.second));
    }
  }
  return problems;
}

std::string joined(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    text += (text.empty() ? "" : "\n") + problem.text();
  }
  return text;
}

/// Edits between two words: insert, delete, replace, or swap neighbours (optimal string alignment).
std::size_t edits(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1, 0));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] =
          std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string Place::text() const {
  return line == 0 ? source : fmt::format("{}:{}:{}", source, line, column);
}

std::string Problem::text() const {
  std::string line = place.text() + ": error: ";
  if (!path.empty()) {
    line += path + ": ";
  }
  line += what;
  return hint.empty() ? line : line + "; " + hint;
}

SceneError::SceneError(std::vector<Problem> problems, int exit_code)
    : std::runtime_error(joined(sorted(problems))),
      problems_(sorted(std::move(problems))),
      exit_code_(exit_code) {
  assert(!problems_.empty());
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  // A long word compares in quadratic time and is no slip of the finger.
  constexpr std::size_t kWordMax = 64;
  if (word.size() > kWordMax) {
    return "";
  }
  std::size_t best_edits = std::max<std::size_t>(1, word.size() / 3) + 1;
  const std::string* best = nullptr;
  for (const std::string& candidate : candidates) {
    const std::size_t count = edits(word, candidate);
    if (count < best_edits) {
      best_edits = count;
      best = &candidate;
    }
  }
  return best == nullptr ? "" : fmt::format(" (did you mean '{}'?)", *best);
}

}  // namespace sensotwin::twin
