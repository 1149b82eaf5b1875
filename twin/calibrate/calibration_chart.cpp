// SPDX-License-Identifier: MIT
#include "twin/calibrate/calibration_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

#include "render/charts.hpp"
#include "robot/base/geometry.hpp"

namespace sensotwin::twin {
namespace {

constexpr std::size_t kLinesShown = 4;  ///< chosen: as many as the legend holds
constexpr std::array kLineColors = {render::palette::kBlue, render::palette::kVermilion,
                                    render::palette::kGreen, render::palette::kOrange, render::palette::kInk};

render::LineChart noise_chart(const Calibration& c) {
  render::LineChart chart;
  chart.frame.title = "Phase noise from read to read";
  chart.frame.subtitle =
      fmt::format("{} links of {} logs · seed {}", c.noise.points.size(), c.logs.size(), c.settings.seed);
  chart.frame.x.label = "RSSI (dBm)";
  chart.frame.y.label = "noise (rad)";
  chart.frame.y.log = true;
  render::Series measured{.name = "measured",
                          .color = render::palette::kInk,
                          .points = {},
                          .style = render::SeriesStyle::kMarkers,
                          .end_label = {}};
  double low_dbm = 0.0;
  double high_dbm = -100.0;
  for (const NoisePoint& point : c.noise.points) {
    measured.points.push_back({point.rssi_dbm, point.sigma_rad});
    low_dbm = std::min(low_dbm, point.rssi_dbm);
    high_dbm = std::max(high_dbm, point.rssi_dbm);
  }
  if (const auto& fit = c.noise.by_rssi) {
    render::Series law{.name = "law by RSSI", .color = render::palette::kBlue, .points = {}, .end_label = {}};
    for (double dbm = low_dbm; dbm <= high_dbm; dbm += 0.5) {
      law.points.push_back({dbm, noise_by_rssi_rad(fit->parameters[0].value, fit->parameters[1].value, dbm)});
    }
    chart.series.push_back(law);
  }
  const auto add_predicted = [&](const char* name, render::Rgba color,
                                 const std::optional<NoiseLawFit>& fit) {
    if (!fit) {
      return;
    }
    render::Series predicted{
        .name = name, .color = color, .points = {}, .style = render::SeriesStyle::kMarkers, .end_label = {}};
    std::size_t next = 0;
    for (const NoisePoint& point : c.noise.points) {
      if (point.distance_m) {
        predicted.points.push_back({point.rssi_dbm, fit->predicted_rad[next++]});
      }
    }
    chart.series.push_back(predicted);
  };
  add_predicted("proportional to distance", render::palette::kOrange, c.noise.proportional);
  add_predicted("offset + proportional", render::palette::kGreen, c.noise.offset);
  chart.series.push_back(measured);
  return chart;
}

/// The strong links that reach from the shortest delay to the longest.
std::vector<LinkLine> shown_lines(const Calibration& c) {
  std::vector<LinkLine> strong;
  std::copy_if(c.lines.begin(), c.lines.end(), std::back_inserter(strong),
               [](const LinkLine& line) { return line.strong; });
  std::stable_sort(strong.begin(), strong.end(),
                   [](const LinkLine& a, const LinkLine& b) { return a.line.delay_s < b.line.delay_s; });
  std::vector<LinkLine> shown;
  const std::size_t count = std::min(kLinesShown, strong.size());
  for (std::size_t i = 0; i < count; ++i) {
    shown.push_back(strong[count > 1 ? i * (strong.size() - 1) / (count - 1) : 0]);
  }
  return shown;
}

/// Phase of one link less its constant, put on the turn that its line says.
void add_line(render::LineChart& chart, const Calibration& c, const LinkLine& line, render::Rgba color) {
  const double middle_hz = std::accumulate(c.channels_hz.begin(), c.channels_hz.end(), 0.0) /
                           static_cast<double>(c.channels_hz.size());
  const auto line_rad = [&](double hz) {
    return c.phase_sign * 2.0 * robot::kPi * (hz - middle_hz) * line.line.delay_s;
  };
  const TagLink& link = c.links[line.link];
  std::complex<double> sum;
  for (const auto& [channel, mean] : link.channels) {
    sum += mean * std::polar(1.0, -line_rad(c.channels_hz[static_cast<std::size_t>(channel - 1)]));
  }
  render::Series measured{
      .name = {}, .color = color, .points = {}, .style = render::SeriesStyle::kMarkers, .end_label = {}};
  for (const auto& [channel, mean] : link.channels) {
    const double hz = c.channels_hz[static_cast<std::size_t>(channel - 1)];
    const double rest_rad = std::arg(mean * std::polar(1.0, -line_rad(hz) - std::arg(sum)));
    measured.points.push_back({hz / 1e6, line_rad(hz) + rest_rad});
  }
  std::sort(measured.points.begin(), measured.points.end(),
            [](const render::ChartPoint& a, const render::ChartPoint& b) { return a.x < b.x; });
  const auto [low, high] = std::minmax_element(c.channels_hz.begin(), c.channels_hz.end());
  chart.series.push_back({.name = fmt::format("port {}: {:.1f} ns", link.antenna, 1e9 * line.line.delay_s),
                          .color = color,
                          .points = {{*low / 1e6, line_rad(*low)}, {*high / 1e6, line_rad(*high)}},
                          .width_px = 2.0,
                          .end_label = {}});
  chart.series.push_back(measured);
}

render::LineChart frequency_chart(const Calibration& c) {
  render::LineChart chart;
  chart.frame.title = "Phase against frequency: a pure delay";
  chart.frame.subtitle = c.recovered ? fmt::format("hop table recovered, coherence {:.3f} over {} links",
                                                   c.recovered->coherence, c.recovered->links)
                                     : "hop table as published";
  chart.frame.x.label = "frequency (MHz)";
  chart.frame.y.label = "phase (rad)";
  std::size_t next = 0;
  for (const LinkLine& line : shown_lines(c)) {
    add_line(chart, c, line, kLineColors[next++ % kLineColors.size()]);
  }
  return chart;
}

}  // namespace

render::Rendered<render::Image> draw_calibration(const Calibration& calibration) {
  const auto above = render::draw(noise_chart(calibration));
  if (!above || calibration.lines.empty()) {
    return above ? render::Rendered<render::Image>(above->image)
                 : render::Rendered<render::Image>(robot::Unexpected{above.error()});
  }
  const auto below = render::draw(frequency_chart(calibration));
  if (!below) {
    return robot::Unexpected{below.error()};
  }
  const int split_px = above->image.height_px();
  render::Image both(above->image.width_px(), split_px + below->image.height_px());
  for (int y = 0; y < both.height_px(); ++y) {
    for (int x = 0; x < both.width_px(); ++x) {
      both.at(x, y) = y < split_px ? above->image.at(x, y) : below->image.at(x, y - split_px);
    }
  }
  return both;
}

}  // namespace sensotwin::twin
