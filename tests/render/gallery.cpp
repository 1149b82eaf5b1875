// SPDX-License-Identifier: MIT
/// Every kind of picture that render/ makes, from a made-up house, for the eye: render_gallery FOLDER
/// [osmesa|egl]
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "made_up_house.hpp"
#include "made_up_run.hpp"
#include "render/mapping_pictures.hpp"
#include "render/offscreen_context.hpp"
#include "render/phase_charts.hpp"
#include "render/phase_pictures.hpp"
#include "render/png_writer.hpp"
#include "robot/base/random.hpp"

namespace {

using namespace sensotwin::render;           // NOLINT: a program of one page
using namespace sensotwin::render::testing;  // NOLINT

bool write(const std::filesystem::path& path, const char* data, std::size_t size) {
  std::ofstream file(path, std::ios::binary);
  file.write(data, static_cast<std::streamsize>(size));
  return static_cast<bool>(file);
}

template <class T>
bool save(const std::filesystem::path& path, const Rendered<T>& picture, const std::string& renderer) {
  if (!picture) {
    std::fprintf(stderr, "%s: %s\n", path.c_str(), picture.error().message.c_str());
    return false;
  }
  const auto png = encode_png(picture->image, {"SensoTwin", provenance("made-up-house", 7, renderer)});
  return png && write(path, reinterpret_cast<const char*>(png->data()), png->size());
}

HeatmapChart epsilon_surface() {
  HeatmapChart chart;
  chart.frame = {"Revisits of IDFM over obstacles",
                 "18 x 18 tags · the paper's plane, not a measurement",
                 {"obstacle blocks Bd", false, {}},
                 {"obstacles Bp (%)", false, {}},
                 1600,
                 800};
  chart.value_label = "epsilon (%)";
  for (int bd = 1; bd <= 16; ++bd) {
    chart.columns.push_back(std::to_string(bd));
  }
  for (int bp = 5; bp <= 30; bp += 5) {
    chart.rows.push_back(std::to_string(bp));
    for (int bd = 1; bd <= 16; ++bd) {
      chart.values.push_back(std::max(0.0, 0.0765 * bp + 0.4869 * bd - 0.3437));
    }
  }
  return chart;
}

Histogram error_histogram() {
  Histogram chart;
  chart.frame = {"Heading error of the compass",
                 "10 000 made-up draws",
                 {"error (degrees)", false, {}},
                 {"draws", false, {}},
                 1600,
                 900};
  auto random = sensotwin::robot::RandomStream{7}.fork("compass");
  for (int i = 0; i < 10000; ++i) {
    chart.values.push_back(random.normal(0.3, 1.0));
  }
  chart.bins = 48;
  chart.reference_lines.push_back({0.3, true, "mean 0.3", palette::kInk});
  return chart;
}

LineChart log_chart() {
  LineChart chart;
  chart.frame = {"Error falls with the square root of the number of runs",
                 "made-up numbers",
                 {"runs", true, {}},
                 {"error (cm)", true, {}},
                 1600,
                 900};
  Series line{"1 / sqrt(n)", palette::kBlue, {}, SeriesStyle::kLine, 3.5, true, ""};
  Series dots{"measured", palette::kVermilion, {}, SeriesStyle::kMarkers, 3.5, false, ""};
  auto random = sensotwin::robot::RandomStream{7}.fork("dots");
  for (double n = 1.0; n <= 10000.0; n *= 2.0) {
    line.points.push_back({n, 30.0 / std::sqrt(n)});
    dots.points.push_back({n, 30.0 / std::sqrt(n) * std::exp(random.normal(0.0, 0.15))});
  }
  chart.series = {line, dots};
  return chart;
}

}  // namespace

