// SPDX-License-Identifier: MIT
#include "twin/validate/seed_table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>

#include "twin/output/state_hash.hpp"
#include "twin/scene/scene_writer.hpp"

namespace sensotwin::twin {
namespace {

constexpr std::string_view kHead = "seed,scene_hash,program_hash,state_hash";
constexpr std::size_t kHeadColumns = 4;

void add_text(StateHash& hash, std::string_view text) {
  hash.add(text.size());
  for (const char c : text) {
    hash.add(static_cast<unsigned char>(c));
  }
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(at); end != std::string_view::npos; end = text.find(at)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

template <class Number>
bool read_number(std::string_view text, Number& value) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && stop == text.data() + text.size();
}

/// One row. \returns what is wrong with it; empty when nothing
std::string read_row(const std::vector<std::string_view>& cells, const std::vector<std::string_view>& columns,
                     const Origin& origin, RunOutcome& run) {
  if (cells.size() != columns.size()) {
    return fmt::format("has {} cells, the heading {}", cells.size(), columns.size());
  }
  if (!read_number(cells[0], run.seed)) {
    return fmt::format("'{}' is no seed", cells[0]);
  }
  if (cells[1] != origin.scene_hash) {
    return "is a run of another scene, or of this one before it was changed";
  }
  if (cells[2] != origin.program_hash) {
    return "is a run of another build of the twin";
  }
  run.state_hash = cells[3];
  for (std::size_t i = kHeadColumns; i < cells.size(); ++i) {
    double value = std::numeric_limits<double>::quiet_NaN();
    if (!cells[i].empty() && !read_number(cells[i], value)) {
      return fmt::format("'{}' is no number", cells[i]);
    }
    run.figures.emplace(columns[i], value);
  }
  return "";
}

}  // namespace

std::string scene_hash_of(const Scene& scene) {
  Scene bare = scene;
  bare.seed = 0;
  bare.title.clear();
  bare.expect.clear();
  StateHash hash;
  add_text(hash, scene_yaml(bare));
  for (const world::Wall& wall : scene.world.walls) {
    for (const Vec2& point : wall.points_m) {
      hash.add(point.x());
      hash.add(point.y());
    }
    hash.add(wall.closed ? 1 : 0);
  }
  for (const auto& [column, row] : scene.world.carpet.tiles) {
    hash.add(column);
    hash.add(row);
  }
  return hash.text();
}

std::string file_hash_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    return "";
  }
  StateHash hash;
  std::array<char, 65536> block{};
  do {
    in.read(block.data(), block.size());
    add_text(hash, {block.data(), static_cast<std::size_t>(in.gcount())});
  } while (in);
  return hash.text();
}

std::string to_csv(const SeedTable& table, const Origin& origin) {
  std::string text{kHead};
  if (!table.empty()) {
    for (const auto& [name, value] : table.begin()->second.figures) {
      text += "," + name;
    }
  }
  text += "\n";
  for (const auto& [seed, run] : table) {
    text += fmt::format("{},{},{},{}", seed, origin.scene_hash, origin.program_hash, run.state_hash);
    for (const auto& [name, value] : run.figures) {
      text += std::isfinite(value) ? fmt::format(",{}", value) : ",";
    }
    text += "\n";
  }
  return text;
}

SeedTable seed_table_from(std::string_view csv, const Origin& origin, const std::string& file) {
  std::vector<std::string_view> lines = split(csv, '\n');
  if (!csv.starts_with(kHead) || !lines.back().empty()) {
    throw SeedTableError(fmt::format("{}:1: is not the seeds.csv of a validation", file));
  }
  lines.pop_back();
  const std::vector<std::string_view> columns = split(lines.front(), ',');
  SeedTable table;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    RunOutcome run;
    const std::string wrong = read_row(split(lines[i], ','), columns, origin, run);
    if (!wrong.empty()) {
      throw SeedTableError(fmt::format("{}:{}: {}", file, i + 1, wrong));
    }
    table[run.seed] = std::move(run);
  }
  return table;
}

std::vector<RunOutcome> runs_of(const SeedTable& table, const std::vector<std::uint64_t>& seeds) {
  std::vector<RunOutcome> runs;
  for (const std::uint64_t seed : seeds) {
    if (const auto found = table.find(seed); found != table.end()) {
      runs.push_back(found->second);
    }
  }
  return runs;
}

}  // namespace sensotwin::twin
