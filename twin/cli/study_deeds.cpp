// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <thread>

#include "render/charts.hpp"
#include "render/mapping_pictures.hpp"
#include "robot/output/signals.hpp"
#include "twin/cli/deed_support.hpp"
#include "twin/cli/deeds.hpp"
#include "twin/study/epsilon_study.hpp"

namespace sensotwin::twin {
namespace {

nlohmann::json read_json(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) {
    throw CommandError(robot::ExitCode::kInputMissing,
                       fmt::format("{}: cannot be read; is this the folder of a run?", path.string()));
  }
  try {
    return nlohmann::json::parse(in);
  } catch (const nlohmann::json::exception& error) {
    throw CommandError(robot::ExitCode::kInvalidData, fmt::format("{}: {}", path.string(), error.what()));
  }
}

/// Times at which a run found its tags, from its events.
render::ExplorerRun found_in(const std::filesystem::path& folder, const std::string& explorer) {
  std::ifstream in(folder / "events.jsonl");
  if (!in) {
    throw CommandError(robot::ExitCode::kInputMissing,
                       fmt::format("{}: cannot be read", (folder / "events.jsonl").string()));
  }
  render::ExplorerRun run{explorer, {{0.0, 0.0}}};
  int line_number = 0;
  for (std::string line; std::getline(in, line);) {
    ++line_number;
    const auto event = nlohmann::json::parse(line, nullptr, false);
    if (event.is_discarded() || !event.contains("event") || !event.contains("t_s")) {
      throw CommandError(robot::ExitCode::kInvalidData,
                         fmt::format("{}:{}: no event", (folder / "events.jsonl").string(), line_number));
    }
    if (event["event"] == "tile_found") {
      run.found.push_back({event["t_s"].get<double>() / 60.0, static_cast<double>(run.found.size())});
    }
  }
  return run;
}

/// SensoBot's Figure 8, seen from above: the first explorer, the paper's counting.
render::HeatmapChart surface_of(const EpsilonStudy& study) {
  const ExplorerEpsilon& explorer = study.explorers.front();
  render::HeatmapChart chart;
  chart.frame.title =
      fmt::format("Superfluous visits of {}, as the paper counts", robot::name_of(explorer.explorer));
  chart.frame.subtitle =
      fmt::format("mean of {} rooms of 324 tags a cell · seed {} · fit {:.4f} Bp {:+.4f} Bd {:+.4f}",
                  study.options.maps_per_cell, study.options.seed, explorer.paper_fit.per_blocked_percent,
                  explorer.paper_fit.per_chunk, explorer.paper_fit.constant);
  chart.frame.x.label = "Bd, pieces of furniture";
  chart.frame.y.label = "Bp, blocked tags in per cent";
  chart.value_label = "epsilon in per cent";
  for (const EpsilonCell& cell : explorer.cells) {
    const std::string row = fmt::format("{}", cell.obstacles.blocked_percent);
    const std::string column = fmt::format("{}", cell.obstacles.chunks);
    if (chart.rows.empty() || chart.rows.back() != row) {
      chart.rows.push_back(row);
    }
    if (chart.rows.size() == 1) {
      chart.columns.push_back(column);
    }
    chart.values.push_back(cell.paper.mean_percent);
  }
  return chart;
}

}  // namespace

robot::ExitCode chart_deed(const ChartOptions& options, Context& context) {
  render::TagsOverTime chart;
  for (const std::filesystem::path& folder : options.runs) {
    const nlohmann::json summary = read_json(folder / "summary.json");
    try {
      const auto& map = summary.at("map");
      chart.scene = std::filesystem::path(summary.at("scene").get<std::string>()).stem().string();
      chart.seed = summary.at("seed").get<std::uint64_t>();
      chart.tags_total = std::max(chart.tags_total, map.at("tiles_mapped").get<int>());
      chart.runs.push_back(found_in(folder, map.at("explorer").get<std::string>()));
      // To the end of the mission: the way back is part of its minutes.
      auto& found = chart.runs.back().found;
      found.push_back({std::max(map.at("minutes").get<double>(), found.back().x), found.back().y});
    } catch (const nlohmann::json::exception& error) {
      throw CommandError(robot::ExitCode::kInvalidData,
                         fmt::format("{}: {}", (folder / "summary.json").string(), error.what()));
    }
  }
  chart.paper_marks = options.paper_marks;
  const auto drawn = drawn_or_throw(render::draw(render::tags_over_time_chart(chart)));
  const auto path = options.out.value_or("tags_over_time.png");
  write_picture(path, drawn.image, fmt::format("scene {}, seed {}", chart.scene, chart.seed), options.force);
  context.out << path.string() << '\n';
  return robot::ExitCode::kDone;
}

robot::ExitCode epsilon_deed(const EpsilonOptions& options, Context& context) {
  EpsilonStudyOptions study;
  study.maps_per_cell = options.maps_per_cell;
  study.seed = options.seed;
  study.jobs =
      options.jobs > 0 ? options.jobs : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  study.knowledge = options.knowledge == "bump" ? Knowledge::kBump : Knowledge::kAdjacent;
  if (!options.explorers.empty()) {
    study.explorers.clear();
  }
  for (const std::string& name : options.explorers) {
    const auto kind = robot::explorer_kind_from(name);
    if (!kind) {
      throw CommandError(robot::ExitCode::kWrongCommandLine,
                         fmt::format("no explorer is called '{}'; twin list explorers names them", name));
    }
    study.explorers.push_back(*kind);
  }
  Progress progress(context.talk, context.progress, "epsilon", "rooms");
  const double begun = context.wall_s();
  ProgressState state;
  const std::optional<EpsilonStudy> result = run_epsilon_study(study, [&](int done, int total) {
    if (context.verbosity != Verbosity::kQuiet) {
      state = {.done = static_cast<double>(done),
               .total = static_cast<double>(total),
               .wall_s = context.wall_s() - begun,
               .note = {}};
      progress.update(state);
    }
    return !robot::pending_interruption();
  });
  if (context.verbosity != Verbosity::kQuiet) {
    progress.finish(state);
  }
  if (!result) {
    return robot::pending_interruption().value_or(robot::ExitCode::kInterrupted);
  }
  if (options.out) {
    write_file(*options.out, to_csv(*result), options.force);
  }
  if (options.chart) {
    const auto drawn = drawn_or_throw(render::draw(surface_of(*result)));
    write_picture(*options.chart, drawn.image, fmt::format("seed {}", study.seed), options.force);
  }
  context.out << (context.json ? to_json(*result) : to_table(*result));
  return robot::ExitCode::kDone;
}

}  // namespace sensotwin::twin
