// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/localizer_conversion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace falko_slam {
namespace {

LocalizerReport a_report() {
  LocalizerReport report;
  report.status = LocalizationStatus::kDegraded;
  report.reason = LocalizationReason::kNoScans;
  report.stamp = Time(std::chrono::milliseconds(12500));
  report.map_T_base = PoseEstimate{Pose2(3.0, 4.0, 0.5 * M_PI), Eigen::Matrix3d::Zero()};
  report.map_T_base->covariance.diagonal() << 0.04, 0.01, 0.0001;
  report.seen.resize(3);
  report.seen[0].id = 7;
  report.seen[2].id = 7;
  report.agreement.used = 2;
  report.agreement.strangers = 1;
  report.agreement.in_state = 9;
  return report;
}

TEST(LocalizerStatusMessage, SaysWhatAndWhyAndHowSure) {
  const LocalizerStatus message = to_message(a_report(), "map");

  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.header.stamp, ros::Time(12, 500000000));
  EXPECT_EQ(message.level, LocalizerStatus::DEGRADED);
  EXPECT_EQ(message.reason, LocalizerStatus::NO_SCANS);
  EXPECT_EQ(message.text, describe(LocalizationReason::kNoScans));
  EXPECT_NEAR(message.along_deviation, 0.1, 1e-9);  // it looks along y
  EXPECT_NEAR(message.across_deviation, 0.2, 1e-9);
  EXPECT_NEAR(message.heading_deviation, 0.01, 1e-9);
  EXPECT_EQ(message.observed, 3U);
  EXPECT_EQ(message.used, 2U);
  EXPECT_EQ(message.strangers, 1U);
  EXPECT_EQ(message.used_of_state, 9U);
}

TEST(LocalizerStatusMessage, HasNoDeviationsWithoutAPose) {
  const LocalizerStatus message = to_message(LocalizerReport(), "map");
  EXPECT_EQ(message.level, LocalizerStatus::LOST);
  EXPECT_EQ(message.along_deviation, -1.0);
  EXPECT_EQ(message.across_deviation, -1.0);
  EXPECT_EQ(message.heading_deviation, -1.0);
}

TEST(LandmarksInUse, AreEachTheMapsOwnOnce) {
  LandmarkMap map;
  map.landmarks.resize(2);
  map.landmarks[1].id = 7;
  map.landmarks[1].kind = LandmarkKind::kFeature;
  map.landmarks[1].position = {1.0, 2.0};
  map.landmarks[1].covariance << 3.0, 1.0, 1.0, 2.0;

  const LandmarkArray message = landmarks_in_use(a_report(), map, {}, "map");

  ASSERT_EQ(message.landmarks.size(), 1U);
  const LandmarkEstimate& landmark = message.landmarks[0];
  EXPECT_EQ(landmark.id, 7U);
  EXPECT_EQ(landmark.kind, LandmarkEstimate::FEATURE);
  EXPECT_EQ(landmark.source, LandmarkEstimate::MAP);
  EXPECT_EQ(landmark.position.y, 2.0);
  EXPECT_EQ(landmark.covariance[1], 1.0);
  EXPECT_EQ(landmark.covariance[2], 2.0);
}

TEST(LandmarksInUse, HaveThePointsOfTheState) {
  ActiveLandmark corner;
  corner.number = 12;
  corner.middle = {4.0, -1.0};
  corner.covariance << 3.0, 1.0, 1.0, 2.0;

  const LandmarkArray message = landmarks_in_use(LocalizerReport(), LandmarkMap(), {corner}, "map");

  ASSERT_EQ(message.landmarks.size(), 1U);
  const LandmarkEstimate& landmark = message.landmarks[0];
  EXPECT_EQ(landmark.id, 12U);
  EXPECT_EQ(landmark.kind, LandmarkEstimate::FEATURE);
  EXPECT_EQ(landmark.source, LandmarkEstimate::STATE);
  EXPECT_EQ(landmark.position.x, 4.0);
  EXPECT_EQ(landmark.covariance[2], 2.0);
  EXPECT_EQ(landmark.half_length, 0.0);
}

// A wall at x = 3, seen from the origin, of which the stretch about y = 4 was seen.
ActiveLandmark a_face() {
  ActiveLandmark face;
  face.is_line = true;
  face.line = {0.0, 3.0, Eigen::Vector2d::Zero()};
  face.middle = {3.1, 4.0};
  face.half_length = 0.8;
  return face;
}

