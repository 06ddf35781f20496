// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reflectors in the shipped scenarios, whose true places are known, from 2 to 30 m.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <map>
#include <optional>

#include "falko_slam/features/reflector_detector.hpp"
#include "falko_slam/simulation/reflector_report.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "support/reflector_worlds.hpp"

namespace falko_slam {
namespace {

// Of one band of ranges.
struct Errors {
  int count = 0;
  double along = 0.0;    // sum [m]
  double squares = 0.0;  // of the distances [m^2]
  double nees = 0.0;     // sum
};

struct Outcome {
  std::map<int, Errors> detector;  // by the lower end of the band [m]
  Errors all, reported;            // where both have found it
  int strangers = 0;
};

int band_of(double range) {
  int band = 2;
  for (const int next : {5, 10, 15, 20}) {
    if (range >= next) band = next;
  }
  return band;
}

void add(const Eigen::Vector2d& error, const Eigen::Vector2d& truth, Errors& errors) {
  ++errors.count;
  errors.along += error.dot(truth.normalized());
  errors.squares += error.squaredNorm();
}

class ReflectorStudy {
 public:
  explicit ReflectorStudy(const std::string& scenario)
      : scenario_(read_scenario(FALKO_SLAM_SOURCE_DIR "/config/scenarios/" + scenario + ".yaml")),
        reflectors_(reflectors_of(scenario_.world)) {}

  void look_from(const Pose2& pose) {
    LaserScanner scanner(scenario_.laser, {}, scenario_.world, test::kBegin);
    const SimulatedScan& raw = scanner.scan(test::kBegin, test::track_of(pose), random_);
    LaserScan scan;
    normalize(as_raw_scan(scenario_.laser, raw), {}, scan);
    const auto reported = report_reflectors(scenario_.laser, raw, 0.08);
    std::vector<Reflector> found;
    detector_.detect(scan, found);
    for (const Reflector& reflector : found) judge(reflector, pose, reported);
  }

  Outcome outcome;

 private:
  std::optional<Eigen::Vector2d> truth_near(const Eigen::Vector2d& point, const Pose2& pose) const {
    for (const Cylinder& reflector : reflectors_) {
      const Eigen::Vector2d truth = pose.inverse() * reflector.center;
      if ((truth - point).norm() < 0.2) return truth;
    }
    return std::nullopt;
  }

  void judge(const Reflector& found, const Pose2& pose,
             const std::vector<ReflectorDetection>& reported) {
    const auto truth = truth_near(found.center, pose);
    if (!truth) {
      ++outcome.strangers;
      return;
    }
    if (truth->norm() < 2.0 || truth->norm() > 30.0) return;
    Errors& errors = outcome.detector[band_of(truth->norm())];
    const Eigen::Vector2d error = found.center - *truth;
    add(error, *truth, errors);
    errors.nees += error.dot(found.covariance.inverse() * error);
    for (const ReflectorDetection& other : reported) {
      const Eigen::Vector2d point =
          other.range * Eigen::Vector2d(std::cos(other.bearing), std::sin(other.bearing));
      if (truth_near(point, pose) != truth) continue;
      add(error, *truth, outcome.all);
      add(point - *truth, *truth, outcome.reported);
    }
  }

  Scenario scenario_;
  std::vector<Cylinder> reflectors_;
  ReflectorDetector detector_;
  std::mt19937_64 random_ = test::seeded_random();
};

void expect_consistent(const Outcome& outcome) {
  EXPECT_EQ(outcome.strangers, 0);
  for (const auto& [band, errors] : outcome.detector) {
    ASSERT_GT(errors.count, 20) << band;
    const double mean = errors.nees / errors.count;
    // Two degrees of freedom. Near ones are nearer to the truth than they claim.
    EXPECT_GT(mean, 0.5) << band << " m";
    EXPECT_LT(mean, 2.0 + 3.0 * 2.0 / std::sqrt(errors.count)) << band << " m";
    EXPECT_LT(std::abs(errors.along / errors.count), 0.002) << band << " m";
  }
  EXPECT_LT(outcome.all.squares, outcome.reported.squares);
}

TEST(ReflectorConsistency, HoldsInTheCalibrationArea) {
  ReflectorStudy study("calibration_area");
  auto random = test::seeded_random();
  for (int i = 0; i < 200; ++i) {
    study.look_from({test::uniform(random, -6.0, 6.0), test::uniform(random, -8.0, 6.0),
                     test::uniform(random, -kPi, kPi)});
  }
  EXPECT_EQ(study.outcome.detector.size(), 5U);
  expect_consistent(study.outcome);
}

TEST(ReflectorConsistency, HoldsInTheWarehouse) {
  ReflectorStudy study("warehouse");
  auto random = test::seeded_random();
  for (int i = 0; i < 120; ++i) {  // in the aisle across
    study.look_from({test::uniform(random, 8.0, 50.0), test::uniform(random, 3.5, 8.5),
                     test::uniform(random, -kPi, kPi)});
  }
  expect_consistent(study.outcome);
}

}  // namespace
}  // namespace falko_slam
