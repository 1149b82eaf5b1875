// SPDX-License-Identifier: MIT
// What the twin costs against Box2D: the 207-tile house, mapped by IDFM at the Roomba's own pace with every
// device at byte level, beside a bare Box2D loop of the same drive. One iteration is one whole mission. They
// take turns in slices of 2.5 simulated minutes, so that a machine that slows down slows all of them.
//
// Two bare loops run: one on Box2D as it was installed, which reads the clock fourteen times a step, loaded
// into a namespace of its own; and one on the Box2D of this program, whose clock stands as in every program
// with world/.
#include <benchmark/benchmark.h>
#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/benchmarks/bare_loop.hpp"
#include "twin/run/mapping_twin.hpp"
#include "twin/run/run_recorder.hpp"
#include "twin/scene/scene_reader.hpp"
#include "world/obstacles.hpp"

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

/// The middle of the walls: single precision is finest where the robot is.
world::Vec2 middle_m(const Scene& scene) {
  world::Vec2 low_m = scene.robot.X_WR_start.p_m;
  world::Vec2 high_m = low_m;
  for (const world::Wall& wall : scene.world.walls) {
    for (const world::Vec2& p_m : wall.points_m) {
      low_m = low_m.cwiseMin(p_m);
      high_m = high_m.cwiseMax(p_m);
    }
  }
  return 0.5 * (low_m + high_m);
}

/// Runs the mission once for where it leads. \pre no pushable furniture
BareLoopInput bare_input(const Scene& scene) {
  BareLoopInput input;
  const world::Vec2 origin_m = middle_m(scene);
  const auto x_m = [&](const world::Vec2& p_m) { return static_cast<float>(p_m.x() - origin_m.x()); };
  const auto y_m = [&](const world::Vec2& p_m) { return static_cast<float>(p_m.y() - origin_m.y()); };
  const world::Outline outline = world::fixed_outline(scene.world, scene.robot.base.height_m);
  for (const world::Segment& s : outline.segments) {
    input.edges.push_back({x_m(s.a_m), y_m(s.a_m), x_m(s.b_m), y_m(s.b_m)});
  }
  for (const world::Disc& d : outline.discs) {
    input.discs.push_back({x_m(d.middle_m), y_m(d.middle_m), static_cast<float>(d.radius_m)});
  }
  MappingTwin twin(scene);
  robot::Pose2 X_WR = twin.world().X_WR();
  input.x_m = x_m(X_WR.p_m);
  input.y_m = y_m(X_WR.p_m);
  input.yaw_rad = static_cast<float>(X_WR.yaw_rad);
  while (!twin.done()) {
    const double before_rad = X_WR.yaw_rad;
    twin.tick();
    X_WR = twin.world().X_WR();
    const double turn_rad = robot::wrap_angle(X_WR.yaw_rad - before_rad);
    input.ticks.push_back({x_m(X_WR.p_m), y_m(X_WR.p_m), static_cast<float>(turn_rad)});
  }
  input.shell_radius_m = static_cast<float>(scene.robot.base.radius_m);
  input.mass_kg = static_cast<float>(scene.robot.base.mass_kg);
  input.tick_s = static_cast<float>(robot::to_s(robot::kTick));
  input.steps_per_tick = scene.physics.steps_per_tick;
  return input;
}

/// A bare loop on a Box2D of its own, as it was installed. Loaded once: a process has sixteen namespaces.
std::unique_ptr<BareLoop> make_installed_loop(const BareLoopInput& input) {
  static const auto kMake = [] {
    void* const library = dlmopen(LM_ID_NEWLM, SENSOTWIN_BARE_LOOP, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
      throw std::runtime_error(dlerror());
    }
    return reinterpret_cast<decltype(&make_bare_loop)>(dlsym(library, "make_bare_loop"));
  }();
  return std::unique_ptr<BareLoop>(kMake(input));
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
  double installed_s{0.0};
  double clockless_s{0.0};
};

/// Adds the processor time of `work` to `sum_s`.
template <class Work>
void timed(double& sum_s, Work&& work) {
  const double begun_s = processor_s();
  work();
  sum_s += processor_s() - begun_s;
}

/// The twin's drive, three times.
class Race {
 public:
  explicit Race(const Scene& scene)
      : scene_(scene),
        input_(bare_input(scene)),
        installed_(make_installed_loop(input_)),
        clockless_(make_bare_loop(input_)) {}

  [[nodiscard]] std::size_t ticks() const { return input_.ticks.size(); }
  [[nodiscard]] const BareLoop& bare() const { return *installed_; }

  /// One mission and two bare drives, slice by slice.
  Cost run(bool recorded) {
    Cost cost;
    const Scratch scratch;
    robot::RunFolder folder(scratch.path(), robot::Existing::kRefuse);
    std::optional<RunRecorder> recorder;
    if (recorded) {
      recorder.emplace(folder, kTraceEvery);
    }
    installed_->restart();
    clockless_->restart();
    MappingTwin twin(scene_);
    for (std::size_t first = 0; first < ticks(); first += kSliceTicks) {
      const std::size_t last = std::min(first + kSliceTicks, ticks());
      timed(cost.twin_s, [&] {
        for (std::size_t i = first; i < last; ++i) {
          twin.tick();
          if (recorder) {
            recorder->record(twin);
          }
        }
      });
      timed(cost.installed_s, [&] { installed_->run(first, last); });
      timed(cost.clockless_s, [&] { clockless_->run(first, last); });
    }
    if (recorder) {
      timed(cost.twin_s, [&] { recorder->finish(); });
    }
    if (!twin.done() || twin.program().mission().map().visited_count() != kTiles) {
      throw std::runtime_error("the house was not mapped in the time of the run before");
    }
    return cost;
  }

 private:
  const Scene& scene_;
  BareLoopInput input_;
  std::unique_ptr<BareLoop> installed_;
  std::unique_ptr<BareLoop> clockless_;
};

void twin_against_bare(benchmark::State& state, bool recorded) {
  const Scene scene = house();
  Race race(scene);
  const double sim_s = static_cast<double>(race.ticks()) * robot::to_s(robot::kTick);
  Cost sum;
  for ([[maybe_unused]] const auto _ : state) {
    const Cost cost = race.run(recorded);
    state.SetIterationTime(cost.twin_s);
    sum.twin_s += cost.twin_s;
    sum.installed_s += cost.installed_s;
    sum.clockless_s += cost.clockless_s;
  }
  const double simulated_s = sim_s * static_cast<double>(state.iterations());
  state.counters["sim_s"] = sim_s;
  state.counters["twin_x_real_time"] = simulated_s / sum.twin_s;
  state.counters["box2d_x_real_time"] = simulated_s / sum.installed_s;
  state.counters["clockless_box2d_x_real_time"] = simulated_s / sum.clockless_s;
  state.counters["ratio"] = sum.twin_s / sum.installed_s;
  state.counters["ratio_to_clockless"] = sum.twin_s / sum.clockless_s;
  state.counters["bare_astray_mm"] = 1e3 * race.bare().farthest_m();
  state.counters["bare_touching_steps"] = static_cast<double>(race.bare().touching_steps());
}

BENCHMARK_CAPTURE(twin_against_bare, house, false)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(twin_against_bare, house_recorded, true)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sensotwin::twin

BENCHMARK_MAIN();
