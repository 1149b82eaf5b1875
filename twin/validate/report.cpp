// SPDX-License-Identifier: MIT
#include "twin/validate/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace sensotwin::twin {
namespace {

using Json = nlohmann::ordered_json;

/// Chosen: enough to start with, few enough to see the table above them.
constexpr std::size_t kCommandsShown = 3;

/// Safe for every POSIX shell: bare when nothing in it could mean something.
std::string for_shell(const std::string& word) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view{"_-./=,:+@%"}.find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) {
    return word;
  }
  std::string quoted = "'";
  for (const char c : word) {
    quoted += c == '\'' ? std::string{"'\\''"} : std::string{c};
  }
  return quoted + "'";
}

bool is_share(const JudgedThreshold& judged) {
  return judged.asked.measure == Measure::kEverySeed || judged.asked.measure == Measure::kShare;
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::string_view key_of(Measure measure) {
  switch (measure) {
    case Measure::kEverySeed:
      return "every_seed";
    case Measure::kShare:
      return "rate";
    case Measure::kMean:
      return "mean";
    case Measure::kQuantile:
      break;
  }
  return "quantile";
}

Json json_of(const Validation& validation, const JudgedThreshold& judged) {
  Json json{{"name", sentence_of(judged.asked)},
            {"figure", judged.asked.figure},
            {"measure", key_of(judged.asked.measure)},
            {"bound", judged.asked.upper ? "max" : "min"},
            {"limit", number(judged.asked.limit)}};
  if (judged.asked.measure == Measure::kShare || judged.asked.measure == Measure::kQuantile) {
    json["share"] = number(judged.asked.share);
  }
  json["outcome"] = name_of(judged.outcome);
  json["ok"] = judged.outcome == Outcome::kKept;
  json["seeds"] = judged.seeds;
  json["kept"] = judged.kept;
  json["estimate"] = number(judged.estimate);
  json["interval"] = {{"low", number(judged.interval.low)}, {"high", number(judged.interval.high)}};
  json["worst"] = nullptr;
  if (judged.worst) {
    json["worst"] = {{"seed", judged.worst->seed}, {"value", number(judged.worst->value)}};
  }
  json["failing"] = Json::array();
  for (const SeedValue& failing : judged.failing) {
    json["failing"].push_back({{"seed", failing.seed},
                               {"value", number(failing.value)},
                               {"command", rerun_command(validation, failing.seed)}});
  }
  return json;
}

/// Least, median, most and mean of every figure that exists in all runs.
Json spread_of(const Validation& validation) {
  Json figures = Json::object();
  if (validation.runs.empty()) {
    return figures;
  }
  for (const auto& [name, first] : validation.runs.front().figures) {
    std::vector<double> values;
    for (const RunOutcome& run : validation.runs) {
      values.push_back(value_in(run, name));
    }
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) {
      continue;
    }
    std::sort(values.begin(), values.end());
    figures[name] = {{"min", values.front()},
                     {"median", quantile_of(values, 0.5)},
                     {"max", values.back()},
                     {"mean", mean_of(values)}};
  }
  return figures;
}

/// Figures that have a bound below which no estimator gets, and its name.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kBounded{
    {{"rmse_m", "bound_m"},
     {"rmse_first_half_m", "bound_first_half_m"},
     {"rmse_second_half_m", "bound_second_half_m"}}};

/// A line for each figure judged that has a bound.
std::string bounds_text(const Validation& validation) {
  std::string text;
  for (const auto& [figure, bound] : kBounded) {
    const bool judged =
        std::any_of(validation.judged.begin(), validation.judged.end(),
                    [name = figure](const JudgedThreshold& j) { return j.asked.figure == name; });
    if (judged && !validation.runs.empty()) {
      const double bound_m = value_in(validation.runs.front(), std::string{bound});
      if (std::isfinite(bound_m)) {
        text += fmt::format("{:<7} {}: posterior Cramer-Rao, {:.4g}\n", "bound", figure, bound_m);
      }
    }
  }
  return text;
}

std::string failing_text(const Validation& validation, const JudgedThreshold& judged) {
  std::vector<std::uint64_t> seeds;
  for (const SeedValue& failing : judged.failing) {
    seeds.push_back(failing.seed);
  }
  std::string text = fmt::format("\n{}: missed by {} {}\n", sentence_of(judged.asked),
                                 seeds.size() == 1 ? "seed" : "seeds", seeds_text(seeds));
  for (std::size_t i = 0; i < std::min(seeds.size(), kCommandsShown); ++i) {
    text += fmt::format("  {}\n", rerun_command(validation, seeds[i]));
  }
  return text;
}

}  // namespace