TEST(LandmarksInUse, HaveTheFacesOfTheStateAsTheyWereSeen) {
  const LandmarkArray message =
      landmarks_in_use(LocalizerReport(), LandmarkMap(), {a_face()}, "map");

  ASSERT_EQ(message.landmarks.size(), 1U);
  const LandmarkEstimate& landmark = message.landmarks[0];
  EXPECT_EQ(landmark.kind, LandmarkEstimate::FACE);
  EXPECT_EQ(landmark.source, LandmarkEstimate::STATE);
  EXPECT_NEAR(landmark.position.x, 3.0, 1e-12);  // on the line
  EXPECT_NEAR(landmark.position.y, 4.0, 1e-12);
  EXPECT_NEAR(landmark.direction, -0.5 * M_PI, 1e-12);  // the laser is to the right
  EXPECT_EQ(landmark.half_length, 0.8);
}

// By how much the place across it changes with (angle, offset), by numeric differentiation.
TEST(LandmarksInUse, HaveTheCovarianceOfFacesAtTheirMiddle) {
  ActiveLandmark face = a_face();
  face.covariance << 4e-6, 1e-6, 1e-6, 9e-6;
  const auto across = [&](double angle, double offset) {
    const MapLine moved{face.line.angle + angle, face.line.offset + offset, face.line.anchor};
    const double way = (4.0 - nearest_point(moved, {3.0, 4.0}).y()) / direction_of(moved).y();
    return (nearest_point(moved, {3.0, 4.0}) + way * direction_of(moved)).x();
  };
  constexpr double kStep = 1e-6;
  Eigen::Matrix2d slope = Eigen::Matrix2d::Identity();
  slope(1, 0) = (across(kStep, 0.0) - across(-kStep, 0.0)) / (2.0 * kStep);
  slope(1, 1) = (across(0.0, kStep) - across(0.0, -kStep)) / (2.0 * kStep);
  const Eigen::Matrix2d expected = slope * face.covariance * slope.transpose();

  const auto message = landmarks_in_use(LocalizerReport(), LandmarkMap(), {face}, "map");

  ASSERT_EQ(message.landmarks.size(), 1U);
  EXPECT_NEAR(message.landmarks[0].covariance[0], expected(0, 0), 1e-10);
  EXPECT_NEAR(message.landmarks[0].covariance[1], expected(0, 1), 1e-10);
  EXPECT_NEAR(message.landmarks[0].covariance[2], expected(1, 1), 1e-10);
}

TEST(PosesSaid, ComeBackAsTheyWent) {
  const PoseEstimate pose = *a_report().map_T_base;
  const PoseEstimate back = from_message(pose_message(pose, Time(), "map"), "map", {});
  EXPECT_NEAR((back.pose.inverse() * pose.pose).translation().norm(), 0.0, 1e-12);
  EXPECT_NEAR(back.pose.theta(), pose.pose.theta(), 1e-12);
  EXPECT_EQ(back.covariance, pose.covariance);
}

TEST(PosesSaid, WithoutACovarianceGetTheInitialOne) {
  InitialPose initial;
  initial.position_deviation = 0.5;
  initial.heading_deviation = 0.2;
  auto message = pose_message({}, Time(), "/map");
  const PoseEstimate said = from_message(message, "map", initial);
  EXPECT_NEAR(said.covariance(1, 1), 0.25, 1e-12);
  EXPECT_NEAR(said.covariance(2, 2), 0.04, 1e-12);
}

TEST(PosesSaid, AreRefusedWithTheReason) {
  const auto complaint = [](auto&& change) {
    auto message = pose_message(*a_report().map_T_base, Time(), "map");
    change(message);
    try {
      from_message(message, "map", {});
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint([](auto& m) { m.header.frame_id = "odom"; }),
            "it is in the frame odom, not map");
  EXPECT_EQ(complaint([](auto& m) { m.pose.pose.orientation.z = kNan; }),
            "its orientation is not a quaternion of length 1");
  EXPECT_EQ(complaint([](auto& m) { m.pose.pose.position.x = kNan; }),
            "its position is not finite");
  EXPECT_EQ(complaint([](auto& m) { m.pose.covariance[5] = kNan; }),
            "its covariance is not finite");
  EXPECT_EQ(complaint([](auto& m) { m.pose.covariance[1] = 0.01; }),
            "its covariance is not symmetric and positive semidefinite");
}

// The device saw it a tenth of a second after the stamp, 0.2 m farther on.
TEST(ReflectorObservations, AreMovedToTheStamp) {
  ReflectorArray message;
  message.reflectors.resize(2);
  message.reflectors[0].position.x = 5.0;
  message.reflectors[0].time_offset = ros::Duration(0.1);
  message.reflectors[0].hit_count = 4;
  message.reflectors[1].position.x = std::numeric_limits<double>::quiet_NaN();

  const auto observations = reflector_observations(message, {2.0, 0.0}, Pose2(0.4, 0.1, 0.0), {});

  ASSERT_EQ(observations.size(), 1U);
  EXPECT_NEAR(observations[0].value(0), 5.2, 1e-12);
  EXPECT_NEAR(observations[0].value(1), 0.0, 1e-12);
  EXPECT_GT(observations[0].covariance(0, 0), 0.0);
}

}  // namespace
}  // namespace falko_slam
