// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/charts.hpp"

namespace sensotwin::render {

/// A limit that a distribution is held against.
struct DistributionLimit {
  double value{0.0};
  bool upper{true};     ///< a maximum, else a minimum
  bool of_each{true};   ///< of each value: those beyond it are drawn in another colour
  std::string label{};  ///< "at most 5"
  Rgba color{palette::kVermilion};
};

/// Something said of a distribution: a line above it, with a bar below the words when it has an interval.
struct DistributionRow {
  std::string text;
  Rgba color{palette::kGreen};
  /// On the axis of the values. An end that is infinite runs to the edge, with an arrow.
  std::optional<ChartRange> interval{};
  double estimate{0.0};           ///< a disc on the interval; only with one
  std::optional<double> limit{};  ///< a tick on the interval's line
};

/// Values as a histogram, limits across it, and what follows from them in rows above. Bars are one wide where
/// all values are whole numbers that lie near each other, else as Freedman and Diaconis advise (Z. Wahrsch.
/// 57(4), 1981), 8 to 60 of them. A limit far outside the values does not flatten them: it becomes an arrow
/// at the edge.
struct DistributionChart {
  ChartFrame
      frame;  ///< its ranges and logs are not used; the height is that of the histogram, rows come on top
  std::vector<double> values;
  std::vector<DistributionLimit> limits;
  std::vector<DistributionRow> rows;
};

/// \returns kBadView for a value, limit or estimate that is not finite, for a chart without values, and for
/// sizes as size_fault() says.
[[nodiscard]] Rendered<Chart> draw(const DistributionChart& chart);
[[nodiscard]] Rendered<std::string> draw_svg(const DistributionChart& chart);

}  // namespace sensotwin::render
