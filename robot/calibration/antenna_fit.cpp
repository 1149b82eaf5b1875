// SPDX-License-Identifier: MIT
#include "robot/calibration/antenna_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <set>
#include <utility>

namespace sensotwin::robot {
namespace {

/// Fewer reads of a port say nothing. Chosen: two of each of 25 places round the circle.
constexpr std::size_t kFewestReads = 50;
/// Narrower, and a delay of 1 ns is less than 0.05 rad from end to end. Chosen.
constexpr double kBandForDelay_hz = 8e6;
/// Searched for the tag, and for delays. Chosen: a quarter of a turn of phase at most from step to step.
constexpr double kPlaceStep_m = 0.1;
constexpr double kDelayStep_s = 2e-9;
/// Unknowns for which nothing better is known before the reads: wide enough to say nothing.
constexpr double kAnyPhase_rad = 30.0;
constexpr double kAnyDelay_s = 1e-7;
constexpr int kRounds = 30;
constexpr double kConverged = 1e-6;
/// Worse, and what was fitted is not there: phases at random have 1.8. Chosen.
constexpr double kWorst_rad = 1.2;
/// The part of a turn over which echoes are alike: at 0.1 m from the middle, two of the 8 cm after which they
/// are others (data study, 4).
constexpr double kCell_rad = kPi / 2.0;
/// The part of the spread that echoes from far above or below keep over the whole drive, which no turning
/// shows: it is in each port's offset, and by its delay in the cable's. Measured in the twin's R420 over 24
/// seeds (2026-11-22): 0.48 in offsets, 0.29 in delays.
constexpr double kStays = 0.4;
/// Of echoes where the robot file does not say (data study, 4).
constexpr double kEchoDelay_s = 18e-9;
/// Reads count as so many that know nothing of each other, against what was held true before: four quarters
/// at four spots.
constexpr double kIndependent = 16.0;
/// A reader's finest step: 1/1024 of a turn (data study, 3.3).
constexpr double kLeast_rad = 2.0 * kPi / 1024.0;

/// Of each port: offset (port 1: the tag's own phase), delay in nanoseconds, forward, left.
constexpr int kPortUnknowns = 4;
constexpr int kTagUnknowns = 2;

class Fit {
 public:
  Fit(const std::vector<PlacedRead>& reads, const AntennaPrior& prior)
      : reads_(reads), prior_(prior), model_(prior.reader) {
    fold_ = model_.pi_ambiguous ? 2.0 : 1.0;
    size_ = kTagUnknowns + kPortUnknowns * static_cast<int>(model_.antennas.size());
  }

  bool solve() {
    if (!survey()) {
      return false;
    }
    find_delays();
    find_tag();
    return refine();
  }

  [[nodiscard]] AntennaFit result() const {
    AntennaFit fit;
    fit.channels = channels_;
    fit.band_hz = band_hz_;
    fit.delays_known = delays_known();
    fit.tag_O_m = tag_O_m_;
    fit.spread_rad = spread_rad_;
    for (std::size_t i = 0; i < model_.antennas.size(); ++i) {
      const double stays_rad = kStays * spread_rad_;
      const double stays_ns = stays_rad * 1e9 * echo_delay_s();
      const auto sigma = [&](int which) {
        const double stays = which == 0 ? std::sqrt(2.0) * stays_rad : which == 1 ? stays_ns : 0.0;
        return std::hypot(std::sqrt(variances_(index(i, which))), stays);
      };
      const AntennaMount& mount = model_.antennas[i];
      fit.ports.push_back({.port = i + 1,
                           .reads = reads_of_[i],
                           .forward_m = {mount.at_R_m.x(), sigma(2)},
                           .left_m = {mount.at_R_m.y(), sigma(3)},
                           .cable_delay_s = {mount.cable_delay_s, 1e-9 * sigma(1)},
                           .phase_offset_rad = {i == 0 ? 0.0 : model_.wrap(mount.phase_offset_rad),
                                                i == 0 ? 0.0 : sigma(0)}});
    }
    return fit;
  }

