// SPDX-License-Identifier: MIT
#include "twin/validate/report_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/png_writer.hpp"
#include "robot/output/output_error.hpp"

namespace sensotwin::twin {
namespace {

render::Rgba color_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kKept:
      return render::palette::kGreen;
    case Outcome::kMissed:
      return render::palette::kVermilion;
    case Outcome::kOpen:
      break;
  }
  return render::palette::kOrange;
}

render::DistributionRow row_of(const JudgedThreshold& judged) {
  render::DistributionRow row;
  row.text = fmt::format("{}: {}, interval {}, {}", sentence_of(judged.asked), estimate_text(judged),
                         interval_text(judged), name_of(judged.outcome));
  row.color = color_of(judged.outcome);
  if (judged.asked.measure == Measure::kMean || judged.asked.measure == Measure::kQuantile) {
    row.interval = {judged.interval.low, judged.interval.high};
    row.estimate = judged.estimate;
    row.limit = judged.asked.limit;
  }
  return row;
}

render::DistributionLimit limit_of(const JudgedThreshold& judged) {
  const bool of_each = judged.asked.statistic.empty();
  return {.value = judged.asked.limit,
          .upper = judged.asked.upper,
          .of_each = of_each,
          .label = fmt::format("{}at {} {}", of_each ? "" : judged.asked.statistic + " ",
                               judged.asked.upper ? "most" : "least", judged.asked.limit),
          .color = of_each ? render::palette::kInk : render::palette::kSoftInk};
}

/// Judged figures that every run has, each once.
std::vector<std::string> drawable(const Validation& validation) {
  std::vector<std::string> figures;
  for (const JudgedThreshold& judged : validation.judged) {
    const std::string& name = judged.asked.figure;
    const bool known = std::find(figures.begin(), figures.end(), name) != figures.end();
    const bool everywhere =
        std::all_of(validation.runs.begin(), validation.runs.end(),
                    [&](const RunOutcome& run) { return std::isfinite(value_in(run, name)); });
    if (!known && everywhere && !validation.runs.empty()) {
      figures.push_back(name);
    }
  }
  return figures;
}

template <class T>
T drawn_or_throw(render::Rendered<T> result) {
  if (!result) {
    throw robot::OutputError(robot::ExitCode::kUnavailable, result.error().message);
  }
  return std::move(*result);
}

}  // namespace

render::DistributionChart distribution_of(const Validation& validation, const std::string& figure) {
  render::DistributionChart chart;
  chart.frame.title = fmt::format("{} over {} seeds", figure, validation.runs.size());
  chart.frame.subtitle = fmt::format("scene {} · seeds {} · intervals at {:.6g} %", validation.name,
                                     seeds_text(validation.seeds), 100.0 * validation.options.confidence);
  chart.frame.x.label = figure;
  chart.frame.y.label = "seeds";
  chart.frame.height_px = 800;
  for (const RunOutcome& run : validation.runs) {
    chart.values.push_back(value_in(run, figure));
  }
  for (const JudgedThreshold& judged : validation.judged) {
    if (judged.asked.figure == figure) {
      chart.rows.push_back(row_of(judged));
      chart.limits.push_back(limit_of(judged));
    }
  }
  return chart;
}

bool draw_distributions(const Validation& validation, robot::RunFolder& folder,
                        const std::function<bool()>& may_go_on) {
  for (const std::string& figure : drawable(validation)) {
    if (!may_go_on()) {
      return false;
    }
    const auto chart = drawn_or_throw(render::draw(distribution_of(validation, figure)));
    render::PngText text;
    text.comment = fmt::format("scene {}, seeds {}", validation.name, seeds_text(validation.seeds));
    const auto bytes = drawn_or_throw(render::encode_png(chart.image, text));
    folder.write("distributions/" + figure + ".png",
                 {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  return true;
}

bool run_worst_again(const Scene& scene, const Validation& validation, const robot::RunFolder& folder,
                     const std::function<bool()>& may_go_on) {
  for (const std::uint64_t seed : validation.worst) {
    const auto again = run_once(scene, seed,
                                {.folder = folder.path() / "worst" / fmt::format("seed_{}", seed),
                                 .scene_as_given = validation.scene,
                                 .pictures = true,
                                 .keep_going = may_go_on});
    if (!again) {
      return false;
    }
    const auto before = std::find_if(validation.runs.begin(), validation.runs.end(),
                                     [seed](const RunOutcome& run) { return run.seed == seed; });
    if (before == validation.runs.end() || before->state_hash != again->state_hash) {
      throw std::logic_error(fmt::format("seed {} does not repeat itself: state hash {} became {}", seed,
                                         before == validation.runs.end() ? "?" : before->state_hash,
                                         again->state_hash));
    }
  }
  return true;
}

}  // namespace sensotwin::twin
