// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/charts.hpp"
#include "render/views.hpp"

/// What the pictures of navigation by ceiling tags are made from: plain values in frame W, metres, radians,
/// seconds; only the charts' own axes speak of centimetres.
namespace sensotwin::render {

/// A ceiling tag where it truly hangs, drawn at its projection on the floor.
struct PhaseTagView {
  std::string name;
  Vec2 at_m{0.0, 0.0};
  bool missing{false};  ///< listed by the mission, not there: drawn hollow
};

/// Where the robot believed a tag's projection to be at a time.
struct TagEstimateView {
  std::string name;  ///< of its PhaseTagView
  Vec2 at_m{0.0, 0.0};
  Eigen::Matrix2d covariance_m2{Eigen::Matrix2d::Zero()};
  double t_s{0.0};
};

/// A stretch of the mission, from this time to the next one's.
struct SegmentView {
  double from_s{0.0};
  std::string name;    ///< stands over it on the error chart where it fits: "→ T3", "second lap"
  bool counted{true};  ///< false: the way to the path's start, which no error is counted on
};

/// Signed distance from the ideal path, left of travel positive (algorithms study, A.0).
struct ErrorPoint {
  double t_s{0.0};
  double error_m{0.0};
};

enum class PathColoring : std::uint8_t {
  kTime,     ///< the colours of time, over the part that counts
  kSegment,  ///< one colour for each segment in turn
};

/// Somebody who stands or walks in the way, as a disc.
struct PersonView {
  std::vector<Vec2> path_m;  ///< where they come, and on; of one point: they stand there
  double radius_m{0.22};
};

/// A run along ceiling tags (Gueaieb & Miah, figures 9, 11 and 13), or through hallways.
struct PhaseRunView {
  std::string title;
  std::string subtitle;  ///< figures, in words; may be empty
  std::string scene;
  std::uint64_t seed{0};

  std::vector<WallView> walls;
  std::vector<FurnitureView> furniture;
  std::vector<PersonView> people;
  std::vector<PhaseTagView> tags;
  std::string tags_are{"ceiling tag"};  ///< in the legend
  std::vector<Vec2> ideal_m;            ///< corners of the polyline, or close points of a curve
  bool ideal_closed{false};             ///< from the last point back to the first
  std::vector<TimedPoint> driven;       ///< in order of time
  std::optional<Pose2> start;           ///< of the robot
  std::optional<Pose2> end;             ///< of the robot
  double robot_radius_m{0.17};
  std::vector<SegmentView> segments;  ///< in order of time; none: the whole run is one that counts
  std::vector<ErrorPoint> errors;     ///< in order of time, of the part that counts
  /// As the run reports it (Gueaieb & Miah, equation 4); not stated when absent.
  std::optional<double> rmse_m;
  std::optional<double> bound_m;       ///< posterior Cramer-Rao bound of the same run
  std::optional<double> paper_rmse_m;  ///< what the paper prints for this experiment
  /// In order of time. The last of each name is drawn whole, the others as thin rings.
  std::vector<TagEstimateView> estimates;
  PathColoring coloring{PathColoring::kTime};
};

/// Phase noise against what it depends on: Gueaieb & Miah, figure 7; data study, 3.5.
struct NoisePoint {
  double x{0.0};
  double sigma_rad{0.0};
  /// Confidence interval of sigma; no bar when absent.
  std::optional<ChartRange> interval_rad;
};
struct NoiseSet {
  std::string name;  ///< in the legend: "antenna 1"
  std::vector<NoisePoint> points;
};
struct NoiseLawView {
  std::string name;               ///< in the legend: "0.024 rad/m"
  std::vector<ChartPoint> curve;  ///< x, sigma in rad, by rising x
};
struct NoiseView {
  std::string title;
  std::string subtitle;  ///< scene, seed, log: whatever tells where it comes from
  std::string x_label{"distance from tag to antenna (m)"};
  /// Single reads: x, phase error in rad. May be empty; then only deviations are shown.
  std::vector<ChartPoint> reads;
  std::vector<NoiseSet> measured;
  std::vector<NoiseLawView> laws;  ///< the first one's 2-sigma envelope is drawn over the reads
};

/// A fuzzy set: corners of its membership function, by rising x.
struct FuzzySetView {
  std::string name;
  std::vector<ChartPoint> corners;
  int rule{0};  ///< sets of one rule share a colour: "Neg" of the input and "CCW" of the output
};
struct ControlCurveView {
  std::string name;  ///< in the legend
  std::vector<ChartPoint> points;
};
/// A fuzzy controller of one input and one output: Gueaieb & Miah, figure 5, and what comes of it.
struct FuzzyControllerView {
  std::string title;
  std::string subtitle;
  std::string input_label{"phase difference (rad)"};
  std::string output_label{"turn rate (rad/s)"};
  std::vector<FuzzySetView> inputs;
  std::vector<FuzzySetView> outputs;
  std::vector<ControlCurveView> curves;  ///< the first is the controller shown; others for comparison
};

/// \returns the first number that cannot be drawn as a sentence naming it; nothing when all is well.
[[nodiscard]] std::optional<RenderError> first_fault(const PhaseRunView& view);
[[nodiscard]] std::optional<RenderError> first_fault(const NoiseView& view);
[[nodiscard]] std::optional<RenderError> first_fault(const FuzzyControllerView& view);

/// Around walls, tags, ideal and driven path; not around estimates, which begin wide.
[[nodiscard]] Extent extent_of(const PhaseRunView& view);
/// The part that counts: from the first counted segment to the end of the last one, or of the run. From 0 to
/// 0 for an empty run.
[[nodiscard]] ChartRange counted_span_s(const PhaseRunView& view);

}  // namespace sensotwin::render
