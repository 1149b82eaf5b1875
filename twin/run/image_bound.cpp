// SPDX-License-Identifier: MIT
#include "twin/run/image_bound.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <vector>

#include "robot/base/random.hpp"
#include "robot/phase/estimation/path_shape.hpp"

namespace sensotwin::twin {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Way between two places where phases count. Chosen: an eighth of a wavelength; 2 cm gave the same to 1 %.
constexpr double kSpacing_m = 0.04;
/// Places that share one step of the wheels' noise. Chosen: 12 cm, over which it drifts by a millimetre.
constexpr int kPlacesPerStep = 3;
constexpr int kLooksPerLeg = 20;  ///< at the error, evenly over the way
/// Quadrature over the images' place: so many distances at each bearing, staggered from one to the next by
/// the golden ratio. Chosen: 48 distances gave the same to 1 %.
constexpr int kRanges = 12;
constexpr int kBearings = 360;
constexpr double kGolden = 0.6180339887498949;
constexpr double kNothingKnown_m = 30.0;
constexpr double kNothingKnown_rad = 100.0;
/// States before the tags': scale, turn scale and curvature of the wheels. Each tag: x, y, z, phase.
constexpr int kWheelStates = 3;
constexpr int kTagStates = 4;

/// A place on the ideal way, frame W.
struct Place {
  robot::Pose2 X_WR;
  double way_m{0.0};  ///< driven since the place before
  double turned_rad{0.0};
  double since_s{0.0};
  std::size_t leg{0};
};

/// Turns on the spot, then drives, leg by leg.
std::vector<Place> places_of(const robot::PathBoundTask& path, const robot::PathShape& shape) {
  const double arm_m = path.reader.antennas.front().at_R_m.head<2>().norm();
  std::vector<Place> places{{path.X_WR_start, 0.0, 0.0, 0.0, 0}};
  for (std::size_t leg = 0; leg < shape.legs(); ++leg) {
    for (const robot::Vec2& end : shape.points_m(leg)) {
      const robot::Pose2 from = places.back().X_WR;
      const robot::Vec2 to = end - from.p_m;
      if (to.norm() == 0.0) {
        continue;
      }
      const double yaw_rad = std::atan2(to.y(), to.x());
      const double turn_rad = robot::wrap_angle(yaw_rad - from.yaw_rad);
      const int turns = std::max(1, static_cast<int>(std::lround(std::abs(turn_rad) * arm_m / kSpacing_m)));
      for (int i = 1; i <= turns; ++i) {
        const robot::Pose2 X_WR{from.p_m, robot::wrap_angle(from.yaw_rad + turn_rad * i / turns)};
        places.push_back({X_WR, 0.0, turn_rad / turns, std::abs(turn_rad) / turns / path.turn_radps, leg});
      }
      const int steps = std::max(1, static_cast<int>(std::lround(to.norm() / kSpacing_m)));
      const double step_m = to.norm() / steps;
      for (int i = 1; i <= steps; ++i) {
        const robot::Pose2 X_WR{from.p_m + i * step_m * to.normalized(), yaw_rad};
        places.push_back({X_WR, step_m, 0.0, step_m / path.speed_mps, leg});
      }
    }
  }
  return places;
}

/// Reads of one tag: what they depend on, how sure each is, and where the waves ended.
struct TagReads {
  MatrixXd H;           ///< by the states, each in units of its standard deviation
  VectorXd noise_rad2;  ///< of a place's reads together
  std::vector<Eigen::Vector3d> transmitters_W_m;
  std::vector<Eigen::Vector3d> receivers_W_m;
  std::vector<std::size_t> at;  ///< index of the place
  MatrixXd whitener;            ///< L, of bends and noise: L L' is their covariance
  MatrixXd A;                   ///< L^-1 H
};

/// A look at the error beside the path: how it depends on states and on whitened reads.
struct Look {
  VectorXd by_states;
  std::vector<VectorXd> by_reads;  ///< of each tag, those made until then
};

class ImageStudy {
 public:
  explicit ImageStudy(const ImageBoundTask& task)
      : task_(task),
        k_radpm_(task.path.reader.wave_number(0.0)),
        shape_({.path = robot::TagPathKind::kPolyline}, flat(task.path), task.path.route,
               task.path.X_WR_start.p_m),
        places_(places_of(task.path, shape_)),
        states_(kWheelStates + kTagStates * tags() + 3 * steps()),
        tags_(task.path.tags_m.size()) {}

