// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <map>

#include "robot/config/nearest_name.hpp"
#include "robot/settings/mission_checks.hpp"
#include "twin/scene/scene_checks.hpp"

/// Ceiling tags, the radio and missions along the tags, as far as one field cannot tell.
namespace sensotwin::twin {

void SceneChecks::radio() {
  if (!scene_.world.radio) {
    return;
  }
  const world::RadioWorld& radio = *scene_.world.radio;
  std::map<std::string, std::size_t> names;
  std::map<robot::Epc, std::size_t> codes;
  for (std::size_t i = 0; i < radio.tags.size(); ++i) {
    const std::string path = fmt::format("world.ceiling_tags[{}]", i);
    const auto [name, new_name] = names.try_emplace(radio.tags[i].name, i);
    if (!new_name && sound(path + ".name")) {
      add(path + ".name",
          fmt::format("'{}' is the name of world.ceiling_tags[{}] too", name->first, name->second),
          "expected a name of its own");
    }
    const auto [code, new_code] = codes.try_emplace(radio.tags[i].epc, i);
    if (!new_code && sound(path)) {
      add(path + ".epc", fmt::format("is the code of world.ceiling_tags[{}] too", code->second),
          "expected a code of its own");
    }
  }
  const std::size_t slots = radio.radio.slots_s.size();
  if (!radio.radio.simultaneous && slots != 0 && slots != radio.antennas.size()) {
    add("world.radio.slots_s", fmt::format("has {} of them for {} antennas", slots, radio.antennas.size()),
        "expected one for each antenna of robot.uhf_reader, or none");
  }
  if (sound("world.radio.phase_sign") && radio.radio.phase_sign != 1.0 && radio.radio.phase_sign != -1.0) {
    add("world.radio.phase_sign", fmt::format("is {}", radio.radio.phase_sign), "expected 1 or -1");
  }
  for (std::size_t i = 0; i < radio.antennas.size(); ++i) {
    if (radio.antennas[i].boresight.norm() < 0.5) {
      add(fmt::format("robot.uhf_reader.antennas[{}].boresight", i), "is too short to be a direction",
          "expected a vector of length 1, such as [0, 0, 1]");
    }
  }
}

void SceneChecks::exchanged_tags(const std::vector<std::string>& names) {
  const std::vector<std::string>& exchanged = scene_.mission.phase->exchanged;
  if (exchanged.size() == 1 || (exchanged.size() == 2 && exchanged[0] == exchanged[1])) {
    add("mission.phase.exchanged", "names one tag", "expected none, or two different ones");
  }
  for (std::size_t i = 0; i < exchanged.size(); ++i) {
    if (std::find(names.begin(), names.end(), exchanged[i]) == names.end()) {
      add(fmt::format("mission.phase.exchanged[{}]", i), fmt::format("there is no tag '{}'", exchanged[i]),
          "expected the name of one of world.ceiling_tags" + robot::did_you_mean(exchanged[i], names));
    }
  }
}

void SceneChecks::reader_faults() {
  if (!scene_.world.radio) {
    return;
  }
  const world::RadioWorld& radio = *scene_.world.radio;
  const std::vector<robot::Vec2>& silent_s = radio.faults.silent_s;
  for (std::size_t i = 0; i < silent_s.size(); ++i) {
    if (silent_s[i].x() >= silent_s[i].y()) {
      add(fmt::format("robot.uhf_reader.faults.silent_s[{}]", i),
          fmt::format("is from {} s to {} s", silent_s[i].x(), silent_s[i].y()), "expected [from, to]");
    }
  }
  if (radio.faults.cables_swapped && radio.antennas.size() < 2) {
    add("robot.uhf_reader.faults.cables", "one antenna has one cable", "expected two antennas or more");
  }
}

void SceneChecks::phase_mission() {
  if (!scene_.mission.phase) {
    return;
  }
  const PhaseMission& mission = *scene_.mission.phase;
  if (!scene_.world.radio || scene_.world.radio->tags.empty()) {
    add("mission.phase", "needs ceiling tags", "expected world.ceiling_tags");
    return;
  }
  const world::RadioWorld& radio = *scene_.world.radio;
  if (!reader_.has("robot.start.at_m")) {
    add("robot.start", "is missing", "expected a start: { at_m: [x, y], heading_deg: 0 }");
  }
  std::vector<std::string> names;
  for (const world::CeilingTag& tag : radio.tags) {
    names.emplace_back(tag.name);
  }
  for (const robot::MissionProblem& problem :
       robot::problems_of(mission, names, radio.antennas.size(), "world.ceiling_tags")) {
    if (sound(problem.path)) {
      add(problem.path, problem.what, problem.hint);
    }
  }
  exchanged_tags(names);
}

}  // namespace sensotwin::twin
