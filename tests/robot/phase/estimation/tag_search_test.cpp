// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/tag_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace sensotwin::robot::testing {
namespace {

constexpr double kStep_s = 0.015;

/// Drives a robot without slip as the search says. \param loudness  of the tag at a pose, if it is heard
class SearchDrive {
 public:
  using Loudness = std::function<std::optional<double>(const Pose2&)>;
  explicit SearchDrive(Loudness loudness) : loudness_(std::move(loudness)) { search_.begin(); }

  /// Until it gives up, or `until`.
  void run(const std::function<bool(const Pose2&)>& until) {
    WheelStep way;
    for (int i = 0; i < 200000 && !until(X_); ++i) {
      const auto move = search_.step(way, loudness_(X_));
      if (!move) {
        return;
      }
      way = {move->speed_mps * kStep_s, move->turn_radps * kStep_s};
      X_ = advanced(X_, way);
      turned_rad_ += std::abs(way.turn_rad);
      farthest_m_ = std::max(farthest_m_, X_.p_m.norm());
      if (farthest_m_ == 0.0) {
        turned_on_the_spot_rad_ = turned_rad_;
      }
    }
  }
  [[nodiscard]] const TagSearch& search() const { return search_; }
  [[nodiscard]] const Pose2& pose() const { return X_; }
  [[nodiscard]] double farthest_m() const { return farthest_m_; }
  [[nodiscard]] double turned_on_the_spot_rad() const { return turned_on_the_spot_rad_; }

 private:
  Loudness loudness_;
  TagSearch search_;
  Pose2 X_;
  double turned_rad_{0.0};
  double turned_on_the_spot_rad_{0.0};
  double farthest_m_{0.0};
};

bool never(const Pose2& /*X*/) {
  return false;
}

TEST(TagSearch, DrivesTowardsWhereTheTagAnswersLoudest) {
  const Vec2 tag{3.0, -5.0};
  SearchDrive drive([&](const Pose2& X) -> std::optional<double> {
    const Vec2 way = tag - X.p_m;
    const double off_rad = std::abs(wrap_angle(std::atan2(way.y(), way.x()) - X.yaw_rad));
    return off_rad < 0.8 ? std::optional{-60.0 - 10.0 * off_rad} : std::nullopt;
  });
  drive.run([&](const Pose2& X) { return (tag - X.p_m).norm() < 3.5; });
  EXPECT_LT((tag - drive.pose().p_m).norm(), 3.5) << "from 5.8 m away";
  EXPECT_EQ(drive.search().silent_turns(), 0);
}

TEST(TagSearch, TurnsTwiceOnTheSpotBeforeItLeavesAPlaceWhereNothingIsHeard) {
  SearchDrive drive([](const Pose2&) { return std::nullopt; });
  drive.run([](const Pose2& X) { return X.p_m.norm() > 0.01; });
  EXPECT_GT(drive.turned_on_the_spot_rad(), 4.0 * kPi);
  EXPECT_GE(drive.search().silent_turns(), 2);
}

TEST(TagSearch, GivesUpWithinTheSquareThatItsConfigurationNames) {
  SearchDrive drive([](const Pose2&) { return std::nullopt; });
  drive.run(never);
  EXPECT_FALSE(drive.search().running());
  // Sides of 0.6, 0.6, 1.2, 1.2, 1.8 and 1.8 m: nowhere is farther than a corner of a square of 1.8 m.
  EXPECT_GT(drive.farthest_m(), 0.9);
  EXPECT_LT(drive.farthest_m(), 1.8 * std::sqrt(2.0));
}

TEST(TagSearch, DoesNothingBeforeItBegins) {
  TagSearch search;
  EXPECT_FALSE(search.running());
  EXPECT_FALSE(search.step({}, -50.0));
}

}  // namespace
}  // namespace sensotwin::robot::testing
