// SPDX-License-Identifier: MIT
#include "twin/run/twin_journal.hpp"

#include "robot/settings/robot_file.hpp"
#include "twin/run/phase_config.hpp"

namespace sensotwin::twin {

std::string robot_file_of(const Scene& scene) {
  const robot::RandomStream random(scene.seed);
  robot::RobotFile file;
  file.devices = {.base = "twin",
                  .sensors = "twin",
                  .llrp = std::nullopt,
                  .card_readers = {"twin, under the robot", "twin, ahead"}};
  if (scene.mission.phase) {
    file.devices.llrp = "twin";
    file.settings = robot_settings_of(scene, radio_of(scene, random));
  } else if (scene.mission.hallway) {
    file.settings = hallway_settings_of(scene);
    file.hallways_given = true;
  } else {
    file.settings = robot_settings_of(scene, map_id_of(scene));
    file.map_id_given = true;
  }
  file.time_limit_s = scene.limits.time_limit_s;
  return robot::robot_yaml(file);
}

MappingTwin::Rewiring TwinJournal::on_mapping_wires() {
  robot::JournalWriter* const writer = file_.writer();
  if (writer == nullptr) {
    return {};
  }
  return [this, writer](const robot::MappingLinks& links) -> robot::MappingLinks {
    wiring_ = std::make_unique<robot::Wiring>(
        robot::RobotLinks{links.base, links.sensors, no_reader_, links.floor_reader, links.forward_reader},
        writer);
    const robot::RobotLinks tapped = wiring_->links();
    return {tapped.base, tapped.floor_reader, tapped.forward_reader, tapped.sensors};
  };
}

PhaseTwin::Rewiring TwinJournal::on_phase_wires() {
  robot::JournalWriter* const writer = file_.writer();
  if (writer == nullptr) {
    return {};
  }
  return [this, writer](const robot::PhaseLinks& links) -> robot::PhaseLinks {
    wiring_ = std::make_unique<robot::Wiring>(
        robot::RobotLinks{links.base, links.sensors, links.uhf_reader, links.floor_reader, no_card_}, writer);
    const robot::RobotLinks tapped = wiring_->links();
    return {tapped.base, tapped.uhf_reader, tapped.floor_reader, tapped.sensors};
  };
}

HallwayTwin::Rewiring TwinJournal::on_hallway_wires() {
  robot::JournalWriter* const writer = file_.writer();
  if (writer == nullptr) {
    return {};
  }
  return [this, writer](const robot::HallwayLinks& links) -> robot::HallwayLinks {
    wiring_ = std::make_unique<robot::Wiring>(
        robot::RobotLinks{links.base, links.sensors, no_reader_, links.floor_reader, no_card_}, writer);
    const robot::RobotLinks tapped = wiring_->links();
    return {tapped.base, tapped.floor_reader, tapped.sensors};
  };
}

}  // namespace sensotwin::twin