std::string_view verdict_of(const Validation& validation) {
  if (!validation.complete()) {
    return "interrupted";
  }
  return accepted(validation.judged) ? "accepted" : "not_accepted";
}

std::string seeds_text(const std::vector<std::uint64_t>& seeds) {
  std::string text;
  for (std::size_t i = 0; i < seeds.size();) {
    std::size_t end = i + 1;
    while (end < seeds.size() && seeds[end] == seeds[end - 1] + 1) {
      ++end;
    }
    text += fmt::format("{}{}", text.empty() ? "" : ", ", seeds[i]);
    if (end - i > 1) {
      text += fmt::format("..{}", seeds[end - 1]);
    }
    i = end;
  }
  return text;
}

std::string interval_text(const JudgedThreshold& judged) {
  const double scale = is_share(judged) ? 100.0 : 1.0;
  const double low = scale * judged.interval.low;
  const double high = scale * judged.interval.high;
  if (!std::isfinite(low) && !std::isfinite(high)) {
    return "unknown";
  }
  if (!std::isfinite(low) || !std::isfinite(high)) {
    return std::isfinite(low) ? fmt::format("above {:.4g}", low) : fmt::format("below {:.4g}", high);
  }
  return fmt::format("{:.4g} to {:.4g}{}", low, high, is_share(judged) ? " %" : "");
}

std::string estimate_text(const JudgedThreshold& judged) {
  return is_share(judged) ? fmt::format("{} of {}", judged.kept, judged.seeds)
                          : fmt::format("{:.4g}", judged.estimate);
}

std::string rerun_command(const Validation& validation, std::uint64_t seed) {
  std::string command = fmt::format("twin run {} --seed {}", for_shell(validation.scene), seed);
  if (!validation.variant.empty()) {
    command += " --variant " + for_shell(validation.variant);
  }
  for (const std::string& change : validation.set) {
    command += " --set " + for_shell(change);
  }
  return command;
}

std::string to_table(const Validation& validation) {
  std::string text = fmt::format("{}: {} of {} seeds ({}), intervals at {:.6g} %\n", validation.name,
                                 validation.runs.size(), validation.seeds.size(),
                                 seeds_text(validation.seeds), 100.0 * validation.options.confidence);
  std::size_t width = 5;
  for (const JudgedThreshold& judged : validation.judged) {
    width = std::max(width, sentence_of(judged.asked).size());
  }
  if (!validation.judged.empty()) {
    text += fmt::format("{:<7} {:<{}}  {:>12}  {:<18}  {:>9}  {}\n", "", "asked", width, "found", "interval",
                        "worst", "seed");
  }
  for (const JudgedThreshold& judged : validation.judged) {
    text += fmt::format("{:<7} {:<{}}  {:>12}  {:<18}",
                        judged.outcome == Outcome::kMissed ? "MISSED" : name_of(judged.outcome),
                        sentence_of(judged.asked), width, estimate_text(judged), interval_text(judged));
    if (judged.worst) {
      text += fmt::format("  {:>9.5g}  {}", judged.worst->value, judged.worst->seed);
    }
    text += "\n";
  }
  text += bounds_text(validation);
  for (const JudgedThreshold& judged : validation.judged) {
    if (!judged.failing.empty()) {
      text += failing_text(validation, judged);
    }
  }
  return text + fmt::format("verdict {}\n", verdict_of(validation));
}

std::string to_json(const Validation& validation) {
  Json json{{"scene", validation.scene},
            {"variant", validation.variant},
            {"set", validation.set},
            {"scene_hash", validation.scene_hash},
            {"seeds", seeds_text(validation.seeds)},
            {"seeds_asked", validation.seeds.size()},
            {"seeds_done", validation.runs.size()},
            {"verdict", verdict_of(validation)},
            {"confidence", validation.options.confidence},
            {"rate_method", validation.options.rates == RateMethod::kWilson ? "wilson" : "clopper-pearson"}};
  json["expect"] = Json::array();
  for (const JudgedThreshold& judged : validation.judged) {
    json["expect"].push_back(json_of(validation, judged));
  }
  json["worst_seeds"] = validation.worst;
  json["figures"] = spread_of(validation);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sensotwin::twin
