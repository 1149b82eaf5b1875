// SPDX-License-Identifier: MIT
#include "tests/robot/phase/phase_experiments.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace sensotwin::robot::testing {
namespace {

PhaseExperiment make(std::string name, const std::vector<Vec2>& tags_m, std::vector<std::size_t> order,
                     const Pose2& X_WR_start) {
  PhaseExperiment experiment{
      .name = std::move(name), .tags = {}, .order = std::move(order), .X_WR_start = X_WR_start};
  for (std::size_t i = 0; i < tags_m.size(); ++i) {
    experiment.tags.push_back({.epc = experiment_epc(i), .at_m = tags_m[i]});
  }
  return experiment;
}

double distance_to_segment_m(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double part = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - a - part * along).norm();
}

}  // namespace

Epc experiment_epc(std::size_t n) {
  Epc epc;
  epc.bytes = {0xE2, 0x80, 0x11, 0x05, 0x20, 0x00};
  epc.bytes[10] = static_cast<std::uint8_t>((n + 1) >> 8);
  epc.bytes[11] = static_cast<std::uint8_t>((n + 1) & 0xFFu);
  return epc;
}

std::vector<Epc> PhaseExperiment::destinations() const {
  std::vector<Epc> list;
  for (const std::size_t i : order) {
    list.push_back(tags[i].epc);
  }
  return list;
}

PhaseExperiment line_at_90() {
  return make("line at 90", {{0, 0}, {0, 5}}, {0, 1}, {{-5, -5}, kPi / 2});
}

PhaseExperiment line_at_0() {
  return make("line at 0", {{0, 0}, {0, 5}}, {0, 1}, {{-5, -5}, 0.0});
}

PhaseExperiment star() {
  std::vector<Vec2> tags_m;
  for (int i = 0; i < 5; ++i) {
    const double angle = rad_from_deg(90.0 + 144.0 * i);
    tags_m.emplace_back(3.0 * std::cos(angle), 3.0 * std::sin(angle));
  }
  return make("star", tags_m, {0, 1, 2, 3, 4, 0}, {{0, 3}, -kPi / 2});
}

PhaseExperiment triangle() {
  return make("triangle", {{0, 3}, {-2.5, -2}, {2.5, -2}}, {0, 1, 2, 0}, {{0, 3}, -kPi / 2});
}

PhaseExperiment zigzag() {
  return make("zigzag", {{0, 3}, {0, -3}, {4, 3}, {4, -3}}, {0, 1, 2, 3}, {{0, 3}, -kPi / 2});
}

PhaseExperiment hallway() {
  return make("hallway", {{0, 0}, {8, 0}, {8, 6}, {16, 6}, {16, -2}, {24, -2}, {24, 4}},
              {0, 1, 2, 3, 4, 5, 6}, {{0, 0}, 0.0});
}

PhaseExperiment homing(double reach_m, std::uint64_t seed) {
  RandomStream random = RandomStream{seed}.fork("homing");
  const double x = random.uniform(-reach_m, reach_m);
  const double y = random.uniform(-reach_m, reach_m);
  return make("homing", {{0, 0}}, {0}, {{x, y}, random.uniform(-kPi, kPi)});
}

double PathScore::error_m(std::size_t leg, const Vec2& p_W_m) const {
  assert(leg >= 1 && leg < experiment_.order.size());
  const Vec2& from = experiment_.tags[experiment_.order[leg - 1]].at_m;
  const Vec2 along = (experiment_.tags[experiment_.order[leg]].at_m - from).normalized();
  const Vec2 off = p_W_m - from;
  return along.x() * off.y() - along.y() * off.x();
}

void PathScore::sample(std::size_t leg, const Vec2& p_W_m) {
  if (leg == 0 || leg >= experiment_.order.size()) {
    return;
  }
  const double error = error_m(leg, p_W_m);
  ++samples_;
  squares_m2_ += error * error;
  min_m_ = std::min(min_m_, error);
  max_m_ = std::max(max_m_, error);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < experiment_.order.size(); ++i) {
    nearest = std::min(nearest, distance_to_segment_m(p_W_m, experiment_.tags[experiment_.order[i - 1]].at_m,
                                                      experiment_.tags[experiment_.order[i]].at_m));
  }
  nearest_squares_m2_ += nearest * nearest;
}

double PathScore::rmse_m() const {
  return samples_ > 0 ? std::sqrt(squares_m2_ / samples_) : 0.0;
}

double PathScore::nearest_rms_m() const {
  return samples_ > 0 ? std::sqrt(nearest_squares_m2_ / samples_) : 0.0;
}

}  // namespace sensotwin::robot::testing
