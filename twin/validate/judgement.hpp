// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "twin/scene/scene.hpp"
#include "twin/validate/intervals.hpp"
#include "twin/validate/run_once.hpp"

namespace sensotwin::twin {

enum class Measure : std::uint8_t {
  kEverySeed,  ///< each seed must keep the limit
  kShare,      ///< a share of the seeds must, with confidence
  kMean,       ///< the mean over the seeds must, with confidence
  kQuantile,   ///< a quantile must, with confidence
};

/// One limit of one figure, inclusive.
struct Threshold {
  std::string figure;
  Measure measure{Measure::kEverySeed};
  std::string statistic{};  ///< of kMean and kQuantile: its key in the scene
  double share{1.0};        ///< of kShare: wanted; of kQuantile: which
  bool upper{true};         ///< limit is a maximum, else a minimum
  double limit{0.0};

  [[nodiscard]] bool kept_by(double value) const { return upper ? value <= limit : value >= limit; }
};

enum class Outcome : std::uint8_t {
  kKept,
  kMissed,
  kOpen,  ///< the interval holds the limit: more seeds would tell. Not accepted
};

struct SeedValue {
  std::uint64_t seed{0};
  double value{0.0};
};

struct JudgedThreshold {
  Threshold asked;
  int seeds{0};
  int kept{0};  ///< seeds whose own value keeps the limit
  /// Of kEverySeed and kShare: the share that keeps the limit; else the statistic. NaN without a seed, or
  /// where a seed has no such figure.
  double estimate{std::numeric_limits<double>::quiet_NaN()};
  Interval interval{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Outcome outcome{Outcome::kOpen};
  std::vector<SeedValue> failing{};  ///< of kEverySeed and kShare: seeds that miss the limit, ascending
  std::optional<SeedValue> worst{};  ///< nearest to the limit or farthest beyond; the first of equals
};

struct JudgementOptions {
  double confidence{0.95};
  RateMethod rates{RateMethod::kClopperPearson};
  /// Share of the seeds that must keep `min` and `max` where the scene states no rate of its own.
  double rate{1.0};
};

/// Every bound of the scene's `expect:`, in its order; of one figure min before max, each run's before the
/// statistics'.
[[nodiscard]] std::vector<Threshold> thresholds_of(const Scene& scene, double rate);

/// Judges all thresholds of the scene.
///
/// kEverySeed is kept when no seed misses. The others are kept when the whole interval keeps what is asked,
/// missed when none of it does, open otherwise. A seed whose figure does not exist or is not finite misses
/// every threshold of that figure. \param runs  ascending by seed
[[nodiscard]] std::vector<JudgedThreshold> judge_seeds(const Scene& scene, std::span<const RunOutcome> runs,
                                                       const JudgementOptions& options);

/// All kept.
[[nodiscard]] bool accepted(std::span<const JudgedThreshold> judged);

/// The seeds that most deserve a look, at most `count`: the worst of each threshold, missed ones first, then
/// the next worst of each, and so on. A threshold that all seeds keep with the same value names none.
[[nodiscard]] std::vector<std::uint64_t> worst_seeds(std::span<const JudgedThreshold> judged,
                                                     std::span<const RunOutcome> runs, int count);

/// "minutes at most 5 in every seed", "minutes at most 5 in at least 95 % of the seeds", "median of minutes
/// at most 4.2".
[[nodiscard]] std::string sentence_of(const Threshold& threshold);
/// "kept", "missed", "open".
[[nodiscard]] std::string_view name_of(Outcome outcome);
/// The seed's figure; NaN when it has none.
[[nodiscard]] double value_in(const RunOutcome& run, const std::string& figure);

}  // namespace sensotwin::twin
