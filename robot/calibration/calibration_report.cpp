// SPDX-License-Identifier: MIT
#include "robot/calibration/calibration_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "robot/base/geometry.hpp"

namespace sensotwin::robot {
namespace {

/// As well as wheels need to be known: a fifth of what missions reckon with (algorithms study, C.2: 1 %).
constexpr double kWanted = 2e-3;
/// An antenna's place is replaced by the fitted one when that is known so well. Chosen: what a ruler can do.
constexpr double kRuler_m = 0.005;
/// Above, an offset is learned on the way (AntennaMount).
constexpr double kKnown_rad = 1.0;

/// What a run is told of the base: by the tags where they were driven over, else by the compass.
std::optional<Measured> base_of(const CalibrationResult& result) {
  return result.wheels ? std::optional{result.wheels->wheel_base_m} : result.turned_base_m;
}

Measured diameter_of(const WheelFit& wheels, const RobotSettings& told) {
  const double factor = told.base.counts_per_turn / kPi;
  return {wheels.metres_per_count.value * factor, wheels.metres_per_count.sigma * factor};
}

std::string line(int indent, std::string_view key, const Measured& figure, int digits) {
  return fmt::format("{:{}}{}: {:.{}f}  # one sigma {:.{}f}\n", "", indent, key, figure.value, digits,
                     figure.sigma, digits);
}

Measured not_negative(const Measured& figure) {
  return {std::max(0.0, figure.value), figure.sigma};
}

std::string wheel_lines(const CalibrationResult& result, const RobotSettings& told) {
  std::string text;
  if (const auto base = base_of(result)) {
    text += "  base:\n" + line(4, "wheel_base_m", *base, 5);
  }
  if (result.wheels) {
    text += line(4, "wheel_diameter_m", diameter_of(*result.wheels, told), 6);
    text += line(4, "wheel_ratio", result.wheels->wheel_ratio, 5);
    text += "  floor_reader:\n" + line(4, "read_radius_m", result.wheels->read_radius_m, 4);
    text += line(4, "notice_delay_s", not_negative(result.wheels->notice_delay_s), 3);
  }
  return text;
}

std::string antenna_lines(const AntennaFit& fit, const RobotSettings& told) {
  std::string text = "  uhf_reader:\n    antennas:\n";
  for (const FittedPort& port : fit.ports) {
    const AntennaMount& mount = told.uhf_reader.antennas[port.port - 1];
    const bool placed = std::max(port.forward_m.sigma, port.left_m.sigma) < kRuler_m;
    text += fmt::format("      # port {}: {} reads\n", port.port, port.reads);
    text += fmt::format("      - at_m: [{:.4f}, {:.4f}, {:.4f}]{}\n",
                        placed ? port.forward_m.value : mount.at_R_m.x(),
                        placed ? port.left_m.value : mount.at_R_m.y(), mount.at_R_m.z(),
                        placed ? "  # one sigma below 5 mm" : "  # as told");
    text += fit.delays_known ? fmt::format("        cable_delay_s: {:.3e}  # one sigma {:.1e}\n",
                                           not_negative(port.cable_delay_s).value, port.cable_delay_s.sigma)
                             : fmt::format("        cable_delay_s: {:.3e}  # as told\n", mount.cable_delay_s);
    text += fmt::format("        phase_offset_rad: {:.4f}\n        phase_offset_sigma_rad: {:.4f}\n",
                        port.phase_offset_rad.value, port.phase_offset_rad.sigma);
  }
  return text;
}

std::string about_wheels(const WheelFit& fit, const RobotSettings& told) {
  const std::size_t laps = std::min(fit.laps[0], fit.laps[1]);
  std::string text = fmt::format(
      "wheels, by {} crossings of tags in {} + {} laps:\n"
      "  wheel base {:+.2f} %, diameters {:+.2f} %, right over left {:+.3f} %\n"
      "  a lap closes within {:.0f} mm as told, {:.0f} mm as measured\n",
      fit.crossings, fit.laps[0], fit.laps[1],
      100.0 * (fit.wheel_base_m.value / told.base.wheel_base_m - 1.0),
      100.0 * (diameter_of(fit, told).value / told.base.wheel_diameter_m - 1.0),
      100.0 * (fit.wheel_ratio.value - 1.0), 1e3 * fit.closure.before_m, 1e3 * fit.closure.after_m);
  // Where the tags lie does not become better by driving over them again.
  const double laps_part = fit.relative_sigma_of_laps;
  const double tags_part = std::sqrt(std::max(0.0, std::pow(fit.relative_sigma, 2) - std::pow(laps_part, 2)));
  text += fmt::format("  known to {:.2f} %: {:.2f} % of it by the laps, {:.2f} % by how the tags were laid\n",
                      100.0 * fit.relative_sigma, 100.0 * laps_part, 100.0 * tags_part);
  if (laps_part > kWanted) {
    text +=
        fmt::format("  {:.0f} laps each way would make the first {:.1f} %\n",
                    std::ceil(static_cast<double>(laps) * std::pow(laps_part / kWanted, 2)), 100.0 * kWanted);
  }
  if (tags_part > kWanted) {
    text += "  a side twice as long (--side) would halve the second\n";
  }
  if (fit.outliers > 0) {
    text += fmt::format("  {} crossings fit nowhere and count little\n", fit.outliers);
  }
  return text;
}

std::string about_antennas(const AntennaFit& fit) {
  std::string text =
      fmt::format("antennas, on {} channels over {:.1f} MHz; phases {:.2f} rad from the fit:\n", fit.channels,
                  fit.band_hz * 1e-6, fit.spread_rad);
  for (const FittedPort& port : fit.ports) {
    text += fmt::format("  port {}: offset {:+.3f} rad, one sigma {:.3f}", port.port,
                        port.phase_offset_rad.value, port.phase_offset_rad.sigma);
    if (fit.delays_known) {
      text += fmt::format("; delay {:.1f} ns, one sigma {:.1f}", 1e9 * port.cable_delay_s.value,
                          1e9 * port.cable_delay_s.sigma);
    }
    text += port.phase_offset_rad.sigma > kKnown_rad ? "; missions learn it on the way\n" : "\n";
  }
  if (!fit.delays_known) {
    text += "  too few channels to tell delays from offsets: they stay as they are\n";
  }
  return text;
}

}  // namespace

std::string calibration_yaml(const CalibrationResult& result, const RobotSettings& told,
                             std::string_view about) {
  std::string text = wheel_lines(result, told);
  if (result.antennas) {
    text += antenna_lines(*result.antennas, told);
  }
  return text.empty() ? "" : fmt::format("# {}\nrobot:\n{}", about, text);
}

std::string calibration_text(const CalibrationResult& result, const RobotSettings& told) {
  std::string text;
  if (result.turned_base_m) {
    text += fmt::format("wheel base by the compass: {:.5f} m, left and right {:.5f} m from it\n",
                        result.turned_base_m->value, result.turned_base_m->sigma);
  }
  if (result.wheels) {
    text += about_wheels(*result.wheels, told);
  }
  if (result.antennas) {
    text += about_antennas(*result.antennas);
  }
  return text;
}

std::string calibration_json(const CalibrationResult& result, const RobotSettings& told) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  const auto add = [](nlohmann::ordered_json& to, const char* key, const Measured& figure) {
    to[key] = {{"value", figure.value}, {"sigma", figure.sigma}};
  };
  if (result.turned_base_m) {
    add(json, "wheel_base_by_compass_m", *result.turned_base_m);
  }
  if (result.wheels) {
    const WheelFit& fit = *result.wheels;
    add(json, "wheel_base_m", fit.wheel_base_m);
    add(json, "wheel_diameter_m", diameter_of(fit, told));
    add(json, "wheel_ratio", fit.wheel_ratio);
    add(json, "read_radius_m", fit.read_radius_m);
    add(json, "notice_delay_s", fit.notice_delay_s);
    json["closure_before_m"] = fit.closure.before_m;
    json["closure_after_m"] = fit.closure.after_m;
    json["laps"] = fit.laps[0] + fit.laps[1];
    json["crossings"] = fit.crossings;
    json["outliers"] = fit.outliers;
    json["misfit"] = fit.misfit;
  }
  if (result.antennas) {
    const AntennaFit& fit = *result.antennas;
    json["channels"] = fit.channels;
    json["spread_rad"] = fit.spread_rad;
    json["ports"] = nlohmann::ordered_json::array();
    for (const FittedPort& port : fit.ports) {
      nlohmann::ordered_json entry{{"port", port.port}, {"reads", port.reads}};
      add(entry, "forward_m", port.forward_m);
      add(entry, "left_m", port.left_m);
      if (fit.delays_known) {
        add(entry, "cable_delay_s", port.cable_delay_s);
      }
      add(entry, "phase_offset_rad", port.phase_offset_rad);
      json["ports"].push_back(entry);
    }
  }
  return json.dump(2) + "\n";
}

}  // namespace sensotwin::robot
