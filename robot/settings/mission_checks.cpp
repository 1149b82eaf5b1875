// SPDX-License-Identifier: MIT
#include "robot/settings/mission_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "robot/config/nearest_name.hpp"
#include "robot/phase/estimation/phase_model.hpp"

namespace sensotwin::robot {
namespace {

void check_destinations(const PhaseMission& mission, const std::vector<std::string>& tags,
                        const std::string& tags_at, std::vector<MissionProblem>& problems) {
  for (std::size_t i = 0; i < mission.destinations.size(); ++i) {
    const std::string& name = mission.destinations[i];
    const std::string path = fmt::format("mission.phase.destinations[{}]", i);
    if (std::find(tags.begin(), tags.end(), name) == tags.end()) {
      problems.push_back(
          {path, fmt::format("there is no tag '{}'", name),
           fmt::format("expected the name of one of {}{}", tags_at, did_you_mean(name, tags))});
    } else if (i > 0 && mission.destinations[i - 1] == name) {
      problems.push_back(
          {path, fmt::format("'{}' comes twice in a row", name), "expected another tag between"});
    }
  }
}

}  // namespace

std::vector<MissionProblem> problems_of(const PhaseMission& mission, const std::vector<std::string>& tags,
                                        std::size_t antennas, const std::string& tags_at) {
  std::vector<MissionProblem> problems;
  check_destinations(mission, tags, tags_at, problems);
  const std::string antennas_at = "robot.uhf_reader.antennas";
  if (mission.controller == PhaseController::kFuzzy) {
    if (antennas != 2) {
      problems.push_back(
          {antennas_at, fmt::format("there are {}", antennas), "expected two for the fuzzy controller"});
    }
    if (mission.path != PhasePath::kPolyline) {
      problems.push_back(
          {"mission.phase.path", "the fuzzy controller drives polylines only", "expected controller: own"});
    }
    if (const auto problem = problem_of(mission.sets)) {
      problems.push_back({"mission.phase.sets", *problem, "expected sets as in docs/phase.md"});
    }
  } else if (antennas > PhaseReaderModel::kMostAntennas) {
    problems.push_back(
        {antennas_at, fmt::format("there are {}", antennas), "expected at most four, the ports of an R420"});
  }
  const std::size_t stops = mission.destinations.empty() ? tags.size() : mission.destinations.size();
  if (mission.path == PhasePath::kCircle && stops < 3) {
    problems.push_back(
        {"mission.phase.path", "three tags make a circle", "expected three destinations or more"});
  }
  return problems;
}

std::vector<MissionProblem> problems_of(const HallwaySection& mission, const HallwayMap& map) {
  std::vector<MissionProblem> problems;
  if (mission.survey) {
    return problems;
  }
  std::vector<std::string> names;
  for (const HallwayNode& node : map.nodes()) {
    names.push_back(node.name);
  }
  if (names.empty()) {
    problems.push_back(
        {"mission.hallway", "needs a hallway map", "expected a file with places, or survey: true"});
    return problems;
  }
  const auto check = [&](const std::string& key, const std::string& name) {
    if (!name.empty() && !map.find(name)) {
      problems.push_back({"mission.hallway." + key,
                          "there is no place '" + name + "'" + did_you_mean(name, names),
                          "expected a place of the hallway map"});
    }
  };
  check("from", mission.from);
  check("to", mission.to);
  if (mission.to.empty()) {
    problems.push_back({"mission.hallway.to", "is missing", "expected a place to go to, or survey: true"});
  }
  return problems;
}

}  // namespace sensotwin::robot
