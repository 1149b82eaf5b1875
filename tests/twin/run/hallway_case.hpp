// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "mapping_case.hpp"
#include "twin/run/hallway_run.hpp"
#include "twin/scene/scene_reader.hpp"

/// Whole runs through hallways, in this process, as `twin run` does them.
namespace sensotwin::twin {

/// \param file  below scenes/, without its extension
inline Scene hallway_scene(const std::string& file, const std::string& variant = "",
                           const std::vector<std::string>& set = {}, std::uint64_t seed = 7) {
  return read_scene(kSource / "scenes" / (file + ".yaml"), {.set = set, .seed = seed, .variant = variant});
}

/// To be added to the changes of a scene: from one place to another.
inline std::vector<std::string> from_to(std::vector<std::string> set, const std::string& from,
                                        const std::string& to) {
  set.push_back("mission.hallway.from=" + from);
  set.push_back("mission.hallway.to=" + to);
  set.push_back("robot.start=auto");
  return set;
}

/// How a run came out, and the last thing that the robot said.
struct HallwayOutcome {
  HallwayResult result;
  std::string last;
};

inline HallwayOutcome hallway_run(const Scene& scene) {
  const TemporaryFolder folder;
  robot::RunFolder results(folder / "run", robot::Existing::kRefuse);
  SceneRunOptions options;
  options.scene_as_given = scene.name;
  options.pictures = false;
  HallwayOutcome outcome;
  outcome.result = *run_hallway(scene, results, options).hallway;
  const std::string events = content_of(folder / "run/events.jsonl");
  const std::size_t name = events.rfind("\"event\":\"");
  if (name != std::string::npos) {
    outcome.last = events.substr(name + 9, events.find('"', name + 9) - name - 9);
  }
  return outcome;
}

/// Many runs, together.
struct HallwayTally {
  int runs{0};
  int arrived{0};
  int contacts{0};
  int shoved{0};
  int missed{0};
  int silent{0};  ///< did not arrive, and did not say why
  double length_m{0.0};
  double shortest_m{0.0};
  std::map<std::string, int> stopped;  ///< by what was said last
};

/// From every place to every other, `seeds` times each, with other faults for each pair: the run's seed is
/// 1000 seed + the pair's number in the order of the file, which reruns it in `twin run --seed`.
inline HallwayTally every_pair(const std::string& file, const std::string& variant,
                               const std::vector<std::string>& set, std::uint64_t seeds) {
  const Scene base = hallway_scene(file, variant, set);
  HallwayTally tally;
  std::uint64_t pair = 0;
  for (const robot::HallwayNode& from : base.hallways.map.nodes()) {
    for (const robot::HallwayNode& to : base.hallways.map.nodes()) {
      if (from.name == to.name) {
        continue;
      }
      const std::uint64_t number = pair++;
      for (std::uint64_t seed = 1000 + number; seed <= 1000 * seeds + number; seed += 1000) {
        const HallwayOutcome outcome =
            hallway_run(hallway_scene(file, variant, from_to(set, from.name, to.name), seed));
        const HallwayResult& result = outcome.result;
        ++tally.runs;
        tally.contacts += result.wall_contacts;
        tally.shoved += result.shoved;
        tally.missed += result.tags_missed;
        if (result.arrived == 1) {
          ++tally.arrived;
          tally.length_m += result.length_m;
          tally.shortest_m += result.shortest_m;
        } else {
          ++tally.stopped[outcome.last];
          const bool says_why =
              outcome.last == "no_way" || outcome.last == "only_by_unknown" || outcome.last == "lost";
          tally.silent += says_why ? 0 : 1;
        }
        if (result.arrived != 1 || result.wall_contacts > 0) {
          std::printf("%s %s: %s to %s, seed %d: %s, %.1f m of %.1f, %d contacts\n", file.c_str(),
                      variant.c_str(), from.name.c_str(), to.name.c_str(), static_cast<int>(seed),
                      outcome.last.c_str(), result.length_m, result.shortest_m, result.wall_contacts);
        }
      }
    }
  }
  std::printf("%s %s: %d of %d arrived, %d contacts, way %.4f, %d tags missed, %d shoved, %d silent\n",
              file.c_str(), variant.c_str(), tally.arrived, tally.runs, tally.contacts,
              tally.length_m / tally.shortest_m, tally.missed, tally.shoved, tally.silent);
  return tally;
}

}  // namespace sensotwin::twin
