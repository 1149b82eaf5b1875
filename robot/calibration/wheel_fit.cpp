// SPDX-License-Identifier: MIT
#include "robot/calibration/wheel_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "robot/base/time.hpp"
#include "robot/calibration/counted_way.hpp"

namespace sensotwin::robot {
namespace {

/// Unknowns that hold for the whole drive, each as a change from what was told: logarithms of scale, ratio
/// and base; radius; delay.
enum Whole : int { kScale, kRatio, kBase, kRadius, kDelay, kWhole };
/// How far they may be from what was told, 1 sigma. Chosen: wide; a tenth of the base is carpet's worst.
constexpr std::array<double, kWhole> kWholeSigma{0.05, 0.05, 0.10, 0.02, 0.2};
/// For derivatives by differences. Chosen: far above rounding, far below what matters.
constexpr double kNudge = 1e-5;
constexpr int kRounds = 60;
constexpr int kWholeSteps = 10;
/// Of each: a hundredth of a tenth of a percent, of a millimetre. Chosen: far below what a drive can tell,
/// and what weights that change from round to round still reach.
constexpr double kConverged = 1e-5;
/// Crossings that say anything at all: three a whole unknown.
constexpr std::size_t kFewest = 3 * kWhole;
constexpr double kHuber = 3.0;
/// A pose between two counts; keeps the weights finite where nothing moved. Chosen: half a count.
constexpr double kRest_m = 2e-4;
constexpr double kRest_rad = 1e-3;
/// A tag on its grid point. Chosen: far below all else.
constexpr double kExact_m = 1e-6;

class Fit {
 public:
  Fit(const WheelLog& log, const WheelPrior& prior) : log_(log), prior_(prior) {
    for (const RimCrossing& crossing : log.crossings) {
      tags_.try_emplace(crossing.tile, static_cast<int>(tags_.size()));
    }
    poses_at_ = kWhole + 2 * static_cast<int>(tags_.size());
    size_ = poses_at_ + 3 * static_cast<int>(log.crossings.size());
    x_ = Eigen::VectorXd::Zero(size_);
    for (std::size_t i = 0; i < log.crossings.size(); ++i) {
      const Pose2& pose = log.crossings[i].X_MR;
      x_.segment<3>(pose_of(i)) << pose.p_m.x(), pose.p_m.y(), pose.yaw_rad;
    }
  }

