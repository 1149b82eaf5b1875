// SPDX-License-Identifier: MIT
#include "robot/sensobot/robot_recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "robot/mapping/explorer_kind.hpp"
#include "robot/record/program_events.hpp"
#include "robot/record/recovered_map.hpp"
#include "robot/settings/program_config.hpp"

namespace sensotwin::robot {
namespace {

// Keys in the order in which they are written here, as the twin's summary has them.
using Json = nlohmann::ordered_json;

Json map_json(const RobotFile& robot, MappingProgram& program, double run_s) {
  const MappingMission& mission = program.mission();
  const MissionCounts& counts = mission.counts();
  return {{"explorer", robot::name_of(robot.settings.mission.map->explorer)},
          {"map_id", robot.settings.map_id},
          {"tiles_mapped", mission.map().visited_count()},
          {"tiles_given_up", counts.tiles_given_up},
          {"visits", counts.visits},
          {"minutes", run_s / 60.0},
          {"metres", mission.navigator().filter().path_length_m()},
          {"turns", mission.navigator().filter().turned_rad() / (kPi / 2.0)},
          {"moves", counts.moves},
          {"moves_missed", counts.moves_missed},
          {"moves_recovered", counts.misses_recovered},
          {"writes_failed", counts.writes_failed}};
}

Json path_json(const RobotFile& robot, const PhaseProgram& program, int reached, int skipped, double run_s) {
  return {{"controller", program.fuzzy() != nullptr ? "fuzzy" : "own"},
          {"arrived", program.arrived() ? 1 : 0},
          {"destinations", destinations_of(robot.settings).size()},
          {"tags_reached", reached},
          {"tags_skipped", skipped},
          {"minutes", run_s / 60.0}};
}

Json links_json(RobotProgram& program) {
  const LinkHealth& base = program.base().health();
  Json links{{"roomba_frames", base.frames_good},
             {"roomba_frames_corrupt", base.frames_corrupt},
             {"roomba_frames_missed", base.frames_missed},
             {"roomba_frames_superseded", base.frames_superseded},
             {"roomba_starts", base.starts}};
  const ReaderHealth& floor = program.floor_reader().health();
  links["card_exchanges"] = floor.exchanges;
  links["card_exchanges_failed"] = floor.removed + floor.timeouts;
  links["compass_sentences"] = program.sensor_board().health().headings;
  links["compass_sentences_corrupt"] = program.sensor_board().health().bad_checksum;
  if (const PhaseProgram* phase = program.phase()) {
    links["uhf_reads"] = phase->uhf_reader().health().reads;
    links["uhf_setups"] = phase->uhf_reader().health().setups;
  }
  return links;
}

}  // namespace

RobotRecorder::RobotRecorder(const RobotFile& robot, RunFolder& folder)
    : robot_(robot), folder_(folder), events_(folder.stream("events.jsonl")) {}

void RobotRecorder::record(RobotProgram& program) {
  if (MappingProgram* mapping = program.mapping()) {
    record_events(*mapping, events_, [](const MissionEvent&) {});
    return;
  }
  if (HallwayProgram* hallway = program.hallway()) {
    record_events(*hallway, events_, [](const HallwayEvent&) {});
    return;
  }
  record_events(
      *program.phase(), events_, [this](const Epc& epc) { return name_of(epc); },
      [this](const PhaseEvent& event) {
        tags_reached_ += event.name == "tag_reached" ? 1 : 0;
        tags_skipped_ += event.name == "tag_skipped" ? 1 : 0;
      });
}

void RobotRecorder::record(Instant now, const DeviceState& device) {
  events_.add(now, device.up ? "device_there" : "device_gone",
              {{"device", device.name}, {"address", device.address}, {"why", device.trouble}});
}

std::string RobotRecorder::name_of(const Epc& epc) const {
  const auto& tags = robot_.settings.ceiling_tags;
  const auto found =
      std::find_if(tags.begin(), tags.end(), [&](const KnownTag& tag) { return tag.epc == epc; });
  return found == tags.end() ? "" : found->name;
}

std::string RobotRecorder::progress(RobotProgram& program) const {
  if (const MappingProgram* mapping = program.mapping()) {
    return fmt::format("{} tiles", mapping->mission().map().visited_count());
  }
  if (const HallwayProgram* hallway = program.hallway()) {
    const HallwayMap& map = hallway->map();
    return hallway->place() ? "at " + map.node(*hallway->place()).name
                            : fmt::format("{} places", map.nodes().size());
  }
  return fmt::format("destination {} of {}", program.phase()->leg() + 1,
                     destinations_of(robot_.settings).size());
}

std::string RobotRecorder::finish(RobotProgram& program, const RunFigures& figures) {
  events_.finish();
  Json summary{{"robot", robot_.file}, {"outcome", figures.outcome}, {"run_s", figures.run_s}};
  if (MappingProgram* mapping = program.mapping()) {
    write_recovered_map(folder_, mapping->mission(), robot_.settings.tile_m);
    summary["map"] = map_json(robot_, *mapping, figures.run_s);
  } else if (HallwayProgram* hallway = program.hallway()) {
    summary["hallway"] = {{"arrived", hallway->arrived() ? 1 : 0}, {"places", hallway->map().nodes().size()}};
    if (hallway->survey() != nullptr) {
      HallwayFile drawn = robot_.settings.hallways;
      drawn.map = hallway->map();
      folder_.write("hallways.yaml", hallway_yaml(drawn));
    }
  } else {
    summary["path"] = path_json(robot_, *program.phase(), tags_reached_, tags_skipped_, figures.run_s);
  }
  summary["links"] = links_json(program);
  summary["loop"] = {{"steps", figures.steps},
                     {"steps_late", figures.steps_late},
                     {"latest_step_s", figures.latest_step_s},
                     {"journal_bytes", figures.journal_bytes},
                     {"journal_complete", figures.journal_complete}};
  std::string text = summary.dump(2) + "\n";
  folder_.write("summary.json", text);
  return text;
}

}  // namespace sensotwin::robot
