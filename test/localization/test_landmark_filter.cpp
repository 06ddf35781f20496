// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/landmark_filter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "falko_slam/common/chi_square.hpp"
#include "falko_slam/localization/pose_filter.hpp"
#include "localization/landmark_drive.hpp"
#include "support/times.hpp"

namespace falko_slam {
namespace {

using Verdict = ObservationVerdict;

const Eigen::Matrix2d kSeenNoise = test::diagonal(0.01, 0.01);
const PoseEstimate kFirst{{}, pose_covariance(1e-4, 1e-5)};

LandmarkFilter filter_with(LandmarkFilterParams params = {}) {
  params.base_T_laser = test::kLaserMount;
  return {params, kFirst};
}

LandmarkObservation point_at(double x, double y) {
  return test::seen(ObservationModel::kCartesian, {}, test::kLaserMount, {x, y}, kSeenNoise);
}

FeatureObservations points(std::vector<LandmarkObservation> all) { return {std::move(all), {}}; }

TEST(LandmarkFilter, TakesAPointAfterSomeHits) {
  LandmarkFilter filter = filter_with();
  EXPECT_EQ(filter.update(test::at_seconds(0.0), points({point_at(5, 1)})).points[0],
            Verdict::kTentative);
  EXPECT_EQ(filter.update(test::at_seconds(0.1), points({point_at(5, 1)})).points[0],
            Verdict::kTentative);
  EXPECT_TRUE(filter.landmarks().empty());
  EXPECT_EQ(filter.update(test::at_seconds(0.2), points({point_at(5, 1)})).points[0],
            Verdict::kAdded);
  ASSERT_EQ(filter.landmarks().size(), 1U);
  EXPECT_LT((filter.landmarks()[0].middle - Eigen::Vector2d(5, 1)).norm(), 1e-9);
  EXPECT_EQ(filter.update(test::at_seconds(0.3), points({point_at(5, 1)})).points[0],
            Verdict::kUsed);
}

TEST(LandmarkFilter, TakesNoPointThatComesAndGoes) {
  LandmarkFilter filter = filter_with();
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(filter.update(test::at_seconds(0.6 * i), points({point_at(5, 1)})).points[0],
              Verdict::kTentative);
  }
}

TEST(LandmarkFilter, DropsWhatItDoesNotSeeForLong) {
  LandmarkFilter filter = filter_with();
  for (int i = 0; i < 3; ++i)
    filter.update(test::at_seconds(0.1 * i), points({point_at(5, 1), point_at(5, 3)}));
  EXPECT_EQ(filter.landmarks().size(), 2U);
  filter.update(test::at_seconds(1.5), points({point_at(5, 1)}));
  EXPECT_EQ(filter.landmarks().size(), 2U);
  EXPECT_EQ(filter.update(test::at_seconds(2.3), points({point_at(5, 1)})).dropped, 1);
  ASSERT_EQ(filter.landmarks().size(), 1U);
  EXPECT_NEAR(filter.landmarks()[0].middle.y(), 1.0, 1e-6);
}

TEST(LandmarkFilter, HoldsNoMoreThanItMayAndPrefersWhatItSees) {
  LandmarkFilterParams params;
  params.max_landmarks = 4;
  LandmarkFilter filter = filter_with(params);
  const auto row = [](double y) {
    return points({point_at(4, y), point_at(5, y), point_at(6, y), point_at(7, y)});
  };
  for (int i = 0; i < 4; ++i) filter.update(test::at_seconds(0.1 * i), row(1.0));
  EXPECT_EQ(filter.landmarks().size(), 4U);
  for (int i = 4; i < 8; ++i) filter.update(test::at_seconds(0.1 * i), row(3.0));
  ASSERT_EQ(filter.landmarks().size(), 4U);
  for (const ActiveLandmark& landmark : filter.landmarks()) {
    EXPECT_NEAR(landmark.middle.y(), 3.0, 1e-6);
  }
}

TEST(LandmarkFilter, RefusesWhatCouldBeEither) {
  LandmarkFilterParams params;
  params.hits = 1;
  params.separation = 0.02;
  LandmarkFilter filter = filter_with(params);
  filter.update(test::at_seconds(0.0), points({point_at(5.0, 1.0), point_at(5.0, 1.06)}));
  ASSERT_EQ(filter.landmarks().size(), 2U);
  EXPECT_EQ(filter.update(test::at_seconds(0.1), points({point_at(5.0, 1.03)})).points[0],
            Verdict::kAmbiguous);
}

TEST(LandmarkFilter, TakesNoPointBesideAnotherOne) {
  LandmarkFilter filter = filter_with();
  for (int i = 0; i < 3; ++i) filter.update(test::at_seconds(0.1 * i), points({point_at(5, 1)}));
  EXPECT_EQ(filter.update(test::at_seconds(0.3), points({point_at(5, 1.1)})).points[0],
            Verdict::kTooNear);
}

std::shared_ptr<const LandmarkIndex> map_of(std::vector<Landmark> landmarks) {
  return std::make_shared<LandmarkIndex>(std::move(landmarks));
}

// Its covariance, Joseph's form or not, and its joint search are written anew: it must be the same.
TEST(LandmarkFilter, IsThePoseFilterWhereAllIsInTheMap) {
  std::mt19937_64 random = test::seeded_random();
  const auto map = map_of(test::scattered_landmarks(200, 40.0, 1.0, 0.005, random));
  const PoseEstimate start{{1.0, 2.0, 0.3}, pose_covariance(0.02, 0.01)};
  LandmarkFilterParams params;
  params.base_T_laser = test::kLaserMount;
  LandmarkFilter filter(params, start, map);
  PoseFilter plain({test::kLaserMount, params.association}, map, start);
  const PoseEstimate motion{{0.1, 0.0, 0.02}, pose_covariance(2e-3, 1e-3)};
  Pose2 truth = start.pose;
  for (int i = 0; i < 20; ++i) {
    truth = truth * motion.pose;
    std::vector<LandmarkObservation> seen;
    for (std::size_t k = 0; k < 12; ++k) {
      seen.push_back(test::noisy(test::seen(ObservationModel::kCartesian, truth, test::kLaserMount,
                                            map->landmarks()[k].position, kSeenNoise),
                                 random));
    }
    filter.predict(motion);
    plain.predict(motion);
    const FeatureUpdate update = filter.update(test::at_seconds(0.1 * i), points(seen));
    EXPECT_NEAR(update.nis, plain.update(seen).nis, 1e-6);
    ASSERT_EQ(update.of_map.size(), 12U);
    EXPECT_EQ(update.of_map[3], 3U);
    EXPECT_TRUE(filter.map_T_base().covariance.isApprox(plain.map_T_base().covariance, 1e-9));
    EXPECT_LT(difference(filter.map_T_base().pose, plain.map_T_base().pose).norm(), 1e-9);
  }
  EXPECT_TRUE(filter.landmarks().empty());
}

TEST(LandmarkFilter, TakesAReflectorForNoCorner) {
  const auto map = map_of({{7, {5.0, 1.0}, kSeenNoise, LandmarkKind::kReflector}});
  LandmarkFilterParams params;
  params.base_T_laser = test::kLaserMount;
  LandmarkFilter filter(params, kFirst, map);
  LandmarkObservation corner = point_at(5, 1);
  corner.kind = LandmarkKind::kFeature;
  const FeatureUpdate update =
      filter.update(test::at_seconds(0.0), points({corner, point_at(5, 1)}));
  EXPECT_EQ(update.points[0], Verdict::kTentative);
  EXPECT_EQ(update.points[1], Verdict::kUsed);
  EXPECT_EQ(update.of_map[0], std::nullopt);
  EXPECT_EQ(update.of_map[1], 0U);
}

TEST(LandmarkFilter, AsksTheMapForIds) {
  const auto map = map_of({{7, {5.0, 1.0}, kSeenNoise}, {8, {5.0, 1.02}, kSeenNoise}});
  LandmarkFilterParams params;
  params.base_T_laser = test::kLaserMount;
  LandmarkFilter filter(params, kFirst, map);
  LandmarkObservation known = point_at(5, 1), unknown = known;
  known.id = 8;
  unknown.id = 9;
  const FeatureUpdate update = filter.update(test::at_seconds(0.0), points({known, unknown}));
  EXPECT_EQ(update.of_map[0], 1U);
  EXPECT_EQ(update.points[1], Verdict::kUnknownId);
}

// A map pins the pose down, landmarks beside it learn from that and hold it when the map is gone.
TEST(LandmarkFilter, KeepsWhatTheMapTaughtIt) {
  const auto map = map_of(
      {{0, {6.0, 2.0}, test::diagonal(1e-3, 1e-3)}, {1, {6.0, -2.0}, test::diagonal(1e-3, 1e-3)}});
  LandmarkFilterParams params;
  params.base_T_laser = test::kLaserMount;
  params.point_wander = 0.0;
  LandmarkFilter filter(params, {{0.05, -0.04, 0.01}, pose_covariance(0.1, 0.03)}, map);
  LandmarkObservation corners[] = {point_at(4, 1), point_at(4, -3)};
  for (auto& corner : corners) corner.kind = LandmarkKind::kFeature;
  for (int i = 0; i < 40; ++i) {
    filter.update(test::at_seconds(0.1 * i),
                  points({point_at(6, 2), point_at(6, -2), corners[0], corners[1]}));
  }
  EXPECT_LT(filter.map_T_base().pose.translation().norm(), 0.005);
  filter.predict({{}, pose_covariance(0.1, 0.03)});
  for (int i = 40; i < 60; ++i)
    filter.update(test::at_seconds(0.1 * i), points({corners[0], corners[1]}));
  EXPECT_LT(filter.map_T_base().pose.translation().norm(), 0.005);
  EXPECT_LT(filter.map_T_base().covariance(0, 0), 1e-4);
}

TEST(LandmarkFilter, LetsLandmarksWanderOverTheWay) {
  LandmarkFilterParams params;
  params.point_wander = 0.03;
  LandmarkFilter filter = filter_with(params);
  LandmarkObservation corner = point_at(5, 1);
  corner.kind = LandmarkKind::kFeature;
  for (int i = 0; i < 3; ++i) filter.update(test::at_seconds(0.1 * i), points({corner}));
  const double before = filter.landmarks().at(0).covariance(0, 0);
  filter.predict({{0.0, 0.0, 0.5}, kFirst.covariance});  // turning shows no other side of it
  EXPECT_EQ(filter.landmarks()[0].covariance(0, 0), before);
  for (int i = 0; i < 4; ++i) filter.predict({{1.0, 0.0, 0.0}, kFirst.covariance});
  EXPECT_NEAR(filter.landmarks()[0].covariance(0, 0), before + 4.0 * 0.03 * 0.03, 1e-12);
}

TEST(LandmarkFilter, IsResetWithoutItsLandmarksAndCopiedWithThem) {
  LandmarkFilter filter = filter_with();
  for (int i = 0; i < 3; ++i) filter.update(test::at_seconds(0.1 * i), points({point_at(5, 1)}));
  LandmarkFilter copy = filter;
  filter.reset({{1.0, 0.0, 0.0}, kFirst.covariance});
  EXPECT_TRUE(filter.landmarks().empty());
  EXPECT_EQ(filter.map_T_base().pose.x(), 1.0);
  EXPECT_EQ(copy.update(test::at_seconds(0.3), points({point_at(5, 1)})).points[0], Verdict::kUsed);
  filter = copy;
  EXPECT_EQ(filter.covariance(), copy.covariance());
  EXPECT_THROW(filter.reset({{}, -kFirst.covariance}), std::invalid_argument);
}

TEST(LandmarkFilter, LetsNothingInThatIsNotFinite) {
  LandmarkFilter filter = filter_with();
  LandmarkObservation bad = point_at(5, 1);
  bad.value.x() = std::nan("");
  LineObservation line{{0.0, HUGE_VAL}, kSeenNoise, {1.0, 0.0}, 0.4};
  const FeatureUpdate update = filter.update(test::at_seconds(0.0), {{bad}, {line}});
  EXPECT_EQ(update.points[0], Verdict::kInvalid);
  EXPECT_EQ(update.lines[0], Verdict::kInvalid);
  EXPECT_FALSE(filter.predict({{0.0, std::nan(""), 0.0}, kFirst.covariance}));
  EXPECT_FALSE(filter.predict({{}, -kFirst.covariance}));
  EXPECT_TRUE(filter.covariance().allFinite());
}

TEST(LandmarkFilter, TakesRangeAndBearingAsPoints) {
  LandmarkFilter filter = filter_with();
  const auto seen = test::seen(ObservationModel::kRangeBearing, {}, test::kLaserMount, {6.0, -2.0},
                               test::diagonal(0.01, 0.002));
  for (int i = 0; i < 4; ++i) filter.update(test::at_seconds(0.1 * i), points({seen}));
  ASSERT_EQ(filter.landmarks().size(), 1U);
  EXPECT_LT((filter.landmarks()[0].middle - Eigen::Vector2d(6, -2)).norm(), 1e-9);
}

// A corridor of faces and their corners on either side; noise exactly as the filter is told.
class Corridor {
 public:
  explicit Corridor(std::mt19937_64& random) : random_(random) {
    for (int i = 0; i < 16; ++i) {
      for (const double side : {-1.0, 1.0}) {
        const double along = 0.95 * i + test::uniform(random, 0.0, 0.1);
        const double y = side * (1.35 + test::uniform(random, -0.02, 0.02));
        const double turn = test::uniform(random, -0.01, 0.01);
        faces_.push_back({{along + 0.4, y, side * 0.5 * kPi + turn}});
        corners_.emplace_back(along, y);
      }
    }
  }

