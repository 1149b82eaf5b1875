// SPDX-License-Identifier: MIT
#include <cstdarg>
#include <cstdio>

#include "twin/study/epsilon_study.hpp"

namespace sensotwin::twin {
namespace {

/// printf into a string; 160 characters hold every line of this file.
[[gnu::format(printf, 1, 2)]] std::string line(const char* format, ...) {
  char text[160];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

std::string json_of(const EpsilonFigures& f) {
  return line("{\"mean_percent\": %.6f, \"worst_percent\": %.6f}", f.mean_percent, f.worst_percent);
}

std::string json_of(const PlaneFit& fit) {
  return line("{\"per_blocked_percent\": %.6f, \"per_chunk\": %.6f, \"constant\": %.6f, \"r_squared\": %.6f}",
              fit.per_blocked_percent, fit.per_chunk, fit.constant, fit.r_squared);
}

std::string json_of(const EpsilonCell& cell) {
  return line("        {\"blocked_percent\": %d, \"chunks\": %d, ", cell.obstacles.blocked_percent,
              cell.obstacles.chunks) +
         "\"paper\": " + json_of(cell.paper) + ", \"physical\": " + json_of(cell.physical) +
         line(", \"turns_per_tag\": %.6f, \"time_per_tag_s\": %.6f, \"incomplete_maps\": %d}",
              cell.turns_per_tag, cell.time_per_tag_s, cell.incomplete_maps);
}

std::string table_row(const char* counting, const PlaneFit& fit, double mean_percent,
                      const EpsilonCell& largest, const EpsilonFigures& figures) {
  return line(
      "  %-9s %7.4f Bp %+8.4f Bd %+8.4f  R2 %5.3f  mean %6.2f %%  largest cell %6.2f %% at (%d, %d)\n",
      counting, fit.per_blocked_percent, fit.per_chunk, fit.constant, fit.r_squared, mean_percent,
      figures.mean_percent, largest.obstacles.blocked_percent, largest.obstacles.chunks);
}

}  // namespace

std::string to_csv(const EpsilonStudy& study) {
  std::string text =
      "explorer,blocked_percent,chunks,paper_mean_percent,paper_worst_percent,physical_mean_percent,"
      "physical_worst_percent,turns_per_tag,time_per_tag_s,incomplete_maps\n";
  for (const ExplorerEpsilon& explorer : study.explorers) {
    for (const EpsilonCell& cell : explorer.cells) {
      text += std::string{robot::name_of(explorer.explorer)} +
              line(",%d,%d,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%d\n", cell.obstacles.blocked_percent,
                   cell.obstacles.chunks, cell.paper.mean_percent, cell.paper.worst_percent,
                   cell.physical.mean_percent, cell.physical.worst_percent, cell.turns_per_tag,
                   cell.time_per_tag_s, cell.incomplete_maps);
    }
  }
  return text;
}

std::string to_json(const EpsilonStudy& study) {
  std::string text = line("{\n  \"maps_per_cell\": %d,\n  \"seed\": %llu,\n  \"explorers\": [",
                          study.options.maps_per_cell, static_cast<unsigned long long>(study.options.seed));
  const char* between = "\n";
  for (const ExplorerEpsilon& explorer : study.explorers) {
    text += between;
    between = ",\n";
    text += "    {\n      \"explorer\": \"" + std::string{robot::name_of(explorer.explorer)} + "\",\n";
    text += "      \"paper_fit\": " + json_of(explorer.paper_fit) + ",\n";
    text += "      \"physical_fit\": " + json_of(explorer.physical_fit) + ",\n      \"cells\": [\n";
    for (std::size_t i = 0; i < explorer.cells.size(); ++i) {
      text += json_of(explorer.cells[i]) + (i + 1 < explorer.cells.size() ? ",\n" : "\n");
    }
    text += "      ]\n    }";
  }
  return text + "\n  ]\n}\n";
}

std::string to_table(const EpsilonStudy& study) {
  std::string text =
      line("%d maps in each of %zu cells, seed %llu; epsilon in per cent\n", study.options.maps_per_cell,
           study.options.cells.size(), static_cast<unsigned long long>(study.options.seed));
  text += "SensoBot, equation (2), for IDFM, its own counting:\n";
  text += "  paper      0.0765 Bp  +0.4869 Bd  -0.3437            largest cell < 11 %\n";
  for (const ExplorerEpsilon& explorer : study.explorers) {
    double turns = 0.0;
    double time_s = 0.0;
    double worst_map = 0.0;
    int incomplete = 0;
    for (const EpsilonCell& cell : explorer.cells) {
      turns += cell.turns_per_tag / static_cast<double>(explorer.cells.size());
      time_s += cell.time_per_tag_s / static_cast<double>(explorer.cells.size());
      worst_map = std::max(worst_map, cell.physical.worst_percent);
      incomplete += cell.incomplete_maps;
    }
    text += std::string{robot::name_of(explorer.explorer)} + "\n";
    text += table_row("paper", explorer.paper_fit, explorer.mean_paper_percent(), explorer.worst_paper_cell(),
                      explorer.worst_paper_cell().paper);
    text += table_row("physical", explorer.physical_fit, explorer.mean_physical_percent(),
                      explorer.worst_physical_cell(), explorer.worst_physical_cell().physical);
    text += line("  worst map %.1f %%, %.3f turns and %.2f s a tag, %d maps incomplete\n", worst_map, turns,
                 time_s, incomplete);
  }
  return text;
}

}  // namespace sensotwin::twin