 private:
  [[nodiscard]] static int index(std::size_t port, int which) {
    return kTagUnknowns + kPortUnknowns * static_cast<int>(port) + which;
  }
  [[nodiscard]] double echo_delay_s() const {
    return model_.noise.echo_delay_s > 0.0 ? model_.noise.echo_delay_s : kEchoDelay_s;
  }
  [[nodiscard]] bool delays_known() const { return band_hz_ >= kBandForDelay_hz; }
  [[nodiscard]] std::size_t port_of(const PlacedRead& placed) const { return placed.read.antenna - 1u; }
  [[nodiscard]] double hop_hz(const PlacedRead& placed) const {
    return placed.read.frequency_hz > 0.0 ? placed.read.frequency_hz - model_.centre_hz : 0.0;
  }

  /// \returns false when a port was hardly heard
  bool survey() {
    reads_of_.assign(model_.antennas.size(), 0);
    std::set<double> heard_hz;
    for (const PlacedRead& placed : reads_) {
      ++reads_of_[port_of(placed)];
      heard_hz.insert(placed.read.frequency_hz);
    }
    channels_ = heard_hz.size();
    band_hz_ = heard_hz.empty() ? 0.0 : *heard_hz.rbegin() - *heard_hz.begin();
    return std::all_of(reads_of_.begin(), reads_of_.end(),
                       [](std::size_t count) { return count >= kFewestReads; });
  }

  [[nodiscard]] WayLength way_of(const PlacedRead& placed, const Vec2& tag_O_m) const {
    const WayEnds ends = way_ends(model_, port_of(placed), Pose2{});
    return way_length(ends, placed.X_OR, {tag_O_m.x(), tag_O_m.y(), prior_.tag_height_m});
  }
  /// Phase less all that the geometry and the delay explain.
  [[nodiscard]] double rest_rad(const PlacedRead& placed, const Vec2& tag_O_m, double delay_s) const {
    const double way_rad = model_.wave_number(placed.read.frequency_hz) * way_of(placed, tag_O_m).length_m;
    return placed.read.phase_rad - model_.phase_sign * (way_rad + 2.0 * kPi * hop_hz(placed) * delay_s);
  }
  using Sums = std::vector<std::complex<double>>;  ///< of each port
  [[nodiscard]] Sums sums(const Vec2& tag_O_m) const {
    Sums sums(model_.antennas.size());
    for (const PlacedRead& placed : reads_) {
      const std::size_t port = port_of(placed);
      const double rest = rest_rad(placed, tag_O_m, model_.antennas[port].cable_delay_s);
      sums[port] += std::polar(1.0, fold_ * rest);
    }
    return sums;
  }

  void find_delays() {
    if (!delays_known()) {
      return;
    }
    for (std::size_t port = 0; port < model_.antennas.size(); ++port) {
      double best = -1.0;
      for (double delay_s = 0.0; delay_s < prior_.delay_max_s; delay_s += kDelayStep_s) {
        std::complex<double> sum;
        for (const PlacedRead& placed : reads_) {
          if (port_of(placed) == port && placed.spot == 0) {
            sum += std::polar(1.0, fold_ * rest_rad(placed, Vec2{0.0, 0.0}, delay_s));
          }
        }
        if (std::abs(sum) > best) {
          best = std::abs(sum);
          model_.antennas[port].cable_delay_s = delay_s;
        }
      }
    }
  }

  void find_tag() {
    double best = -1.0;
    Sums at_best;
    for (double x = -prior_.tag_within_m; x <= prior_.tag_within_m; x += kPlaceStep_m) {
      for (double y = -prior_.tag_within_m; y <= prior_.tag_within_m; y += kPlaceStep_m) {
        const Sums here = sums({x, y});
        double coherent = 0.0;
        for (const std::complex<double>& sum : here) {
          coherent += std::abs(sum);
        }
        if (coherent > best) {
          best = coherent;
          at_best = here;
          tag_O_m_ = {x, y};
        }
      }
    }
    tag_rad_ = std::arg(at_best.front()) / fold_;
    for (std::size_t i = 1; i < at_best.size(); ++i) {
      model_.antennas[i].phase_offset_rad = std::arg(at_best[i]) / fold_ - tag_rad_;
    }
    model_.antennas.front().phase_offset_rad = 0.0;
  }