  ImageBound run() {
    gather();
    for (std::size_t tag = 0; tag < tags_.size(); ++tag) {
      whiten(tag);
    }
    look_along();
    return {rms_m_, median_of_runs()};
  }

 private:
  static std::vector<robot::Vec2> flat(const robot::PathBoundTask& path) {
    std::vector<robot::Vec2> places;
    for (const Eigen::Vector3d& tag : path.tags_m) {
      places.emplace_back(tag.x(), tag.y());
    }
    return places;
  }
  [[nodiscard]] int tags() const { return static_cast<int>(task_.path.tags_m.size()); }
  [[nodiscard]] int steps() const { return static_cast<int>(places_.size()) / kPlacesPerStep + 1; }
  [[nodiscard]] static int tag_state(std::size_t tag) {
    return kWheelStates + kTagStates * static_cast<int>(tag);
  }

  /// X_WR's error at the next place, by the states.
  void advance(const Place& place, std::size_t index, MatrixXd& error) const {
    const robot::WheelModel& wheels = task_.path.wheels;
    const double c = std::cos(place.X_WR.yaw_rad);
    const double s = std::sin(place.X_WR.yaw_rad);
    error.row(0) -= place.way_m * s * error.row(2);
    error.row(1) += place.way_m * c * error.row(2);
    error(0, 0) += wheels.scale_sigma * place.way_m * c;
    error(1, 0) += wheels.scale_sigma * place.way_m * s;
    error(2, 1) += wheels.turn_scale_sigma * place.turned_rad;
    error(2, 2) += wheels.curvature_sigma_rad_per_m * place.way_m;
    if (index % kPlacesPerStep != 0 && place.turned_rad == 0.0) {
      return;
    }
    const int step = kWheelStates + kTagStates * tags() + 3 * static_cast<int>(index / kPlacesPerStep);
    const double root_m = std::sqrt(kPlacesPerStep * place.way_m);
    error(0, step) += wheels.along_sigma_m * root_m * c;
    error(1, step) += wheels.along_sigma_m * root_m * s;
    error(0, step + 1) -= wheels.across_sigma_m * root_m * s;
    error(1, step + 1) += wheels.across_sigma_m * root_m * c;
    error(2, step + 2) += std::hypot(wheels.heading_sigma_rad * root_m,
                                     wheels.turn_sigma_rad * std::sqrt(std::abs(place.turned_rad)));
  }

  void gather() {
    const robot::PathBoundTask& path = task_.path;
    const auto reads = static_cast<Eigen::Index>(places_.size() * path.reader.antennas.size());
    for (TagReads& tag : tags_) {
      tag.H = MatrixXd::Zero(reads, states_);
      tag.noise_rad2 = VectorXd::Zero(reads);
    }
    MatrixXd error = MatrixXd::Zero(3, states_);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (i > 0) {
        advance(places_[i], i, error);
      }
      errors_.push_back(error);
      for (std::size_t tag = 0; tag < tags_.size(); ++tag) {
        for (std::size_t port = 0; port < path.reader.antennas.size(); ++port) {
          add_read(i, tag, port, error);
        }
      }
    }
  }

  void add_read(std::size_t i, std::size_t tag, std::size_t port, const MatrixXd& error) {
    const robot::PathBoundTask& path = task_.path;
    TagReads& reads = tags_[tag];
    const auto row = static_cast<Eigen::Index>(reads.at.size());
    const robot::WayEnds ends = robot::way_ends(path.reader, port, {});
    const robot::Pose2& X_WR = places_[i].X_WR;
    const robot::WayLength way = robot::way_length(ends, X_WR, path.tags_m[tag]);
    const int j = tag_state(tag);
    reads.H.row(row) = k_radpm_ * (way.by_pose.transpose() * error);
    reads.H(row, j) += k_radpm_ * way.by_tag.x() * kNothingKnown_m;
    reads.H(row, j + 1) += k_radpm_ * way.by_tag.y() * kNothingKnown_m;
    reads.H(row, j + 2) += k_radpm_ * way.by_tag.z() * path.height_sigma_m;
    reads.H(row, j + 3) += kNothingKnown_rad;
    const double rounds = std::max(places_[i].since_s, robot::to_s(robot::kTick)) * path.rate_hz;
    reads.noise_rad2(row) = path.reader.noise.variance(way.slant_m, 0.0) / rounds;
    reads.transmitters_W_m.push_back(in_world(X_WR, ends.transmitter_R_m));
    reads.receivers_W_m.push_back(in_world(X_WR, ends.receiver_R_m));
    reads.at.push_back(i);
  }