  FeatureObservations look(const Pose2& map_T_base) {
    FeatureObservations seen;
    const Pose2 laser_T_map = (map_T_base * test::kLaserMount).inverse();
    for (const Eigen::Vector2d& corner : corners_) {
      if (is_seen(laser_T_map * corner)) {
        seen.points.push_back(test::noisy(test::seen(ObservationModel::kCartesian, map_T_base,
                                                     test::kLaserMount, corner, kSeenNoise),
                                          random_));
      }
    }
    for (const Face& face : faces_) {
      const Pose2 laser_T_face = laser_T_map * face.map_T_face;  // x along the normal
      if (!is_seen(laser_T_face.translation())) continue;
      LineObservation line;
      line.covariance = test::diagonal(0.006, 0.005);
      const Eigen::Vector2d normal = laser_T_face.rotation().col(0);
      line.value << laser_T_face.theta(), normal.dot(laser_T_face.translation());
      line.value += test::drawn<2>(line.covariance, random_);
      line.middle = laser_T_face.translation();
      line.half_length = 0.4;
      seen.lines.push_back(line);
    }
    return seen;
  }

 private:
  struct Face {
    Pose2 map_T_face;
  };
  static bool is_seen(const Eigen::Vector2d& in_laser) {
    return in_laser.norm() < 6.0 && in_laser.norm() > 0.5;
  }