  [[nodiscard]] double residual_rad(const PlacedRead& placed) const {
    const AntennaMount& mount = model_.antennas[port_of(placed)];
    return model_.wrap(rest_rad(placed, tag_O_m_, mount.cable_delay_s) - tag_rad_ - mount.phase_offset_rad);
  }

  void add_read(const PlacedRead& placed) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(size_);
    const std::size_t port = port_of(placed);
    const double k = model_.phase_sign * model_.wave_number(placed.read.frequency_hz);
    const WayLength way = way_of(placed, tag_O_m_);
    row.head<2>() = k * way.by_tag.head<2>();
    row(index(0, 0)) += 1.0;
    if (port > 0) {
      row(index(port, 0)) += 1.0;
    }
    row(index(port, 1)) = delays_known() ? model_.phase_sign * 2.0 * kPi * 1e-9 * hop_hz(placed) : 0.0;
    // Moving the antenna in R is moving the tag the other way, for the legs that end at it.
    const double legs = model_.monostatic ? 2.0 : 1.0;
    const Eigen::Vector3d& at_R_m = model_.antennas[port].at_R_m;
    const Vec2 antenna_O_m = placed.X_OR * Vec2{at_R_m.x(), at_R_m.y()};
    const Vec2 to_tag = (tag_O_m_ - antenna_O_m) / way.slant_m;
    const Vec2 forward = placed.X_OR.direction();
    row(index(port, 2)) = -k * legs * to_tag.dot(forward);
    row(index(port, 3)) = -k * legs * to_tag.dot(Vec2{-forward.y(), forward.x()});
    const double weight = 1.0 / (design_ * spread_rad_ * spread_rad_);
    // The residual is phase less prediction, the rows are of the prediction.
    H_ += weight * row * row.transpose();
    g_ -= weight * row * residual_rad(placed);
  }

  /// Of the reads, and of what was held true before.
  void gather() {
    H_ = Eigen::MatrixXd::Zero(size_, size_);
    g_ = Eigen::VectorXd::Zero(size_);
    for (const PlacedRead& placed : reads_) {
      add_read(placed);
    }
    const auto hold = [&](int at, double off, double sigma) {
      H_(at, at) += 1.0 / (sigma * sigma);
      g_(at) -= off / (sigma * sigma);
    };
    for (int i = 0; i < kTagUnknowns; ++i) {
      hold(i, -tag_O_m_(i), prior_.tag_within_m);
    }
    for (std::size_t i = 0; i < model_.antennas.size(); ++i) {
      const Eigen::Vector3d off = prior_.reader.antennas[i].at_R_m - model_.antennas[i].at_R_m;
      hold(index(i, 0), 0.0, kAnyPhase_rad);
      hold(index(i, 1), 0.0, kAnyDelay_s * 1e9);
      hold(index(i, 2), off.x(), prior_.mount_sigma_m);
      hold(index(i, 3), off.y(), prior_.mount_sigma_m);
    }
  }

  /// \returns whether it came to rest, with phases that agree
  bool refine() {
    for (int round = 0; round < kRounds; ++round) {
      spread_rad_ = std::max(spread(), kLeast_rad);
      design_ = std::max(1.0, static_cast<double>(reads_.size()) / kIndependent);
      gather();
      const Eigen::LDLT<Eigen::MatrixXd> factors(H_);
      const Eigen::VectorXd step = -factors.solve(g_);
      if (factors.info() != Eigen::Success || !step.allFinite()) {
        return false;
      }
      apply(step);
      if (step.cwiseAbs().maxCoeff() < kConverged) {
        gather();
        variances_ = jackknife_variances();
        return spread_rad_ < kWorst_rad / fold_;
      }
    }
    return false;
  }

