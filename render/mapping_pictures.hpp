// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "render/charts.hpp"
#include "render/scene_picture.hpp"

/// The three result figures of SensoBot (figures 5, 6 and 7), drawn from our runs.
namespace sensotwin::render {

/// One explorer's progress on the same house.
struct ExplorerRun {
  std::string name;  ///< "bfm", "dfm", "idfm" in any case get the paper's colours; others are ours
  std::vector<ChartPoint> found;  ///< x: minutes, y: tags found so far, in order of time
};

struct TagsOverTime {
  std::string scene;
  std::uint64_t seed{0};
  std::string subtitle;  ///< added to scene and seed
  int tags_total{0};     ///< 0: no line for it
  std::vector<ExplorerRun> runs;
  /// Marks what the paper prints for its 207 tags: BFM 69, DFM 42, IDFM 26 minutes (section V).
  bool paper_marks{false};
};

/// Figure 5's colours: BFM pink, DFM green, IDFM brown. Ours: blue, then sky, orange, purple by
/// `ours_before`.
[[nodiscard]] Rgba explorer_color(const std::string& name, int ours_before = 0);
/// Figure 5 as a chart to be drawn or changed. Errors come when it is drawn.
[[nodiscard]] LineChart tags_over_time_chart(const TagsOverTime& view);

/// One small plan of figure 6.
struct ProgressFrame {
  double t_s{0.0};
  SceneView plan;  ///< its title and subtitle are not used
};
struct ProgressSheet {
  std::string title;
  std::string subtitle;
  std::string scene;
  std::uint64_t seed{0};
  std::vector<ProgressFrame> frames;  ///< in order of time; six look best
  int width_px{1600};
};
/// Figure 6: the plan at several times, all at one scale, in rows of three with one legend. Errors as
/// draw_top_view(), and kBadView for no frame or more than 24.
[[nodiscard]] Rendered<Picture> draw_progress_sheet(OffscreenContext& context, const ProgressSheet& sheet);

/// Figure 7: the recovered map, see-through, over the true room. `view.tiles` are the recovered tiles, moved
/// into W (with their yaw); kMissed ones are what the truth has and the map has not. Errors as
/// draw_top_view().
[[nodiscard]] Rendered<Picture> draw_recovered_plan(OffscreenContext& context, const SceneView& view,
                                                    int width_px = 1600);

}  // namespace sensotwin::render
