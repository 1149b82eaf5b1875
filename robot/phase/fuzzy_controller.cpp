// SPDX-License-Identifier: MIT
#include "robot/phase/fuzzy_controller.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace sensotwin::robot {
namespace {

/// A consequent after implication by "min": an output set whose top is cut at the degree of its rule. Its
/// corners are where it begins, where the cut begins and ends, and where it ends.
struct Clipped {
  double degree;
  std::array<double, 4> corners;

  Clipped(const Trapezoid& set, double to_degree)
      : degree(to_degree),
        corners{set.left_foot, set.left_foot + to_degree * (set.left_shoulder - set.left_foot),
                set.right_foot - to_degree * (set.right_foot - set.right_shoulder), set.right_foot} {}

  [[nodiscard]] double at(double y) const {
    if (y <= corners[0] || y >= corners[3]) {
      return 0.0;
    }
    if (y < corners[1]) {
      return degree * (y - corners[0]) / (corners[1] - corners[0]);
    }
    if (y > corners[2]) {
      return degree * (corners[3] - y) / (corners[3] - corners[2]);
    }
    return degree;
  }
};

/// A few numbers in ascending order. \pre no more than N are added
template <std::size_t N>
class Ascending {
 public:
  void add(double value) {
    std::size_t at = used_++;
    for (; at > 0 && values_[at - 1] > value; --at) {
      values_[at] = values_[at - 1];
    }
    values_[at] = value;
  }
  [[nodiscard]] std::size_t size() const { return used_; }
  [[nodiscard]] double operator[](std::size_t n) const { return values_[n]; }

 private:
  std::array<double, N> values_{};
  std::size_t used_{0};
};

/// Area under a chain of straight pieces, and its moment about y = 0.
struct CentreOfArea {
  double area{0.0};
  double moment{0.0};

  void add(double y0, double mu0, double y1, double mu1) {
    const double width = y1 - y0;
    area += width * (mu0 + mu1) / 2.0;
    moment += width * (y0 * (2.0 * mu0 + mu1) + y1 * (mu0 + 2.0 * mu1)) / 6.0;
  }
};

/// The union ("max") of two or three sets between two neighbouring corners, where each is straight.
class StraightSpan {
 public:
  StraightSpan(double y0, double y1, const std::array<double, 3>& mu0, const std::array<double, 3>& mu1)
      : y0_(y0), y1_(y1), mu0_(mu0), mu1_(mu1) {}

  void add_to(CentreOfArea& centre) const {
    Ascending<5> parts;
    parts.add(0.0);
    parts.add(1.0);
    for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
      const double before = mu0_[i] - mu0_[j];
      const double after = mu1_[i] - mu1_[j];
      if (before * after < 0.0) {
        parts.add(before / (before - after));
      }
    }
    for (std::size_t n = 1; n < parts.size(); ++n) {
      centre.add(y(parts[n - 1]), highest(parts[n - 1]), y(parts[n]), highest(parts[n]));
    }
  }

 private:
  [[nodiscard]] double y(double part) const { return y0_ + part * (y1_ - y0_); }
  [[nodiscard]] double highest(double part) const {
    double most = 0.0;
    for (std::size_t i = 0; i < mu0_.size(); ++i) {
      most = std::max(most, mu0_[i] + part * (mu1_[i] - mu0_[i]));
    }
    return most;
  }

  double y0_;
  double y1_;
  std::array<double, 3> mu0_;
  std::array<double, 3> mu1_;
};

}  // namespace

std::optional<std::string> problem_of(const FuzzySets& sets) {
  const std::array<std::pair<const char*, const Trapezoid*>, 6> all{
      {{"negative", &sets.negative_rad},
       {"zero", &sets.zero_rad},
       {"positive", &sets.positive_rad},
       {"clockwise", &sets.clockwise_radps},
       {"straight", &sets.straight_radps},
       {"counter-clockwise", &sets.counter_clockwise_radps}}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [name, set] = all[i];
    if (!set->well_formed()) {
      return std::string(name) + ": the corners of a set must be in ascending order, left foot to right foot";
    }
    const bool output = i >= 3;
    if (output && (set->left_foot == set->left_shoulder || set->right_shoulder == set->right_foot)) {
      return std::string(name) + ": an output set must rise and fall by slopes, not by vertical edges";
    }
  }
  return std::nullopt;
}

FuzzyController::FuzzyController(const FuzzySets& sets) : sets_(sets) {
  assert(!problem_of(sets));
}

std::array<double, 3> FuzzyController::degrees(double phase_difference_rad) const {
  const double lowest =
      std::min({sets_.negative_rad.left_foot, sets_.zero_rad.left_foot, sets_.positive_rad.left_foot});
  const double highest =
      std::max({sets_.negative_rad.right_foot, sets_.zero_rad.right_foot, sets_.positive_rad.right_foot});
  const double dphi = std::clamp(phase_difference_rad, lowest, highest);
  return {sets_.positive_rad.degree(dphi), sets_.zero_rad.degree(dphi), sets_.negative_rad.degree(dphi)};
}

double FuzzyController::turn_rate_radps(double phase_difference_rad) const {
  const std::array<double, 3> degree = degrees(phase_difference_rad);
  const std::array<Clipped, 3> rules{Clipped{sets_.clockwise_radps, degree[0]},
                                     Clipped{sets_.straight_radps, degree[1]},
                                     Clipped{sets_.counter_clockwise_radps, degree[2]}};
  Ascending<12> corners;
  for (const Clipped& rule : rules) {
    if (rule.degree > 0.0) {
      for (const double y : rule.corners) {
        corners.add(y);
      }
    }
  }
  CentreOfArea centre;
  std::array<double, 3> before{};
  for (std::size_t n = 0; n < corners.size(); ++n) {
    const std::array<double, 3> here{rules[0].at(corners[n]), rules[1].at(corners[n]),
                                     rules[2].at(corners[n])};
    if (n > 0 && corners[n] > corners[n - 1]) {
      StraightSpan{corners[n - 1], corners[n], before, here}.add_to(centre);
    }
    before = here;
  }
  return centre.area > 0.0 ? centre.moment / centre.area : 0.0;
}

}  // namespace sensotwin::robot