  void apply(const Eigen::VectorXd& step) {
    tag_O_m_ += step.head<2>();
    tag_rad_ += step(index(0, 0));
    for (std::size_t i = 0; i < model_.antennas.size(); ++i) {
      AntennaMount& mount = model_.antennas[i];
      mount.phase_offset_rad += i == 0 ? 0.0 : step(index(i, 0));
      mount.cable_delay_s += 1e-9 * step(index(i, 1));
      mount.at_R_m.x() += step(index(i, 2));
      mount.at_R_m.y() += step(index(i, 3));
    }
  }

  [[nodiscard]] double spread() const {
    double sum = 0.0;
    for (const PlacedRead& placed : reads_) {
      const double residual = residual_rad(placed);
      sum += residual * residual;
    }
    return std::sqrt(sum / static_cast<double>(reads_.size()));
  }

  /// Echoes stay over a quarter of a turn: the fit without each quarter of each spot in turn, one step of
  /// Gauss and Newton from the whole one, says how far such a quarter draws it (jackknife).
  [[nodiscard]] Eigen::VectorXd jackknife_variances() {
    const Eigen::MatrixXd whole = H_;
    const Eigen::VectorXd whole_g = g_;
    std::set<std::pair<std::size_t, int>> groups;
    for (const PlacedRead& placed : reads_) {
      groups.insert(group_of(placed));
    }
    std::vector<Eigen::VectorXd> moved;
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(size_);
    for (const auto& group : groups) {
      H_ = Eigen::MatrixXd::Zero(size_, size_);
      g_ = Eigen::VectorXd::Zero(size_);
      for (const PlacedRead& placed : reads_) {
        if (group_of(placed) == group) {
          add_read(placed);
        }
      }
      const Eigen::MatrixXd rest = whole - H_;
      const Eigen::VectorXd rest_g = whole_g - g_;
      moved.push_back(-rest.ldlt().solve(rest_g));
      mean += moved.back() / static_cast<double>(groups.size());
    }
    Eigen::VectorXd variances = Eigen::VectorXd::Zero(size_);
    for (const Eigen::VectorXd& one : moved) {
      variances += (one - mean).cwiseAbs2();
    }
    return variances * (static_cast<double>(groups.size()) - 1.0) / static_cast<double>(groups.size());
  }
  [[nodiscard]] static std::pair<std::size_t, int> group_of(const PlacedRead& placed) {
    return {placed.spot, static_cast<int>(std::floor(placed.X_OR.yaw_rad / kCell_rad))};
  }

  const std::vector<PlacedRead>& reads_;
  const AntennaPrior& prior_;
  PhaseReaderModel model_;  ///< as fitted so far
  double fold_{1.0};        ///< phases that are known up to half a turn are doubled
  int size_{0};
  std::vector<std::size_t> reads_of_;
  std::size_t channels_{0};
  double band_hz_{0.0};
  Vec2 tag_O_m_{0.0, 0.0};
  double tag_rad_{0.0};
  double spread_rad_{0.0};
  double design_{1.0};
  Eigen::MatrixXd H_;
  Eigen::VectorXd g_;
  Eigen::VectorXd variances_;
};

}  // namespace

std::optional<AntennaFit> fit_antennas(const std::vector<PlacedRead>& reads, const AntennaPrior& prior) {
  std::vector<PlacedRead> useful;
  for (const PlacedRead& placed : reads) {
    if (placed.read.has_phase && placed.read.antenna >= 1 &&
        placed.read.antenna <= prior.reader.antennas.size()) {
      useful.push_back(placed);
    }
  }
  Fit fit(useful, prior);
  if (useful.empty() || !fit.solve()) {
    return std::nullopt;
  }
  return fit.result();
}

}  // namespace sensotwin::robot