  static Eigen::Vector3d in_world(const robot::Pose2& X_WR, const Eigen::Vector3d& p_R_m) {
    const robot::Vec2 flat = X_WR * robot::Vec2{p_R_m.x(), p_R_m.y()};
    return {flat.x(), flat.y(), p_R_m.z()};
  }

  /// The way to an image is longer by this, in radians.
  [[nodiscard]] double later_rad(const Eigen::Vector3d& from, const Eigen::Vector3d& tag,
                                 const Eigen::Vector3d& image) const {
    return k_radpm_ * ((image - from).norm() - (tag - from).norm());
  }

  void whiten(std::size_t tag) {
    TagReads& reads = tags_[tag];
    const ImageSources& images = task_.images;
    const Eigen::Vector3d at = task_.path.tags_m[tag];
    const auto n = static_cast<Eigen::Index>(reads.at.size());
    MatrixXd covariance = reads.noise_rad2.asDiagonal();
    const double weight = images.count * images.amplitude * images.amplitude / (kRanges * kBearings);
    MatrixXd bends(n, kBearings);
    for (int range = 0; range < kRanges; ++range) {
      for (int bearing = 0; bearing < kBearings; ++bearing) {
        const double part = (range + std::fmod(kGolden * bearing, 1.0)) / kRanges;
        const double away_m = images.nearest_m + part * (images.farthest_m - images.nearest_m);
        const double yaw_rad = 2.0 * robot::kPi * (bearing + 0.5) / kBearings;
        const Eigen::Vector3d image =
            at + away_m * Eigen::Vector3d{std::cos(yaw_rad), std::sin(yaw_rad), 0.0};
        for (Eigen::Index i = 0; i < n; ++i) {
          const auto r = static_cast<std::size_t>(i);
          bends(i, bearing) = std::sin(later_rad(reads.transmitters_W_m[r], at, image)) +
                              std::sin(later_rad(reads.receivers_W_m[r], at, image));
        }
      }
      covariance.selfadjointView<Eigen::Lower>().rankUpdate(bends, weight);
    }
    reads.whitener = covariance.selfadjointView<Eigen::Lower>().llt().matrixL();
    reads.A = reads.whitener.triangularView<Eigen::Lower>().solve(reads.H);
  }

  void look_along() {
    MatrixXd information = MatrixXd::Identity(states_, states_);
    std::vector<Eigen::Index> used(tags_.size(), 0);
    double sum_m2 = 0.0;
    for (const std::size_t i : looked_at()) {
      for (std::size_t tag = 0; tag < tags_.size(); ++tag) {
        const std::vector<std::size_t>& at = tags_[tag].at;
        const Eigen::Index until = std::upper_bound(at.begin(), at.end(), i) - at.begin();
        const auto fresh = tags_[tag].A.middleRows(used[tag], until - used[tag]);
        information.selfadjointView<Eigen::Lower>().rankUpdate(fresh.transpose());
        used[tag] = until;
      }
      const VectorXd beside = beside_by_states(i);
      Look look;
      look.by_states = information.selfadjointView<Eigen::Lower>().llt().solve(beside);
      sum_m2 += beside.dot(look.by_states);
      for (std::size_t tag = 0; tag < tags_.size(); ++tag) {
        look.by_reads.emplace_back(tags_[tag].A.topRows(used[tag]) * look.by_states);
      }
      looks_.push_back(std::move(look));
    }
    rms_m_ = std::sqrt(sum_m2 / static_cast<double>(looks_.size()));
  }

