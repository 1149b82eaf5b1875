// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/phase_model.hpp"

#include <gtest/gtest.h>

#include "robot/phase/estimation/dead_reckoning.hpp"
#include "robot/phase/estimation/joint_filter.hpp"

namespace sensotwin::robot {
namespace {

PhaseReaderModel pair_model(bool monostatic) {
  PhaseReaderModel model;
  model.antennas = antenna_pair(0.16, 0.1);
  model.antennas[1].at_R_m.x() = 0.03;  // not symmetric, so that no term cancels
  model.antennas[1].cable_delay_s = 40e-9;
  model.monostatic = monostatic;
  return model;
}

UhfRead read_by(std::uint16_t antenna, double frequency_hz = 920e6) {
  UhfRead read;
  read.antenna = antenna;
  read.frequency_hz = frequency_hz;
  return read;
}

JointFilter::NewTag tag_at(int id, const Vec2& p_R_m) {
  return {.id = id,
          .p_R_m = p_R_m,
          .covariance_R_m2 = 0.01 * Eigen::Matrix2d::Identity(),
          .height_m = 3.0,
          .height_sigma_m = 0.05};
}

void expect_jacobian_matches_differences(bool monostatic, double echo_rad) {
  PhaseReaderModel model = pair_model(monostatic);
  model.noise.echo_rad = echo_rad;
  JointFilter filter{model, WheelModel{}, CompassTrust{}};
  ASSERT_TRUE(filter.add(tag_at(7, {3.0, -1.0})));
  filter.drive({0.4, 0.3});
  const Pose2 X_now_then{{-0.02, 0.004}, -0.03};
  const UhfRead read = read_by(2);
  const PhasePrediction at = filter.predict(7, read, X_now_then);
  Eigen::VectorXd H = Eigen::VectorXd::Zero(filter.state().size());
  for (int i = 0; i < at.H.size; ++i) {
    H(at.H.at[static_cast<std::size_t>(i)]) += at.H.by[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd x = filter.state();
  const double h = 1e-6;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd moved = x;
    moved(i) += h;
    filter.set_state(moved);
    const double above = filter.predict(7, read, X_now_then).phase_rad;
    moved(i) -= 2.0 * h;
    filter.set_state(moved);
    const double below = filter.predict(7, read, X_now_then).phase_rad;
    // Second order of a phase of hundreds of radians over 1e-6: below 1e-5 of the derivative's scale.
    EXPECT_NEAR(H(i), (above - below) / (2.0 * h), 1e-3) << "state " << i;
  }
}

TEST(JointFilter, PredictsABistaticPhaseWithTheJacobianOfNumericalDifferences) {
  expect_jacobian_matches_differences(false, 0.0);
}

TEST(JointFilter, PredictsAMonostaticPhaseWithTheJacobianOfNumericalDifferences) {
  expect_jacobian_matches_differences(true, 0.0);
}

TEST(JointFilter, PredictsAPhaseWithEchoesWithTheJacobianOfNumericalDifferences) {
  expect_jacobian_matches_differences(false, 0.2);
}

TEST(JointFilter, CarriesItsCovarianceAlongAsManySmallStepsOfTheTruthScatter) {
  // Two steps of one model against its own Jacobian by differences: P of scale and heading only, no noise.
  WheelModel wheels;
  wheels.along_sigma_m = wheels.across_sigma_m = wheels.heading_sigma_rad = wheels.turn_sigma_rad = 0.0;
  JointFilter filter{pair_model(false), wheels, CompassTrust{}};
  Eigen::VectorXd start = filter.state();
  const Eigen::MatrixXd P0 = filter.covariance();
  const auto end_of = [&](const Eigen::VectorXd& x) -> Eigen::Vector3d {
    JointFilter other{pair_model(false), wheels, CompassTrust{}};
    other.set_state(x);
    for (int i = 0; i < 50; ++i) {
      other.drive({0.02, 0.01});
    }
    return other.state().head<3>();
  };
  Eigen::MatrixXd F(3, start.size());
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    Eigen::VectorXd above = start;
    Eigen::VectorXd below = start;
    above(i) += 1e-6;
    below(i) -= 1e-6;
    F.col(i) = (end_of(above) - end_of(below)) / 2e-6;
  }
  for (int i = 0; i < 50; ++i) {
    filter.drive({0.02, 0.01});
  }
  const Eigen::Matrix3d expected = F * P0 * F.transpose();
  EXPECT_LT((filter.pose_covariance() - expected).norm(), 1e-6 * expected.norm() + 1e-12);
}

TEST(JointFilter, RejectsAReadThatLiesBeyondTheGateAndChangesNothing) {
  const PhaseReaderModel model = pair_model(false);
  JointFilter filter{model, WheelModel{}, CompassTrust{}};
  JointFilter::NewTag tag = tag_at(1, {1.0, 0.5});
  tag.covariance_R_m2 = 1e-8 * Eigen::Matrix2d::Identity();
  tag.height_sigma_m = 1e-4;
  ASSERT_TRUE(filter.add(tag));
  UhfRead read = read_by(1, 915e6);
  EXPECT_EQ(filter.read(1, read, {}, 1.0, 5.0).fate, JointFilter::Fate::kOffsetSet);
  read.phase_rad = filter.predict(1, read, {}).phase_rad;
  EXPECT_EQ(filter.read(1, read, {}, 1.0, 5.0).fate, JointFilter::Fate::kUsed);
  const Eigen::VectorXd before = filter.state();
  read.phase_rad += 2.0;
  EXPECT_EQ(filter.read(1, read, {}, 1.0, 5.0).fate, JointFilter::Fate::kRejected);
  EXPECT_EQ((filter.state() - before).norm(), 0.0);
}

TEST(JointFilter, KeepsOtherTagsWhenOneIsTakenOut) {
  const PhaseReaderModel model = pair_model(false);
  JointFilter filter{model, WheelModel{}, CompassTrust{}};
  ASSERT_TRUE(filter.add(tag_at(1, {1.0, 0.5})));
  ASSERT_TRUE(filter.add(tag_at(2, {-2.0, 4.0})));
  ASSERT_TRUE(filter.add(tag_at(3, {5.0, -1.0})));
  const Eigen::Matrix3d P3 = filter.tag_covariance(3);
  filter.remove(1);
  EXPECT_FALSE(filter.knows(1));
  EXPECT_LT((filter.tag_M_m(2).head<2>() - Vec2(-2.0, 4.0)).norm(), 1e-9);
  EXPECT_LT((filter.tag_M_m(3).head<2>() - Vec2(5.0, -1.0)).norm(), 1e-9);
  EXPECT_LT((filter.tag_covariance(3) - P3).norm(), 1e-12);
}

TEST(PhaseReaderModel, TakesAPhaseModuloPiWhereItIsKnownUpToPiOnly) {
  PhaseReaderModel model;
  EXPECT_NEAR(model.wrap(kPi + 0.2), -kPi + 0.2, 1e-12);
  model.pi_ambiguous = true;
  EXPECT_NEAR(model.wrap(kPi + 0.2), 0.2, 1e-12);
  EXPECT_NEAR(model.wrap(2.0), 2.0 - kPi, 1e-12);
}

TEST(PhaseReaderModel, CountsTheWayTwiceWhereOneAntennaSendsAndReceives) {
  const PhaseReaderModel model = pair_model(true);
  const WayLength way = way_length(way_ends(model, 0, {}), {}, {0.0, 0.08, 3.1});
  EXPECT_NEAR(way.length_m, 6.0, 1e-12);
  EXPECT_NEAR(way.slant_m, 3.0, 1e-12);
}

TEST(PhaseNoise, TakesTheEchoOfAnotherPlaceOrChannelForAnother) {
  PhaseNoise noise;
  noise.echo_rad = 0.3;
  noise.echo_length_m = 0.08;
  noise.echo_delay_s = 18e-9;
  EXPECT_DOUBLE_EQ(noise.echo_kept({}), 1.0);
  EXPECT_NEAR(noise.echo_kept({.way_m = 0.08}), std::exp(-1.0), 1e-12);
  // Across the FCC band, 24.5 MHz at 18 ns: 2.8 rad, 2 % kept.
  EXPECT_LT(noise.echo_kept({.hop_hz = 24.5e6}), 0.03);
  EXPECT_GT(noise.echo_kept({.hop_hz = 0.5e6}), 0.99);
}

TEST(PhaseNoise, CountsReadsOfOneEchoAsFew) {
  PhaseNoise noise;
  noise.echo_rad = 0.3;
  noise.echo_length_m = 0.08;
  noise.echo_delay_s = 18e-9;
  // A thousand reads over a centimetre say as much of the way as reads 16 cm apart would: their variance in
  // sum is that of an eighth of a read.
  EXPECT_NEAR(noise.echo_as_noise({.way_m = 0.001}), 0.09 * 160.0, 0.1);
  EXPECT_NEAR(noise.echo_as_noise({.way_m = 1.0}), 0.09, 0.001);
  EXPECT_NEAR(noise.echo_as_noise({.hop_hz = 24.5e6}), 0.09, 0.006);
}

TEST(DeadReckoning, FindsThePlaceBetweenTwoStepsAtTheTimeOfARead) {
  DeadReckoning reckoning;
  const Instant start{};
  reckoning.drive(start + kTick, {0.01, 0.0});
  reckoning.drive(start + 2 * kTick, {0.02, 0.0});
  EXPECT_NEAR(reckoning.pose_at(start + kTick + kTick / 2).p_m.x(), 0.02, 1e-12);
  EXPECT_NEAR(reckoning.pose_at(start + kTick / 2).p_m.x(), 0.005, 1e-12);
  EXPECT_NEAR(reckoning.pose_at(start + 9 * kTick).p_m.x(), 0.03, 1e-12);
}

}  // namespace
}  // namespace sensotwin::robot
