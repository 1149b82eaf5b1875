// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "twin/cli/command.hpp"

/// What a user can ask of each command. Each function makes the word of the command line from the deed behind
/// it, so that main's list of commands is the list of what this program can do.
namespace sensotwin::twin {

template <class Options>
using Deed = std::function<robot::ExitCode(const Options&, Context&)>;

/// A scene, and what the command line changes in it.
struct SceneChoice {
  std::filesystem::path scene;
  std::optional<std::uint64_t> seed{};  ///< instead of the scene's
  std::vector<std::string> set{};       ///< "key.path=value", in order
  std::string variant{};                ///< of the scene's `variants:`; empty: the scene as it is
};

struct RunOptions {
  SceneChoice choice{};
  std::optional<std::filesystem::path> out{};  ///< none: default_run_folder()
  bool force{false};
  int trace_every{7};  ///< ticks from row to row of trace.csv. Chosen: 0.1 s, a row every 3 cm at 0.3 m/s
  bool pictures{true};
  std::optional<std::filesystem::path> tag_log{};
  std::optional<std::filesystem::path> journal{};
  std::optional<std::string> monitor{};  ///< host:port of a page that shows the run; none: no page
  double rtf{0.0};                       ///< simulated seconds in a real one; 0: as fast as it goes
  /// Real seconds that the page stays after the run; none: until Ctrl-C.
  std::optional<double> monitor_linger_s{};
};
[[nodiscard]] Command make_run_command(Deed<RunOptions> deed);

struct ServeOptions {
  SceneChoice choice{};
  std::optional<std::filesystem::path> out{};  ///< none: default_serve_folder()
  std::optional<double> factor{1.0};           ///< none: as fast as the client follows
  std::optional<std::string> llrp{};           ///< host:port; none: 127.0.0.1:5084, or any free port
  std::string vpcd{"127.0.0.1:35963"};         ///< where Debian's vpcd listens
  bool cards{true};
  bool wait_for_cards{false};
  bool strict_baud{false};
  bool truth{false};
  std::optional<double> end_after_sim_s{};
  std::optional<std::string> monitor{};  ///< as of RunOptions
};
[[nodiscard]] Command make_serve_command(Deed<ServeOptions> deed);

struct TraceOptions {
  std::optional<std::filesystem::path>
      plan{};                                  ///< picture, map, hallway map or tracing; none: an empty sheet
  std::optional<std::filesystem::path> out{};  ///< folder, or a hallway map in one; none: where the plan lies
  std::string listen{"127.0.0.1:0"};           ///< port 0: any free one
  bool open{false};                            ///< the page in the desktop's browser
};
[[nodiscard]] Command make_trace_command(Deed<TraceOptions> deed);

struct ValidateOptions {
  SceneChoice choice{};
  std::vector<std::uint64_t> seeds{};          ///< ascending, each once
  int jobs{0};                                 ///< 0: as many as there are processors
  double confidence{0.95};                     ///< of every interval
  double rate{1.0};                            ///< of seeds that must keep a limit; 1: every seed
  std::string intervals{"clopper-pearson"};    ///< of rates: clopper-pearson, wilson
  std::optional<std::filesystem::path> out{};  ///< none: default_validation_folder()
  bool force{false};
  bool resume{false};
  std::optional<std::filesystem::path> junit{};
  int worst{3};  ///< seeds to run again with pictures. Chosen: a look each for three different troubles
  bool pictures{true};
};
[[nodiscard]] Command make_validate_command(Deed<ValidateOptions> deed);

struct ReplayOptions {
  std::filesystem::path journal;
};
[[nodiscard]] Command make_replay_command(Deed<ReplayOptions> deed);

struct ShowOptions {
  SceneChoice choice{};
  bool robot{false};  ///< what the robot is told, as a robot file
};
[[nodiscard]] Command make_show_command(Deed<ShowOptions> deed);

struct BoundOptions {
  SceneChoice choice{};
  bool images{false};  ///< also what image sources leave to the best linear estimator
};
[[nodiscard]] Command make_bound_command(Deed<BoundOptions> deed);

struct RenderOptions {
  SceneChoice choice{};
  std::optional<std::filesystem::path> out{};  ///< none: <scene>.png in the working directory
  bool force{false};
  std::string view{"top"};       ///< top, oblique
  int width_px{1600};            ///< chosen: sharp on a README's two columns
  std::string renderer{"auto"};  ///< auto, osmesa, egl
};
[[nodiscard]] Command make_render_command(Deed<RenderOptions> deed);

struct ImportOptions {
  std::filesystem::path map;                   ///< the YAML of a map_server map
  std::optional<std::filesystem::path> out{};  ///< none: <map>.scene.yaml in the working directory
  bool force{false};
  double tile_m{0.508};  ///< carpet tiles, 20 inches (SensoBot, section IV)
};
[[nodiscard]] Command make_import_command(Deed<ImportOptions> deed);

struct EpsilonOptions {
  std::vector<std::string> explorers{};  ///< none: the study's own choice
  int maps_per_cell{1000};               ///< SensoBot, section V
  std::uint64_t seed{1};
  int jobs{0};                                 ///< 0: as many as there are processors
  std::string knowledge{"adjacent"};           ///< adjacent, bump: what the robot knows of blocked neighbours
  std::optional<std::filesystem::path> out{};  ///< CSV of all cells
  std::optional<std::filesystem::path>
      chart{};  ///< heat map of the first explorer's cells, as the paper counts
  bool force{false};
};
[[nodiscard]] Command make_epsilon_command(Deed<EpsilonOptions> deed);

struct CalibrateOptions {
  std::vector<std::filesystem::path> logs{};
  std::optional<std::filesystem::path> distances{};
  std::optional<std::filesystem::path> hop_table{};
  std::string band{"902.75:0.5:50"};  ///< FCC (47 CFR 15.247)
  std::string phase{"falls"};         ///< falls, rises: with distance (data study, 3.2: R420)
  int starts{200};                    ///< chosen: real logs need some ten (docs/calibrate.md)
  int resamples{200};                 ///< chosen: the ends of an interval to a tenth of its width
  std::uint64_t seed{1};
  std::optional<std::filesystem::path> out{};    ///< YAML profile
  std::optional<std::filesystem::path> chart{};  ///< PNG
  bool force{false};
};
[[nodiscard]] Command make_calibrate_command(Deed<CalibrateOptions> deed);

struct ChartOptions {
  std::vector<std::filesystem::path> runs{};   ///< folders of runs
  std::optional<std::filesystem::path> out{};  ///< none: tags_over_time.png in the working directory
  bool force{false};
  bool paper_marks{false};  ///< SensoBot, section V: 69, 42 and 26 minutes
};
[[nodiscard]] Command make_chart_command(Deed<ChartOptions> deed);

/// What `twin list` can list.
struct ListEntry {
  std::string name;
  std::string summary;
};
struct ListTopic {
  std::string name;  ///< plural: "scenes"
  std::string summary;
  std::function<std::vector<ListEntry>()> entries;
};
[[nodiscard]] Command make_list_command(std::vector<ListTopic> topics);
/// The scenes in the first of `folders` that exists, by name.
[[nodiscard]] std::vector<std::filesystem::path> scene_files(
    const std::vector<std::filesystem::path>& folders);
/// Of scene_files(): each file's name and first comment line.
[[nodiscard]] ListTopic scenes_topic(std::vector<std::filesystem::path> folders);
/// Figures that `expect:` may ask for.
[[nodiscard]] ListTopic figures_topic();
[[nodiscard]] ListTopic exit_codes_topic();

/// One thing that `twin doctor` looks at.
struct ProbeResult {
  bool ok{false};
  std::string detail;  ///< what was found, or what to do about it
};
struct Probe {
  std::string name;
  bool required{true};  ///< else merely told
  std::function<ProbeResult()> look;
};
[[nodiscard]] Command make_doctor_command(std::vector<Probe> probes);
/// Libraries, the font of the pictures, pseudo-terminals, the card service. Add the renderers' own to these.
[[nodiscard]] std::vector<Probe> machine_probes();

}  // namespace sensotwin::twin