namespace {

/// Everything about ceiling tags and phases.
bool save_phase_pictures(const std::filesystem::path& folder, OffscreenContext& gl) {
  bool ok = true;
  SceneView open = made_up_ceiling();
  open.walls.clear();
  const auto keep = [&](const char* name, const auto& picture) {
    ok = save(folder / (std::string("phase_") + name + ".png"), picture, "cairo") && ok;
  };
  keep("line", draw_phase_sheet(made_up_line()));
  keep("star", draw_phase_sheet(made_up_star()));
  keep("hallway", draw_phase_sheet(made_up_hallway()));
  keep("circle", draw_phase_sheet(made_up_circle()));
  keep("hall", draw_phase_sheet(made_up_hall()));
  keep("plan", draw_phase_plan(made_up_hallway()));
  keep("error", draw_tracking_error(made_up_star()));
  keep("estimates", draw_estimates_sheet(made_up_hallway()));
  keep("estimates_hall", draw_estimates_sheet(made_up_hall()));
  keep("oblique", draw_oblique_view(gl, made_up_ceiling()));
  keep("oblique_hall", draw_oblique_view(gl, made_up_ceiling(made_up_hall(), 500.0, 21)));
  keep("oblique_star", draw_oblique_view(gl, made_up_ceiling(made_up_star(), 70.0, 3)));
  keep("oblique_open", draw_oblique_view(gl, open));
  keep("top", draw_top_view(gl, made_up_ceiling()));
  keep("noise", draw_noise(made_up_noise()));
  keep("controller", draw_controller(made_up_controller()));
  return ok;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: render_gallery FOLDER [osmesa|egl]\n");
    return 2;
  }
  const std::string wanted = argc > 2 ? argv[2] : "auto";
  auto context = make_context(wanted == "egl"      ? Backend::kEgl
                              : wanted == "osmesa" ? Backend::kOsMesa
                                                   : Backend::kAuto);
  if (!context) {
    std::fprintf(stderr, "%s\n", context.error().message.c_str());
    return 69;
  }
  OffscreenContext& gl = **context;
  std::fprintf(stderr, "%s\n", gl.renderer().c_str());
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);

  ProgressSheet sheet{"The floor plan grows", "as figure 6 of the paper", "made-up-house", 7, {}, 1600};
  for (const double share : {0.05, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    SceneView plan = made_up_house(share);
    sheet.frames.push_back({share * 26.0 * 60.0, plan});
  }
  SceneView recovered = made_up_house();
  recovered.title = "Recovered floor plan over the true one";
  recovered.trajectory.clear();
  recovered.robot.reset();
  std::erase_if(recovered.tiles, [](const TileView& tile) { return tile.state == TileState::kBlocked; });
  recovered.tiles[30].state = TileState::kMissed;
  recovered.tiles[84].state = TileState::kWrong;
  for (TileView& tile : recovered.tiles) {
    tile.center_m += Vec2{0.03, -0.02};
    tile.yaw_rad = 0.004;
  }
  bool ok = save(folder / "floorplan.png", draw_top_view(gl, made_up_house()), gl.renderer());
  ok = save(folder / "everything.png", draw_top_view(gl, house_with_everything()), gl.renderer()) && ok;
  ok = save(folder / "oblique.png", draw_oblique_view(gl, made_up_house(0.7)), gl.renderer()) && ok;
  ok = save(folder / "oblique_everything.png", draw_oblique_view(gl, house_with_everything()),
            gl.renderer()) &&
       ok;
  ok = save(folder / "progress.png", draw_progress_sheet(gl, sheet), gl.renderer()) && ok;
  ok = save(folder / "recovered.png", draw_recovered_plan(gl, recovered), gl.renderer()) && ok;
  ok = save(folder / "tags_over_time.png", draw(tags_over_time_chart(made_up_runs())), "cairo") && ok;
  ok = save(folder / "epsilon.png", draw(epsilon_surface()), "cairo") && ok;
  ok = save(folder / "histogram.png", draw(error_histogram()), "cairo") && ok;
  ok = save(folder / "log.png", draw(log_chart()), "cairo") && ok;
  if (const auto svg = draw_svg(tags_over_time_chart(made_up_runs()))) {
    ok = write(folder / "tags_over_time.svg", svg->data(), svg->size()) && ok;
  }
  ok = save_phase_pictures(folder, gl) && ok;
  return ok ? 0 : 70;
}
