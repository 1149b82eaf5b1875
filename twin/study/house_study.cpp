// SPDX-License-Identifier: MIT
#include "twin/study/house_study.hpp"

#include <array>
#include <cassert>
#include <cstdio>

namespace sensotwin::twin {

GridRoom HouseLayout::room() const {
  GridRoom room{18, 17};
  for (int column = 9; column < 18; ++column) {
    for (int row = 8; row < 17; ++row) room.block({column, row});
  }
  for (const Furniture& piece : furniture) {
    for (int column = 0; column < piece.columns; ++column) {
      for (int row = 0; row < piece.rows; ++row) {
        room.block({piece.corner.column + column, piece.corner.row + row});
      }
    }
  }
  return room;
}

std::vector<HouseLayout> house_layouts() {
  return {{"sofa_in_the_middle",
           {{"sofa", {5, 4}, 2, 4}, {"armchair", {0, 11}, 2, 2}, {"sideboard", {2, 5}, 2, 3}}},
          {"sofa_in_the_east",
           {{"sofa", {12, 3}, 2, 4}, {"armchair", {9, 6}, 2, 2}, {"sideboard", {2, 7}, 2, 3}}},
          {"sofa_at_the_wall",
           {{"sofa", {0, 2}, 2, 4}, {"armchair", {3, 2}, 2, 2}, {"sideboard", {15, 4}, 2, 3}}}};
}

const DriveTally& HouseRun::tally(robot::ExplorerKind explorer, Knowledge knowledge) const {
  const HouseRow* found = nullptr;
  for (const HouseRow& row : rows) {
    if (row.explorer == explorer && row.knowledge == knowledge) found = &row;
  }
  assert(found != nullptr);
  return found->tally;
}

std::vector<HouseRun> run_house_study() {
  std::vector<HouseRun> runs;
  for (const HouseLayout& layout : house_layouts()) {
    HouseRun run{.layout = layout, .rows = {}};
    const GridRoom room = layout.room();
    for (const Knowledge knowledge : {Knowledge::kAdjacent, Knowledge::kBump}) {
      for (const robot::ExplorerKind kind : robot::kExplorerKinds) {
        const auto explorer = robot::make_explorer(
            kind, {.tile_s = kRoombaPace.tile_s, .quarter_turn_s = kRoombaPace.quarter_turn_s});
        run.rows.push_back(
            {kind, knowledge, drive(*explorer, room, {.knowledge = knowledge, .to_the_end = true})});
      }
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

std::string to_table(const std::vector<HouseRun>& runs) {
  std::string text = "SensoBot, figure 5: BFM 69, DFM 42, IDFM 26 minutes for 207 tags\n";
  for (const HouseRun& run : runs) {
    text += run.layout.name + "\n" + run.layout.room().picture();
    text += "  knows     explorer            moves  turns  bumps   paper's pace  Roomba's pace\n";
    for (const HouseRow& row : run.rows) {
      std::array<char, 160> line{};
      std::snprintf(line.data(), line.size(), "  %-8s  %-18s  %5d  %5d  %5d   %8.1f min   %8.2f min\n",
                    row.knowledge == Knowledge::kAdjacent ? "adjacent" : "bump",
                    std::string{robot::name_of(row.explorer)}.c_str(), row.tally.moves,
                    row.tally.quarter_turns, row.tally.bumps, kPaperPace.minutes(row.tally),
                    kRoombaPace.minutes(row.tally));
      text += line.data();
    }
  }
  return text;
}

}  // namespace sensotwin::twin
