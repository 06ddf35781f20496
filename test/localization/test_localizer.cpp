// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/localizer.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <stdexcept>

#include "covariance_check.hpp"
#include "falko_slam/localization/localization_status.hpp"
#include "falko_slam/localization/localizer_report.hpp"
#include "localization/localizer_drive.hpp"

namespace falko_slam {
namespace {

using test::LocalizerDrive;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool all_finite(const LocalizerReport& report) {
  if (!std::isfinite(report.evidence) || !std::isfinite(report.agreement.nis)) return false;
  if (!report.map_T_base) return true;
  const Pose2& pose = report.map_T_base->pose;
  return pose.translation().allFinite() && std::isfinite(pose.theta()) &&
         report.map_T_base->covariance.allFinite();
}

TEST(LocalizerParams, SeekReflectorsOfTheMapsDiameter) {
  LandmarkMap map;
  ReflectorDetectorParams reflectors;
  EXPECT_EQ(take_diameter_of(map, reflectors), "");
  map.landmarks.resize(2);
  map.landmarks[0].kind = LandmarkKind::kFeature;
  map.landmarks[0].layout.diameter = 0.5;
  EXPECT_EQ(take_diameter_of(map, reflectors), "");
  map.landmarks[1].layout.diameter = 0.06;
  EXPECT_EQ(take_diameter_of(map, reflectors),
            "reflectors have a diameter of 0.06 m, as the map says, not of 0.08 m, as the "
            "parameters say");
  EXPECT_EQ(reflectors.diameter, 0.06);
  EXPECT_EQ(take_diameter_of(map, reflectors), "");
}

TEST(Localizer, FollowsADriveWithinCentimetres) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer_at_start();
  int ok = 0, scans = 0;

  drive.play(localizer, 0.0, 28.0, [&](const LocalizerReport& report) {
    ++scans;
    if (report.status == LocalizationStatus::kOk) ++ok;
    EXPECT_LT(drive.error(report), 0.02);
  });

  EXPECT_GT(ok, scans * 9 / 10);
}

TEST(Localizer, FindsItselfWithoutAPose) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer(drive.map());
  EXPECT_EQ(localizer.state().status, LocalizationStatus::kRecovering);

  drive.play(localizer, 5.0, 10.0);

  EXPECT_EQ(localizer.state().status, LocalizationStatus::kOk);
  EXPECT_LT(drive.error(localizer.state()), 0.02);
}

// As who sets a pose may say "anywhere": up to where a covariance is more than a double can
// correct.
TEST(Localizer, FindsItselfAfterAPoseThatMayBeAnywhere) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  for (const double deviation : {1e2, 1e4, 1e5, 1e9, 1e150}) {
    Localizer localizer = drive.localizer(drive.map());
    localizer.set_pose(drive.at(0.0), PoseEstimate{Pose2(), pose_covariance(deviation, kPi)});
    drive.play(localizer, 0.0, 20.0, [&](const LocalizerReport& report) {
      if (report.status == LocalizationStatus::kOk) {
        EXPECT_LT(drive.error(report), 0.05);
      }
      if (!report.map_T_base) return;
      EXPECT_TRUE(is_usable(*report.map_T_base)) << deviation;
    });
    EXPECT_EQ(localizer.state().status, LocalizationStatus::kOk) << deviation;
    EXPECT_LT(drive.error(localizer.state()), 0.02) << deviation;
  }
}

TEST(Localizer, NeverCallsAWrongPoseOk) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer(drive.map());
  const Pose2 truth = drive.truth(drive.at(5.0));
  localizer.set_pose(drive.at(5.0),
                     PoseEstimate{truth * Pose2(1.0, 2.0, 0.3), pose_covariance(0.02, 0.005)});
  bool lost = false;

  drive.play(localizer, 5.0, 12.0, [&](const LocalizerReport& report) {
    lost = lost || !report.map_T_base;
    if (report.status == LocalizationStatus::kOk) {
      EXPECT_LT(drive.error(report), 0.05);
    }
  });

  EXPECT_TRUE(lost);
  EXPECT_EQ(localizer.state().status, LocalizationStatus::kOk);
}

