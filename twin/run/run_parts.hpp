// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>

#include "robot/drivers/roomba.hpp"
#include "robot/drivers/tag_reader.hpp"
#include "twin/output/summary.hpp"
#include "twin/output/trace_writer.hpp"
#include "twin/run/run_options.hpp"
#include "twin/scene/scene.hpp"

/// What the records of all missions have in common.
namespace sensotwin::twin {

/// Health of the base, of these card readers and of the compass, as the drivers count it.
template <class Program>
[[nodiscard]] LinkHealth links_of(const Program& program,
                                  std::initializer_list<const robot::TagReader*> card_readers) {
  LinkHealth links;
  const robot::LinkHealth& base = program.base().health();
  links.roomba_frames = static_cast<std::int64_t>(base.frames_good);
  links.roomba_frames_corrupt = static_cast<std::int64_t>(base.frames_corrupt);
  links.roomba_frames_missed = static_cast<std::int64_t>(base.frames_missed);
  for (const robot::TagReader* reader : card_readers) {
    links.card_exchanges += reader->health().exchanges;
    links.card_exchanges_failed += reader->health().removed + reader->health().timeouts;
  }
  links.compass_sentences = program.sensor_board().health().headings;
  links.compass_sentences_corrupt = program.sensor_board().health().bad_checksum;
  return links;
}

/// What every summary opens with; its mission's section is left to the run.
template <class Twin>
void open_summary(Summary& summary, const Scene& scene, const Twin& twin, const SceneRunOptions& options) {
  summary.scene = options.scene_as_given;
  summary.variant = scene.variant;
  summary.seed = scene.seed;
  summary.sim_s = robot::to_s(twin.now());
  summary.state_hash = twin.hash().text();
}

/// Truth, command, bumper and floor tag of this tick; what a mission believes is left to its recorder.
template <class Twin>
[[nodiscard]] TraceRow row_of(const Twin& twin) {
  const auto& program = twin.program();
  TraceRow row;
  row.now = twin.now();
  row.X_WR = twin.world().X_WR();
  row.command_left_mps = program.wheels().left_mps;
  row.command_right_mps = program.wheels().right_mps;
  row.bump_left = twin.inputs().bump_left;
  row.bump_right = twin.inputs().bump_right;
  if (program.floor_reader().tag()) {
    row.tag = program.floor_reader().tag()->uid;
  }
  return row;
}

}  // namespace sensotwin::twin
