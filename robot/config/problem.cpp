// SPDX-License-Identifier: MIT
#include "robot/config/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <tuple>
#include <utility>

namespace sensotwin::robot {
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
    if (problems.size() < LoadError::kProblemsMax) {
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

LoadError::LoadError(std::vector<Problem> problems, int exit_code)
    : std::runtime_error(joined(sorted(problems))),
      problems_(sorted(std::move(problems))),
      exit_code_(exit_code) {
  assert(!problems_.empty());
}

}  // namespace sensotwin::robot