TEST(Localizer, StandsHalfOfTheReflectorsMoved) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  LandmarkMap map = drive.map();
  for (std::size_t i = 0; i < map.landmarks.size(); i += 2) {
    map.landmarks[i].position += Eigen::Vector2d(0.4, -0.5);
  }
  Localizer localizer = drive.localizer(map);
  localizer.set_pose(drive.at(0.0),
                     PoseEstimate{drive.truth(drive.at(0.0)), pose_covariance(0.02, 0.005)});
  int degraded = 0, scans = 0;

  drive.play(localizer, 0.0, 18.0, [&](const LocalizerReport& report) {
    ++scans;
    if (report.status == LocalizationStatus::kDegraded) ++degraded;
    EXPECT_LT(drive.error(report), 0.05) << name_of(report.reason);
  });

  EXPECT_GT(degraded, scans / 2);
}

TEST(Localizer, IsDegradedWhileAllReflectorsAreCovered) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer_at_start();
  drive.play(localizer, 0.0, 6.0);

  drive.play(localizer, 6.0, 9.0, {}, [](DriveInputEvent& event) {
    if (event.scan) {
      for (float& intensity : event.scan->intensities) intensity = std::min(intensity, 400.0F);
    }
    return true;
  });
  EXPECT_EQ(localizer.state().status, LocalizationStatus::kDegraded);
  drive.play(localizer, 9.0, 12.0);

  EXPECT_EQ(localizer.state().status, LocalizationStatus::kOk);
  EXPECT_LT(drive.error(localizer.state()), 0.02);
}

TEST(Localizer, ShowsTheLandmarksOfItsStateWhileThereIsAPose) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer_at_start();
  EXPECT_TRUE(localizer.landmarks().empty());

  drive.play(localizer, 0.0, 6.0);
  const std::vector<ActiveLandmark> landmarks = localizer.landmarks();
  EXPECT_GT(landmarks.size(), 5U);
  EXPECT_LE(landmarks.size(), static_cast<std::size_t>(localizer.params().landmarks.max_landmarks));

  localizer.globalize();
  EXPECT_TRUE(localizer.landmarks().empty());
}

TEST(Localizer, IsDegradedWithoutScansAndOkAfter) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer_at_start();
  drive.play(localizer, 0.0, 6.0);

  drive.play(localizer, 6.0, 9.0, {}, [](DriveInputEvent& event) { return !event.scan; });
  EXPECT_EQ(localizer.state().status, LocalizationStatus::kDegraded);
  EXPECT_EQ(localizer.state().reason, LocalizationReason::kNoScans);
  EXPECT_LT(drive.error(localizer.state()), 0.1);
  drive.play(localizer, 9.0, 12.0);

  EXPECT_EQ(localizer.state().status, LocalizationStatus::kOk);
}

TEST(Localizer, NoticesThatTheEncodersAreFrozen) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer_at_start();
  drive.play(localizer, 0.0, 8.0);
  int disagreed = 0;

  const auto look = [&](const LocalizerReport& report) {
    if (report.reason == LocalizationReason::kOdometryDisagrees) ++disagreed;
    if (report.map_T_base) {
      EXPECT_LT(drive.error(report), 0.35);
    }
    if (report.status == LocalizationStatus::kOk) {
      EXPECT_LT(drive.error(report), 0.15);
    }
  };
  drive.play(localizer, 8.0, 11.0, look, [](DriveInputEvent& event) {
    if (event.motion) event.motion = PoseEstimate{};
    return true;
  });
  EXPECT_GT(disagreed, 5);
  drive.play(localizer, 11.0, 16.0);

  EXPECT_EQ(localizer.state().status, LocalizationStatus::kOk);
  EXPECT_LT(drive.error(localizer.state()), 0.02);
}

TEST(Localizer, BridgesEncodersThatAreSilent) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer_at_start();
  drive.play(localizer, 0.0, 8.0);

  // What the wheel did meanwhile is in the counters, so in the motion that comes at last.
  PoseEstimate sum;
  drive.play(
      localizer, 8.0, 16.0,
      [&](const LocalizerReport& report) {
        if (report.status == LocalizationStatus::kOk) {
          EXPECT_LT(drive.error(report), 0.15);
        }
      },
      [&](DriveInputEvent& event) {
        if (!event.motion) return true;
        sum = compose(sum, *event.motion);
        if (event.stamp < drive.at(11.0)) return false;
        event.motion = sum;
        sum = {};
        return true;
      });

  EXPECT_EQ(localizer.state().status, LocalizationStatus::kOk);
  EXPECT_LT(drive.error(localizer.state()), 0.02);
}

