// SPDX-License-Identifier: MIT
#include "twin/validate/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sensotwin::twin {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void add_bounds(std::vector<Threshold>& thresholds, Threshold asked, const std::optional<double>& min,
                const std::optional<double>& max) {
  if (min) {
    asked.upper = false;
    asked.limit = *min;
    thresholds.push_back(asked);
  }
  if (max) {
    asked.upper = true;
    asked.limit = *max;
    thresholds.push_back(asked);
  }
}

/// How far beyond the limit; negative inside. A value that does not exist is beyond everything.
double excess_of(const Threshold& asked, double value) {
  if (!std::isfinite(value)) {
    return std::numeric_limits<double>::infinity();
  }
  return asked.upper ? value - asked.limit : asked.limit - value;
}

Outcome by_interval(const Interval& interval, double limit, bool upper) {
  const auto inside = [&](double end) { return upper ? end <= limit : end >= limit; };
  if (inside(interval.low) && inside(interval.high)) {
    return Outcome::kKept;
  }
  return inside(interval.low) || inside(interval.high) ? Outcome::kOpen : Outcome::kMissed;
}

void judge_share(JudgedThreshold& judged, const JudgementOptions& options) {
  judged.estimate = static_cast<double>(judged.kept) / judged.seeds;
  judged.interval = rate_interval(judged.kept, judged.seeds, options.confidence, options.rates);
  if (judged.asked.measure == Measure::kEverySeed) {
    judged.outcome = judged.kept == judged.seeds ? Outcome::kKept : Outcome::kMissed;
  } else {
    judged.outcome = by_interval(judged.interval, judged.asked.share, false);
  }
}

void judge_statistic(JudgedThreshold& judged, std::vector<double> values, const JudgementOptions& options) {
  if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); })) {
    judged.outcome = Outcome::kMissed;
    return;
  }
  if (judged.asked.measure == Measure::kMean) {
    judged.estimate = mean_of(values);
    judged.interval = mean_interval(values, options.confidence);
  } else {
    std::sort(values.begin(), values.end());
    judged.estimate = quantile_of(values, judged.asked.share);
    judged.interval = quantile_interval(values, judged.asked.share, options.confidence);
  }
  judged.outcome = by_interval(judged.interval, judged.asked.limit, judged.asked.upper);
}

JudgedThreshold judge_one(const Threshold& asked, std::span<const RunOutcome> runs,
                          const JudgementOptions& options) {
  JudgedThreshold judged{.asked = asked, .seeds = static_cast<int>(runs.size())};
  const bool of_seeds = asked.measure == Measure::kEverySeed || asked.measure == Measure::kShare;
  std::vector<double> values;
  for (const RunOutcome& run : runs) {
    const double value = value_in(run, asked.figure);
    values.push_back(value);
    const bool kept = std::isfinite(value) && asked.kept_by(value);
    judged.kept += kept ? 1 : 0;
    if (!kept && of_seeds) {
      judged.failing.push_back({run.seed, value});
    }
    if (!judged.worst || excess_of(asked, value) > excess_of(asked, judged.worst->value)) {
      judged.worst = {run.seed, value};
    }
  }
  if (runs.empty()) {
    return judged;
  }
  if (of_seeds) {
    judge_share(judged, options);
  } else {
    judge_statistic(judged, std::move(values), options);
  }
  return judged;
}

/// The seeds from worst to best; none where all are alike and nothing is wrong.
std::vector<std::uint64_t> ranked(const JudgedThreshold& judged, std::span<const RunOutcome> runs) {
  std::vector<std::pair<double, std::uint64_t>> by_excess;
  for (const RunOutcome& run : runs) {
    by_excess.emplace_back(-excess_of(judged.asked, value_in(run, judged.asked.figure)), run.seed);
  }
  std::sort(by_excess.begin(), by_excess.end());
  std::vector<std::uint64_t> seeds;
  const bool alike = by_excess.empty() || by_excess.front().first == by_excess.back().first;
  if (!alike || judged.outcome != Outcome::kKept) {
    for (const auto& [excess, seed] : by_excess) {
      seeds.push_back(seed);
    }
  }
  return seeds;
}

}  // namespace

std::vector<Threshold> thresholds_of(const Scene& scene, double rate) {
  std::vector<Threshold> thresholds;
  for (const Expectation& expectation : scene.expect) {
    Threshold of_runs{.figure = expectation.name};
    of_runs.share = expectation.rate_min.value_or(rate);
    of_runs.measure = of_runs.share < 1.0 ? Measure::kShare : Measure::kEverySeed;
    add_bounds(thresholds, of_runs, expectation.min, expectation.max);
    for (std::size_t i = 0; i < kSeedStatistics.size(); ++i) {
      if (const std::optional<Bounds>& bounds = expectation.statistics[i]) {
        const SeedStatistic& statistic = kSeedStatistics[i];
        Threshold of_all{.figure = expectation.name, .statistic = std::string{statistic.key}};
        of_all.measure = statistic.quantile ? Measure::kQuantile : Measure::kMean;
        of_all.share = statistic.quantile.value_or(1.0);
        add_bounds(thresholds, of_all, bounds->min, bounds->max);
      }
    }
  }
  return thresholds;
}

std::vector<JudgedThreshold> judge_seeds(const Scene& scene, std::span<const RunOutcome> runs,
                                         const JudgementOptions& options) {
  std::vector<JudgedThreshold> judged;
  for (const Threshold& threshold : thresholds_of(scene, options.rate)) {
    judged.push_back(judge_one(threshold, runs, options));
  }
  return judged;
}

bool accepted(std::span<const JudgedThreshold> judged) {
  return std::all_of(judged.begin(), judged.end(),
                     [](const JudgedThreshold& j) { return j.outcome == Outcome::kKept; });
}

std::vector<std::uint64_t> worst_seeds(std::span<const JudgedThreshold> judged,
                                       std::span<const RunOutcome> runs, int count) {
  std::vector<std::vector<std::uint64_t>> lists;
  for (const bool kept : {false, true}) {
    for (const JudgedThreshold& j : judged) {
      if ((j.outcome == Outcome::kKept) == kept) {
        lists.push_back(ranked(j, runs));
      }
    }
  }
  std::vector<std::uint64_t> worst;
  for (std::size_t rank = 0; rank < runs.size(); ++rank) {
    for (const std::vector<std::uint64_t>& list : lists) {
      const bool wanted = rank < list.size() && static_cast<int>(worst.size()) < count;
      if (wanted && std::find(worst.begin(), worst.end(), list[rank]) == worst.end()) {
        worst.push_back(list[rank]);
      }
    }
  }
  return worst;
}

std::string sentence_of(const Threshold& threshold) {
  const std::string bound =
      fmt::format("{} at {} {}", threshold.figure, threshold.upper ? "most" : "least", threshold.limit);
  switch (threshold.measure) {
    case Measure::kEverySeed:
      return bound + " in every seed";
    case Measure::kShare:
      return bound + fmt::format(" in at least {:.6g} % of the seeds", 100.0 * threshold.share);
    case Measure::kMean:
    case Measure::kQuantile:
      break;
  }
  return threshold.statistic + " of " + bound;
}

std::string_view name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kKept:
      return "kept";
    case Outcome::kMissed:
      return "missed";
    case Outcome::kOpen:
      break;
  }
  return "open";
}

double value_in(const RunOutcome& run, const std::string& figure) {
  const auto found = run.figures.find(figure);
  return found == run.figures.end() ? kNaN : found->second;
}

}  // namespace sensotwin::twin