  /// \returns whether it came to rest
  bool solve() {
    for (int round = 0; round < kRounds; ++round) {
      gather();
      const Eigen::LDLT<Eigen::MatrixXd> factors(H_);
      if (factors.info() != Eigen::Success) {
        return false;
      }
      const Eigen::VectorXd step = factors.solve(g_);
      if (!step.allFinite()) {
        return false;
      }
      // Weights that change with the step can make it swing to and fro: half of it then comes to rest.
      x_ -= round < kWholeSteps ? step : 0.5 * step;
      if (step.head<kWhole>().cwiseAbs().maxCoeff() < kConverged) {
        covariance_ = whole_covariance(H_);
        Eigen::MatrixXd exact = H_;
        exact.diagonal().segment(kWhole, poses_at_ - kWhole).array() += 1.0 / (kExact_m * kExact_m);
        covariance_of_laps_ = whole_covariance(exact);
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] WheelFit result() const {
    const double misfit = sum_ / std::max(1.0, static_cast<double>(residuals_) - size_);
    const double wider = std::sqrt(std::max(1.0, misfit));
    const auto sigma = [&](Whole which) { return wider * std::sqrt(covariance_(which, which)); };
    const OdometryModel fitted = wheels();
    WheelFit fit;
    fit.wheel_base_m = {fitted.wheel_base_m, fitted.wheel_base_m * sigma(kBase)};
    fit.metres_per_count = {fitted.metres_per_count, fitted.metres_per_count * sigma(kScale)};
    fit.wheel_ratio = {fitted.wheel_ratio, fitted.wheel_ratio * sigma(kRatio)};
    fit.read_radius_m = {prior_.read_radius_m + x_(kRadius), sigma(kRadius)};
    fit.notice_delay_s = {prior_.notice_delay_s + x_(kDelay), sigma(kDelay)};
    for (const Lap& lap : log_.laps) {
      ++fit.laps[lap.clockwise ? 1 : 0];
    }
    const auto worst = [&](const WholeMatrix& covariance) {
      return wider * std::sqrt(covariance.diagonal().head<3>().maxCoeff());
    };
    fit.relative_sigma = worst(covariance_);
    fit.relative_sigma_of_laps = worst(covariance_of_laps_);
    fit.closure = {closure_m(prior_.wheels), closure_m(fitted)};
    fit.crossings = log_.crossings.size();
    fit.outliers = outliers_;
    fit.misfit = misfit;
    return fit;
  }

 private:
  using WholeMatrix = Eigen::Matrix<double, kWhole, kWhole>;

  [[nodiscard]] WholeMatrix whole_covariance(const Eigen::MatrixXd& H) const {
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(size_, kWhole);
    whole.topRows<kWhole>().setIdentity();
    return H.ldlt().solve(whole).topRows<kWhole>();
  }
  [[nodiscard]] int pose_of(std::size_t crossing) const { return poses_at_ + 3 * static_cast<int>(crossing); }
  [[nodiscard]] int tag_of(Tile tile) const { return kWhole + 2 * tags_.at(tile); }
  [[nodiscard]] Pose2 pose(std::size_t crossing) const {
    const auto p = x_.segment<3>(pose_of(crossing));
    return {{p(0), p(1)}, p(2)};
  }
  /// \param nudged  this one a little more; kWhole: none
  [[nodiscard]] OdometryModel wheels(int nudged = kWhole) const {
    const auto value = [&](Whole which) { return x_(which) + (nudged == which ? kNudge : 0.0); };
    OdometryModel wheels = prior_.wheels;
    wheels.metres_per_count *= std::exp(value(kScale));
    wheels.wheel_ratio *= std::exp(value(kRatio));
    wheels.wheel_base_m *= std::exp(value(kBase));
    return wheels;
  }

  void gather() {
    H_ = Eigen::MatrixXd::Zero(size_, size_);
    g_ = Eigen::VectorXd::Zero(size_);
    sum_ = 0.0;
    residuals_ = 0;
    outliers_ = 0;
    for (int i = 0; i < kWhole; ++i) {
      hold_to_prior(i, kWholeSigma[static_cast<std::size_t>(i)]);
    }
    for (int i = kWhole; i < poses_at_; ++i) {
      hold_to_prior(i, prior_.tag_sigma_m);
    }
    for (std::size_t i = 0; i < log_.crossings.size(); ++i) {
      add_crossing(i);
      if (i > 0) {
        add_way(i);
      }
    }
  }

  void hold_to_prior(int index, double sigma) {
    const double weight = 1.0 / (sigma * sigma);
    H_(index, index) += weight;
    g_(index) += weight * x_(index);
    count(x_(index) / sigma);
  }
  void count(double deviations) {
    sum_ += deviations * deviations;
    ++residuals_;
  }

  /// A few entries of one row of the equations.
  template <int kEntries>
  void add_row(const std::array<int, kEntries>& at, const std::array<double, kEntries>& by, double residual,
               double weight) {
    for (std::size_t a = 0; a < kEntries; ++a) {
      g_(at[a]) += weight * by[a] * residual;
      for (std::size_t b = 0; b < kEntries; ++b) {
        H_(at[a], at[b]) += weight * by[a] * by[b];
      }
    }
  }

  void add_crossing(std::size_t i) {
    const RimCrossing& crossing = log_.crossings[i];
    const Pose2 X = pose(i);
    const double speed_mps = speed_at(log_.steps, crossing.step, wheels());
    const double delay_s = prior_.notice_delay_s + x_(kDelay);
    const int tag = tag_of(crossing.tile);
    const Vec2 tag_M_m = prior_.tile_m * Vec2{crossing.tile.column, crossing.tile.row} + x_.segment<2>(tag);
    const Vec2 late = speed_mps * delay_s * X.direction();
    const Vec2 from_tag = X.p_m - late - tag_M_m;
    const double distance_m = std::max(from_tag.norm(), 1e-4);
    const Vec2 sight = from_tag / distance_m;
    const double sigma_m = std::hypot(prior_.rim_sigma_m, prior_.notice_sigma_s * speed_mps);
    const double residual_m = distance_m - prior_.read_radius_m - x_(kRadius);
    const double deviations = std::abs(residual_m) / sigma_m;
    const double trust = deviations > kHuber ? kHuber / deviations : 1.0;
    outliers_ += deviations > kHuber ? 1 : 0;
    count(std::sqrt(trust) * deviations);
    const Vec2 aside{-X.direction().y(), X.direction().x()};
    const int p = pose_of(i);
    add_row<7>({p, p + 1, p + 2, tag, tag + 1, kRadius, kDelay},
               {sight.x(), sight.y(), -speed_mps * delay_s * sight.dot(aside), -sight.x(), -sight.y(), -1.0,
                -speed_mps * sight.dot(X.direction())},
               residual_m, trust / (sigma_m * sigma_m));
  }

  /// From the crossing before this one to it.
  void add_way(std::size_t i) {
    const std::size_t first = log_.crossings[i - 1].step + 1;
    const std::size_t end = log_.crossings[i].step + 1;
    const CountedWay way = counted_way(log_.steps, first, end, wheels());
    const Pose2 from = pose(i - 1);
    const Pose2 to = pose(i);
    const Pose2 seen = from.inverse() * to;
    const double c = std::cos(from.yaw_rad);
    const double s = std::sin(from.yaw_rad);
    std::array<Pose2, 3> nudged;
    for (int k = 0; k < 3; ++k) {
      nudged[static_cast<std::size_t>(k)] = counted_way(log_.steps, first, end, wheels(k)).X;
    }
    const OdometryModel& w = prior_.wheels;
    const double yaw_var = kRest_rad * kRest_rad + w.heading_sigma_rad * w.heading_sigma_rad * way.rolled_m +
                           w.turn_sigma_rad * w.turn_sigma_rad * way.turned_rad;
    // What the heading loses on the way bends it: a third of the square, as of a straight one.
    const double place_var = kRest_m * kRest_m + w.along_sigma_m * w.along_sigma_m * way.rolled_m +
                             yaw_var * way.rolled_m * way.rolled_m / 3.0;
    const int a = pose_of(i - 1);
    const int b = pose_of(i);
    const auto by_whole = [&](auto part) {
      return std::array<double, 3>{(part(way.X) - part(nudged[0])) / kNudge,
                                   (part(way.X) - part(nudged[1])) / kNudge,
                                   (part(way.X) - part(nudged[2])) / kNudge};
    };
    const auto x_part = by_whole([](const Pose2& X) { return X.p_m.x(); });
    const auto y_part = by_whole([](const Pose2& X) { return X.p_m.y(); });
    const std::array<double, 3> yaw_part{wrap_angle(way.X.yaw_rad - nudged[0].yaw_rad) / kNudge,
                                         wrap_angle(way.X.yaw_rad - nudged[1].yaw_rad) / kNudge,
                                         wrap_angle(way.X.yaw_rad - nudged[2].yaw_rad) / kNudge};
    const Vec2 off = seen.p_m - way.X.p_m;
    const double off_rad = wrap_angle(to.yaw_rad - from.yaw_rad - way.X.yaw_rad);
    add_row<8>({a, a + 1, a + 2, b, b + 1, kScale, kRatio, kBase},
               {-c, -s, seen.p_m.y(), c, s, x_part[0], x_part[1], x_part[2]}, off.x(), 1.0 / place_var);
    add_row<8>({a, a + 1, a + 2, b, b + 1, kScale, kRatio, kBase},
               {s, -c, -seen.p_m.x(), -s, c, y_part[0], y_part[1], y_part[2]}, off.y(), 1.0 / place_var);
    add_row<5>({a + 2, b + 2, kScale, kRatio, kBase}, {-1.0, 1.0, yaw_part[0], yaw_part[1], yaw_part[2]},
               off_rad, 1.0 / yaw_var);
    count(off.x() / std::sqrt(place_var));
    count(off.y() / std::sqrt(place_var));
    count(off_rad / std::sqrt(yaw_var));
  }

  [[nodiscard]] double closure_m(const OdometryModel& w) const {
    std::array<Vec2, 2> sum{Vec2{0.0, 0.0}, Vec2{0.0, 0.0}};
    std::array<int, 2> laps{};
    for (const Lap& lap : log_.laps) {
      const Pose2 begin = pose(lap.first);
      const CountedWay way =
          counted_way(log_.steps, log_.crossings[lap.first].step + 1, log_.crossings[lap.last].step + 1, w);
      const std::size_t which = lap.clockwise ? 1 : 0;
      sum[which] += begin * way.X.p_m - pose(lap.last).p_m;
      ++laps[which];
    }
    double greatest_m = 0.0;
    for (std::size_t which = 0; which < 2; ++which) {
      greatest_m = std::max(greatest_m, laps[which] > 0 ? (sum[which] / laps[which]).norm() : 0.0);
    }
    return greatest_m;
  }

  const WheelLog& log_;
  const WheelPrior& prior_;
  std::map<Tile, int> tags_;  ///< in the order of their first crossings
  int poses_at_{0};
  int size_{0};
  Eigen::VectorXd x_;
  Eigen::MatrixXd H_;
  Eigen::VectorXd g_;
  WholeMatrix covariance_{WholeMatrix::Zero()};
  WholeMatrix covariance_of_laps_{WholeMatrix::Zero()};  ///< if the tags' places were exact
  double sum_{0.0};
  std::size_t residuals_{0};
  std::size_t outliers_{0};
};

}  // namespace

std::optional<WheelFit> fit_wheels(const WheelLog& log, const WheelPrior& prior) {
  if (log.crossings.size() < kFewest) {
    return std::nullopt;
  }
  Fit fit(log, prior);
  if (!fit.solve()) {
    return std::nullopt;
  }
  return fit.result();
}

}  // namespace sensotwin::robot