  std::mt19937_64& random_;
  std::vector<Face> faces_;
  std::vector<Eigen::Vector2d> corners_;
};

struct DriveTally {
  double nees = 0.0, nis = 0.0;
  int nis_degrees = 0;
  double odometry_error = 0.0, error = 0.0;  // [m]
  double smallest_eigenvalue = 1.0;
};

DriveTally drive(std::mt19937_64& random, const LandmarkFilterParams& params) {
  Corridor corridor(random);
  LandmarkFilter filter = filter_with(params);
  PoseEstimate odometry = kFirst;
  Pose2 truth = test::disturbed(kFirst, random);
  DriveTally run;
  for (int step = 0; step < 80; ++step) {
    const PoseEstimate motion = tricycle_motion({}, 400.0, {0.0, 0.0}, {});
    PoseEstimate real = motion;
    real.covariance += 1e-12 * Eigen::Matrix3d::Identity();
    truth = truth * test::disturbed(real, random);
    filter.predict(motion);
    odometry = compose(odometry, motion);
    const FeatureUpdate update =
        filter.update(test::at_seconds(0.125 * step), corridor.look(truth));
    run.nis += update.nis;
    run.nis_degrees += update.degrees_of_freedom;
  }
  const Eigen::MatrixXd P = filter.covariance();
  run.smallest_eigenvalue =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(P).eigenvalues().minCoeff();
  EXPECT_EQ((P - P.transpose()).norm(), 0.0);
  run.nees = test::nees(filter.map_T_base(), truth);
  run.error = (filter.map_T_base().pose.translation() - truth.translation()).norm();
  run.odometry_error = (odometry.pose.translation() - truth.translation()).norm();
  return run;
}

TEST(LandmarkFilter, IsConsistentInACorridorAndBetterThanOdometry) {
  std::mt19937_64 random = test::seeded_random();
  LandmarkFilterParams params;
  params.association.gate_probability = params.association.joint_probability = 0.999999;
  params.hits = 2;
  params.point_wander = params.face_wander = params.face_turn_wander = 0.0;  // nothing wanders here
  constexpr int kRuns = 50;
  DriveTally sum;
  for (int i = 0; i < kRuns; ++i) {
    const DriveTally run = drive(random, params);
    sum.nees += run.nees;
    sum.nis += run.nis;
    sum.nis_degrees += run.nis_degrees;
    sum.error += run.error;
    sum.odometry_error += run.odometry_error;
    EXPECT_GT(run.smallest_eigenvalue, 0.0);
  }
  EXPECT_LT(sum.nees, chi_square_bound(0.025, 3 * kRuns));
  EXPECT_GT(sum.nees, chi_square_bound(0.975, 3 * kRuns));
  EXPECT_LT(sum.nis, chi_square_bound(0.025, sum.nis_degrees));
  EXPECT_GT(sum.nis, chi_square_bound(0.975, sum.nis_degrees));
  EXPECT_LT(sum.error, 0.5 * sum.odometry_error);
}

TEST(LandmarkFilterParams, AreValidatedWithNameAndValue) {
  LandmarkFilterParams params;
  EXPECT_NO_THROW(validate(params));
  params.max_landmarks = 0;
  try {
    validate(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("max_landmarks = 0"), std::string::npos);
  }
  params = {};
  params.hits = 0;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.forget_after = 0.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.give_up_after = std::nan("");
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.separation = -1.0;
  EXPECT_THROW(LandmarkFilter(params, kFirst), std::invalid_argument);
  params = {};
  params.base_T_laser = Pose2(0.0, std::nan(""), 0.0);
  EXPECT_THROW(LandmarkFilter(params, kFirst), std::invalid_argument);
  EXPECT_THROW(LandmarkFilter({}, {{}, -kFirst.covariance}), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
