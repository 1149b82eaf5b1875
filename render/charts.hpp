// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/canvas.hpp"
#include "render/error.hpp"

/// Charts by cairo: PNG pixels and SVG from one code. Data space is x right, y up, in the units the labels
/// name.
namespace sensotwin::render {

struct ChartPoint {
  double x{0.0};
  double y{0.0};
};

struct ChartRange {
  double low{0.0};
  double high{1.0};
};

struct Axis {
  std::string label;  ///< with its unit: "time (min)"
  bool log{false};
  std::optional<ChartRange> range;  ///< from the data when absent
};

enum class SeriesStyle : std::uint8_t {
  kLine,     ///< straight from point to point
  kStep,     ///< holds each value until the next point
  kMarkers,  ///< discs, no line
};

struct Series {
  std::string name;  ///< in the legend; none when empty
  Rgba color{palette::kBlue};
  std::vector<ChartPoint> points;
  SeriesStyle style{SeriesStyle::kLine};
  double width_px{3.5};  ///< in a chart 1600 pixels wide
  bool dashed{false};
  std::string end_label;        ///< at the last point; none when empty
  bool end_label_above{false};  ///< above it, where many series end at one height; else to its right
};

/// A hollow mark: a value from elsewhere, to compare with.
struct ReferencePoint {
  ChartPoint at;
  Rgba color{palette::kSoftInk};
  std::string label;  ///< below the mark; none when empty
};

/// A dashed line across the plot.
struct ReferenceLine {
  double value{0.0};
  bool vertical{false};
  std::string label;
  Rgba color{palette::kSoftInk};
};

/// What every chart has.
struct ChartFrame {
  std::string title;
  std::string subtitle;  ///< scene, seed, conditions
  Axis x;
  Axis y;
  int width_px{1600};
  int height_px{1000};
};

struct LineChart {
  ChartFrame frame;
  std::vector<Series> series;
  std::vector<ReferencePoint> reference_points;
  std::vector<ReferenceLine> reference_lines;
  std::string references_name;  ///< legend line of the hollow marks; none when empty
};

/// A grid of cells coloured and written with their values.
struct HeatmapChart {
  ChartFrame frame;                  ///< axis ranges and logs are not used: columns and rows have names
  std::string value_label;           ///< of the colour scale, with its unit
  std::vector<std::string> columns;  ///< left to right
  std::vector<std::string> rows;     ///< bottom to top
  std::vector<double> values;        ///< rows.size() x columns.size(), bottom row first
  int decimals{1};
  std::optional<ChartRange> range;  ///< of the colours; from the values when absent
};

struct Histogram {
  ChartFrame frame;
  std::vector<double> values;
  int bins{24};
  Rgba color{palette::kSky};
  std::vector<ReferenceLine> reference_lines;
};

/// A finished chart and where in it the data are.
struct Chart {
  Image image;
  RectPx plot;
  Axis x;  ///< with the range that was used
  Axis y;
  /// Pixel of a data point.
  [[nodiscard]] Vec2 pixel(const ChartPoint& p) const;
};

/// \returns kBadView, naming the series, for a value that is not finite, or not positive on a logarithmic
/// axis, and for sizes as size_fault() says. No series, or series without points, give an empty chart.
[[nodiscard]] Rendered<Chart> draw(const LineChart& chart);
[[nodiscard]] Rendered<std::string> draw_svg(const LineChart& chart);
/// \returns kBadView also when values are not rows x columns.
[[nodiscard]] Rendered<Chart> draw(const HeatmapChart& chart);
[[nodiscard]] Rendered<std::string> draw_svg(const HeatmapChart& chart);
/// \returns kBadView also for fewer than one or more than 1000 bins.
[[nodiscard]] Rendered<Chart> draw(const Histogram& chart);
[[nodiscard]] Rendered<std::string> draw_svg(const Histogram& chart);

}  // namespace sensotwin::render