  [[nodiscard]] std::vector<std::size_t> looked_at() const {
    std::vector<std::size_t> chosen;
    for (std::size_t leg = 1; leg < shape_.legs(); ++leg) {
      std::vector<std::size_t> of_leg;
      for (std::size_t i = 0; i < places_.size(); ++i) {
        if (places_[i].leg == leg && places_[i].way_m > 0.0) {
          of_leg.push_back(i);
        }
      }
      const std::size_t apart = std::max<std::size_t>(1, of_leg.size() / kLooksPerLeg);
      for (std::size_t i = apart / 2; i < of_leg.size(); i += apart) {
        chosen.push_back(of_leg[i]);
      }
    }
    return chosen;
  }

  [[nodiscard]] VectorXd beside_by_states(std::size_t i) const {
    const robot::PathShape::Beside beside = shape_.beside(places_[i].leg, places_[i].X_WR.p_m);
    VectorXd by = errors_[i].topRows<2>().transpose() * beside.by_robot;
    for (const robot::PathShape::Pull& pull : beside.by_places) {
      by.segment<2>(tag_state(pull.place)) += kNothingKnown_m * pull.by_place;
    }
    return by;
  }

  /// Bends of one room, drawn, whitened.
  [[nodiscard]] VectorXd draw_bends(std::size_t tag, robot::RandomStream& random) const {
    const TagReads& reads = tags_[tag];
    const Eigen::Vector3d at = task_.path.tags_m[tag];
    std::vector<Eigen::Vector3d> images;
    for (int i = 0; i < task_.images.count; ++i) {
      const double away_m = random.uniform(task_.images.nearest_m, task_.images.farthest_m);
      const double yaw_rad = random.uniform(0.0, 2.0 * robot::kPi);
      images.emplace_back(at + away_m * Eigen::Vector3d{std::cos(yaw_rad), std::sin(yaw_rad), 0.0});
    }
    const auto gain = [&](const Eigen::Vector3d& from) {
      std::complex<double> sum{1.0, 0.0};
      for (const Eigen::Vector3d& image : images) {
        sum += std::polar(task_.images.amplitude, -later_rad(from, at, image));
      }
      return sum;
    };
    VectorXd bends(static_cast<Eigen::Index>(reads.at.size()));
    for (Eigen::Index i = 0; i < bends.size(); ++i) {
      const auto r = static_cast<std::size_t>(i);
      bends(i) = -std::arg(gain(reads.transmitters_W_m[r]) * gain(reads.receivers_W_m[r])) +
                 std::sqrt(reads.noise_rad2(i)) * random.normal();
    }
    return reads.whitener.triangularView<Eigen::Lower>().solve(bends);
  }

  [[nodiscard]] double median_of_runs() const {
    robot::RandomStream random = robot::RandomStream(task_.seed).fork("image bound");
    std::vector<double> runs_m;
    for (int draw = 0; draw < task_.draws; ++draw) {
      VectorXd states(states_);
      for (double& state : states) {
        state = random.normal();
      }
      std::vector<VectorXd> reads;
      for (std::size_t tag = 0; tag < tags_.size(); ++tag) {
        reads.push_back(draw_bends(tag, random));
      }
      double sum_m2 = 0.0;
      for (const Look& look : looks_) {
        double error_m = look.by_states.dot(states);
        for (std::size_t tag = 0; tag < tags_.size(); ++tag) {
          error_m -= look.by_reads[tag].dot(reads[tag].head(look.by_reads[tag].size()));
        }
        sum_m2 += error_m * error_m;
      }
      runs_m.push_back(std::sqrt(sum_m2 / static_cast<double>(looks_.size())));
    }
    const auto middle = runs_m.begin() + task_.draws / 2;
    std::nth_element(runs_m.begin(), middle, runs_m.end());
    return *middle;
  }

  const ImageBoundTask& task_;
  double k_radpm_;
  robot::PathShape shape_;
  std::vector<Place> places_;
  int states_;
  std::vector<TagReads> tags_;
  std::vector<MatrixXd> errors_;  ///< of each place's X_WR, by the states
  std::vector<Look> looks_;
  double rms_m_{0.0};
};

}  // namespace

ImageBound image_bound(const ImageBoundTask& task) {
  assert(task.path.path == robot::TagPathKind::kPolyline && task.path.route.size() > 1);
  assert(task.images.count > 0 && task.draws > 0);
  return ImageStudy(task).run();
}

}  // namespace sensotwin::twin