TEST(Localizer, GoesOnAfterTheClockWasSetBack) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer_at_start();
  drive.play(localizer, 0.0, 8.0);
  const Duration shift = std::chrono::seconds(-500);
  bool told = false;

  drive.play(
      localizer, 8.0, 12.0,
      [&](const LocalizerReport& report) {
        told = told || report.reason == LocalizationReason::kClockSetBack;
      },
      {}, shift);

  EXPECT_TRUE(told);
  EXPECT_EQ(localizer.state().status, LocalizationStatus::kOk);
  EXPECT_LT(drive.error(localizer.state(), shift), 0.02);
}

TEST(Localizer, TakesNothingThatIsNotFinite) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer_at_start();
  drive.play(localizer, 0.0, 6.0);

  EXPECT_EQ(localizer.add_motion(drive.at(6.01), {Pose2(kNan, 0.0, 0.0), Eigen::Matrix3d::Zero()}),
            InputVerdict::kInvalid);
  localizer.add_reflectors(
      drive.at(6.0),
      {{ObservationModel::kCartesian, {kNan, 1.0}, Eigen::Matrix2d::Identity(), {}}});
  EXPECT_THROW(localizer.set_pose(drive.at(6.0),
                                  PoseEstimate{Pose2(kNan, 0.0, 0.0), Eigen::Matrix3d::Zero()}),
               std::invalid_argument);
  drive.play(
      localizer, 6.0, 9.0, [&](const LocalizerReport& report) { EXPECT_TRUE(all_finite(report)); },
      [](DriveInputEvent& event) {
        if (!event.scan) return true;
        for (std::size_t beam = 0; beam < event.scan->size(); beam += 3) {
          event.scan->ranges[beam] = kNan;
          event.scan->status[beam] = BeamStatus::kErroneous;
        }
        return true;
      });

  drive.play(localizer, 9.0, 12.0);
  EXPECT_EQ(localizer.state().status, LocalizationStatus::kOk);
}

TEST(Localizer, NoticesThatItWasCarried) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer_at_start();
  drive.play(localizer, 0.0, 5.0);
  const Duration shift = from_seconds(5.0 - 24.0);
  bool lost = false;

  drive.play(
      localizer, 24.0, 28.0,
      [&](const LocalizerReport& report) {
        lost = lost || !report.map_T_base;
        if (report.status == LocalizationStatus::kOk) {
          EXPECT_LT(drive.error(report, shift), 0.05);
        }
      },
      {}, shift);

  EXPECT_TRUE(lost);
}

TEST(Localizer, IsLostWithoutBothSensors) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer_at_start();
  drive.play(localizer, 0.0, 6.0);

  EXPECT_NE(localizer.check(drive.at(7.0)).status, LocalizationStatus::kOk);
  EXPECT_FALSE(localizer.check(drive.at(20.0)).map_T_base);
}

TEST(Localizer, HasNoPoseWhereNoneIsSetNorSearchedFor) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  LocalizerParams params;
  params.search_alone = false;
  Localizer localizer(params, drive.map());

  drive.play(localizer, 0.0, 2.0);

  EXPECT_EQ(localizer.state().status, LocalizationStatus::kLost);
  EXPECT_EQ(localizer.state().reason, LocalizationReason::kNoPose);
  EXPECT_FALSE(localizer.state().map_T_base);
  EXPECT_GT(localizer.state().seen.size(), 0U);
}

TEST(Localizer, TakesAPoseOfALaterStampBackToTheLastMotion) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer(drive.map());
  drive.play(localizer, 5.0, 7.0);

  localizer.set_pose(drive.at(7.1),
                     PoseEstimate{drive.truth(drive.at(7.1)), pose_covariance(0.02, 0.005)});

  EXPECT_LE(localizer.state().stamp, drive.at(7.0));
  EXPECT_LT(drive.error(localizer.state()), 0.02);
}

TEST(Localizer, LeavesOutAScanOlderThanItsHistory) {
  const LocalizerDrive& drive = LocalizerDrive::shared();
  Localizer localizer = drive.localizer_at_start();
  std::optional<LaserScan> first;
  drive.play(localizer, 0.0, 10.0, {}, [&](DriveInputEvent& event) {
    if (event.scan && !first) first = *event.scan;
    return true;
  });
  const Pose2 before = localizer.state().map_T_base->pose;

  EXPECT_EQ(localizer.add_scan(*first).input, InputVerdict::kTooOld);
  EXPECT_EQ(localizer.state().map_T_base->pose.translation(), before.translation());
}

TEST(Localizer, RefusesParametersThatAreNone) {
  LocalizerParams params;
  params.monitor.window = -1.0;

  EXPECT_THROW(Localizer(params, LandmarkMap()), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
