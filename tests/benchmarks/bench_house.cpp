// SPDX-License-Identifier: MIT
// How much the twin costs beyond Box2D: the 207-tile house, mapped by IDFM at the Roomba's own pace with
// every device at byte level, against a bare Box2D loop of the same drive. One iteration is one whole
// mission. The two take turns in slices of 2.5 simulated minutes, so that a machine that slows down slows
// both.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/benchmarks/bare_house.hpp"
#include "twin/run/mapping_twin.hpp"
#include "twin/run/run_recorder.hpp"
#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {
namespace {

constexpr std::size_t kSliceTicks = 10'000;
/// What the robot can reach of the house: 225 tiles, three pieces of furniture on 18 of them.
constexpr std::size_t kTiles = 207;
/// As `twin run` records when nobody says otherwise.
constexpr int kTraceEvery = 7;

/// Processor time of this thread: what other programs do on the machine does not count.
double processor_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Scene house() {
  SceneOverrides overrides;
  overrides.set = {"mission.map.explorer=idfm", "mission.map.pace=own"};
  return read_scene(SENSOTWIN_SOURCE_DIR "/scenes/house.yaml", overrides);
}

std::vector<robot::Pose2> path_of(const Scene& scene) {
  MappingTwin twin(scene);
  std::vector<robot::Pose2> path{twin.world().X_WR()};
  while (!twin.done()) {
    twin.tick();
    path.push_back(twin.world().X_WR());
  }
  return path;
}

/// A folder that goes away with its owner.
class Scratch {
 public:
  Scratch() {
    std::string pattern = (std::filesystem::temp_directory_path() / "bench-house-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::runtime_error("cannot create " + pattern);
    }
    path_ = pattern;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct Cost {
  double twin_s{0.0};
  double bare_s{0.0};
};

/// One mission and one bare drive, slice by slice. \pre bare is at the start
Cost run_once(const Scene& scene, BareHouse& bare, bool recorded) {
  Cost cost;
  const Scratch scratch;
  RunFolder folder(scratch.path(), Existing::kRefuse);
  std::optional<RunRecorder> recorder;
  if (recorded) {
    recorder.emplace(folder, kTraceEvery);
  }
  MappingTwin twin(scene);
  for (std::size_t tick = 0; tick < bare.ticks();) {
    const std::size_t end = std::min(tick + kSliceTicks, bare.ticks());
    const double begun_s = processor_s();
    for (std::size_t i = tick; i < end; ++i) {
      twin.tick();
      if (recorder) {
        recorder->record(twin);
      }
    }
    const double turn_s = processor_s();
    for (; tick < end; ++tick) {
      bare.tick();
    }
    cost.twin_s += turn_s - begun_s;
    cost.bare_s += processor_s() - turn_s;
  }
  if (recorder) {
    const double begun_s = processor_s();
    recorder->finish();
    cost.twin_s += processor_s() - begun_s;
  }
  if (!twin.done() || twin.program().mission().map().visited_count() != kTiles) {
    throw std::runtime_error("the house was not mapped in the time of the run before");
  }
  return cost;
}

void twin_against_bare(benchmark::State& state, bool recorded) {
  const Scene scene = house();
  BareHouse bare(scene, path_of(scene));
  const double sim_s = static_cast<double>(bare.ticks()) * robot::to_s(robot::kTick);
  Cost sum;
  for ([[maybe_unused]] const auto _ : state) {
    bare.restart();
    const Cost cost = run_once(scene, bare, recorded);
    state.SetIterationTime(cost.twin_s);
    sum.twin_s += cost.twin_s;
    sum.bare_s += cost.bare_s;
  }
  const double simulated_s = sim_s * static_cast<double>(state.iterations());
  state.counters["sim_s"] = sim_s;
  state.counters["twin_x_real_time"] = simulated_s / sum.twin_s;
  state.counters["bare_x_real_time"] = simulated_s / sum.bare_s;
  state.counters["ratio"] = sum.twin_s / sum.bare_s;
  state.counters["bare_astray_mm"] = 1e3 * bare.farthest_m();
  state.counters["bare_touching_steps"] = static_cast<double>(bare.touching_steps());
}

BENCHMARK_CAPTURE(twin_against_bare, house, false)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(twin_against_bare, house_recorded, true)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sensotwin::twin

BENCHMARK_MAIN();
