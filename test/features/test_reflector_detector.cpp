// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/reflector_detector.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "falko_slam/evaluation/scan_perturbation.hpp"
#include "falko_slam/features/reflector_detector_fields.hpp"
#include "support/field_values.hpp"
#include "support/hand_made_scans.hpp"
#include "support/reflector_worlds.hpp"

namespace falko_slam {
namespace {

using test::look_at;
using test::room_with_reflectors;

struct Found {
  ReflectorReport report;
  std::vector<DetectedReflector> reflectors;
};

Found detect(const LaserScan& scan, const ReflectorDetectorParams& params = {}) {
  Found found;
  found.report = ReflectorDetector(params).detect(scan, found.reflectors);
  return found;
}

// In standard deviations.
double distance(const DetectedReflector& found, const Eigen::Vector2d& truth) {
  const Eigen::Vector2d error = found.center - truth;
  return std::sqrt(error.dot(found.covariance.inverse() * error));
}

TEST(ReflectorDetector, FindsEachReflectorOnceWhereItIs) {
  const std::vector<Eigen::Vector2d> centers = {
      {3.0, 1.0}, {0.5, 8.0}, {-12.0, 5.0}, {-4.0, -15.0}, {20.0, -3.0}};
  const auto found = detect(look_at(room_with_reflectors(centers)));

  ASSERT_EQ(found.reflectors.size(), centers.size());
  for (const Eigen::Vector2d& center : centers) {
    const auto same = std::find_if(found.reflectors.begin(), found.reflectors.end(),
                                   [&](const DetectedReflector& reflector) {
                                     return (reflector.center - center).norm() < 0.05;
                                   });
    ASSERT_NE(same, found.reflectors.end()) << center.transpose();
    EXPECT_LT(distance(*same, center), 4.0) << center.transpose();
    EXPECT_FALSE(same->partly_hidden);
  }
}

TEST(ReflectorDetector, TellsBeamsTimeAndBrightness) {
  const LaserScan scan = look_at(room_with_reflectors({{5.0, 0.0}}));
  const auto found = detect(scan);

  ASSERT_EQ(found.reflectors.size(), 1U);
  const DetectedReflector& reflector = found.reflectors[0];
  EXPECT_EQ(reflector.hits, reflector.last_beam - reflector.first_beam + 1);
  EXPECT_NEAR(reflector.middle_beam, 720.0, 0.5);
  EXPECT_EQ(reflector.time,
            scan.first_beam_time + Duration(std::llround(reflector.middle_beam *
                                                         double(scan.time_increment.count()))));
  const auto first = scan.intensities.begin() + static_cast<std::ptrdiff_t>(reflector.first_beam);
  const auto end = scan.intensities.begin() + static_cast<std::ptrdiff_t>(reflector.last_beam) + 1;
  EXPECT_EQ(reflector.peak_intensity, static_cast<double>(*std::max_element(first, end)));
  EXPECT_LT(reflector.mean_intensity, reflector.peak_intensity);
}

TEST(ReflectorDetector, FindsOneReflectorAcrossTheSeam) {
  const auto found = detect(look_at(room_with_reflectors({{-6.0, 0.0}})));

  ASSERT_EQ(found.reflectors.size(), 1U);
  EXPECT_GT(found.reflectors[0].first_beam, found.reflectors[0].last_beam);
  EXPECT_LT(distance(found.reflectors[0], {-6.0, 0.0}), 4.0);
  EXPECT_LT(found.reflectors[0].middle_beam, 1440.0);
}

TEST(ReflectorDetector, TurnsWithAClosedScan) {
  const LaserScan scan = look_at(room_with_reflectors({{3.0, 1.0}, {-6.0, 0.0}, {2.0, -9.0}}));
  ReflectorDetectorParams params;
  params.memory = 0;
  const auto found = detect(scan, params).reflectors;
  ASSERT_EQ(found.size(), 3U);
  for (const std::size_t turn : {1U, 717U, 1439U}) {
    const Pose2 back(0.0, 0.0, static_cast<double>(turn) * scan.angle_increment);
    const auto turned = detect(with_beams_rotated(scan, turn), params).reflectors;
    ASSERT_EQ(turned.size(), found.size());
    for (const DetectedReflector& reflector : turned) {
      EXPECT_EQ(std::count_if(found.begin(), found.end(),
                              [&](const DetectedReflector& other) {
                                return (back * reflector.center - other.center).norm() < 1e-9 &&
                                       reflector.hits == other.hits;
                              }),
                1);
    }
  }
}

TEST(ReflectorDetector, TellsTwoNeighboursApart) {
  const std::vector<Eigen::Vector2d> centers = {{4.0, 0.1}, {4.0, -0.1}};
  const auto found = detect(look_at(room_with_reflectors(centers)));
  ASSERT_EQ(found.reflectors.size(), 2U);
  EXPECT_LT((found.reflectors[0].center - centers[1]).norm(), 0.02);
  EXPECT_LT((found.reflectors[1].center - centers[0]).norm(), 0.02);
}

TEST(ReflectorDetector, KeepsToTheTrueMiddleWhereHalfOfOneIsHidden) {
  World world = room_with_reflectors({{5.0, 0.0}});
  world.fixed.faces.push_back({{3.0, 0.01}, {3.0, 0.6}, test::kDark});  // hides what is left of it
  const auto found = detect(look_at(world));
  ASSERT_EQ(found.reflectors.size(), 1U);
  EXPECT_TRUE(found.reflectors[0].partly_hidden);
  EXPECT_LT(distance(found.reflectors[0], {5.0, 0.0}), 4.0);
  EXPECT_LT((found.reflectors[0].center - Eigen::Vector2d(5.0, 0.0)).norm(), 0.02);
}

TEST(ReflectorDetector, RefusesWhatIsTooWide) {
  for (const double width : {0.25, 0.4, 3.0}) {  // vests, a wall
    World world = room_with_reflectors({}, 14.0);
    world.fixed.faces.push_back({{5.0, -0.5 * width}, {5.0, 0.5 * width}, test::kReflector});
    const auto found = detect(look_at(world));
    EXPECT_TRUE(found.reflectors.empty()) << width;
    EXPECT_EQ(found.report.count(ReflectorRefusal::kTooWide), 1U) << width;
  }
}

TEST(ReflectorDetector, FindsAReflectorBesideAVestThatStays) {
  World world = room_with_reflectors({{5.0, 1.0}}, 14.0);
  world.fixed.faces.push_back({{5.0, -0.5}, {5.0, -0.1}, test::kReflector});
  const LaserScan scan = look_at(world);
  ReflectorDetector detector;
  for (int i = 0; i < 200; ++i) ASSERT_EQ(detector.detect(scan).size(), 1U) << i;
}

TEST(ReflectorDetector, RefusesWhatIsTooNarrow) {
  World world = room_with_reflectors({});
  world.fixed.cylinders.push_back({{2.0, 0.0}, 0.008, test::kReflector});
  const auto found = detect(look_at(world));
  EXPECT_TRUE(found.reflectors.empty());
  EXPECT_EQ(found.report.count(ReflectorRefusal::kTooNarrow), 1U);
}

TEST(ReflectorDetector, RefusesASingleBrightBeam) {
  LaserScan scan = look_at(room_with_reflectors({}));
  scan.intensities[300] = 60000.0F;
  const auto found = detect(scan);
  EXPECT_TRUE(found.reflectors.empty());
  EXPECT_EQ(found.report.count(ReflectorRefusal::kTooFewBeams), 1U);
}

TEST(ReflectorDetector, FindsNoneAmongOrdinarySurfaces) {
  World world = room_with_reflectors({});
  world.surfaces.push_back({"white", 1.0, 0.0});
  world.fixed.faces.push_back({{6.0, -0.5}, {6.0, 0.5}, world.surfaces.size() - 1});
  world.fixed.cylinders.push_back({{0.0, 4.0}, 0.04, test::kMatt});
  const auto found = detect(look_at(world));
  EXPECT_TRUE(found.reflectors.empty());
  EXPECT_FALSE(found.report.nothing_to_compare);
}

TEST(ReflectorDetector, GoesOverABeamWithoutAnEcho) {
  LaserScan scan = look_at(room_with_reflectors({{3.0, 0.0}}));
  const std::size_t hits = detect(scan).reflectors.at(0).hits;
  scan.ranges[721] = test::kNoRange;
  scan.status[721] = BeamStatus::kZero;
  const auto found = detect(scan);
  ASSERT_EQ(found.reflectors.size(), 1U);
  EXPECT_EQ(found.reflectors[0].hits, hits - 1);
  EXPECT_LT(distance(found.reflectors[0], {3.0, 0.0}), 4.0);
}

TEST(ReflectorDetector, FindsTheMiddleOfAFlatStripSeenAslant) {
  for (const double slant : {0.0, 0.5, 0.9}) {
    World world = room_with_reflectors({});
    const Eigen::Vector2d half(0.05 * std::sin(slant), 0.05 * std::cos(slant)), at(4.0, 1.0);
    world.fixed.faces.push_back({at - half, at + half, test::kReflector});
    ReflectorDetectorParams params;
    params.shape = ReflectorDetectorParams::Shape::kFlat;
    params.diameter = 0.1;
    const auto found = detect(look_at(world), params);
    ASSERT_EQ(found.reflectors.size(), 1U) << slant;
    EXPECT_LT(distance(found.reflectors[0], at), 4.0) << slant;
  }
}

TEST(ReflectorDetector, TakesAGivenThreshold) {
  const LaserScan scan = look_at(room_with_reflectors({{3.0, 1.0}, {2.0, -9.0}}));
  ReflectorDetectorParams params;
  params.threshold = 3000.0;
  EXPECT_EQ(detect(scan, params).reflectors.size(), 2U);
  params.threshold_falloff = 0.8;
  EXPECT_EQ(detect(scan, params).reflectors.size(), 2U);
  EXPECT_NEAR(ReflectorDetector(params).threshold(2.0), 3000.0 * std::pow(2.0, -0.8), 1e-9);
  params.threshold = 60000.0;
  EXPECT_TRUE(detect(scan, params).reflectors.empty());
}

// As of a scan whose darker points have been blanked.
TEST(ReflectorDetector, GoesByWidthWhereThereIsNothingToCompare) {
  LaserScan scan = test::circle_of(std::vector<double>(1440, test::kNoRange));
  scan.intensities.assign(1440, 0.0F);
  for (const auto& [begin, end] : {std::pair(100, 109), std::pair(700, 760)}) {
    for (int i = begin; i < end; ++i) {
      const auto beam = static_cast<std::size_t>(i);
      scan.ranges[beam] = 2.0;
      scan.status[beam] = BeamStatus::kValid;
      scan.intensities[beam] = 5000.0F + static_cast<float>(i % 2);
    }
  }
  const auto both = detect(scan);  // the wide one is an ordinary surface
  EXPECT_FALSE(both.report.nothing_to_compare);
  EXPECT_TRUE(both.reflectors.empty());
  std::fill(scan.status.begin() + 700, scan.status.begin() + 760, BeamStatus::kNoReturn);
  const auto one = detect(scan);
  EXPECT_TRUE(one.report.nothing_to_compare);
  ASSERT_EQ(one.reflectors.size(), 1U);
  EXPECT_NEAR(one.reflectors[0].middle_beam, 104.0, 0.1);
}

TEST(ReflectorDetector, SaysThatIntensitiesAreMissing) {
  LaserScan scan = look_at(room_with_reflectors({{3.0, 1.0}}));
  const auto fault_of = [&] { return detect(scan).report.fault; };
  EXPECT_EQ(fault_of(), IntensityFault::kNone);
  scan.intensities.assign(scan.size(), 7.0F);
  EXPECT_EQ(fault_of(), IntensityFault::kAllTheSame);
  scan.intensities.assign(scan.size(), 0.0F);
  EXPECT_EQ(fault_of(), IntensityFault::kAllZero);
  scan.intensities.assign(scan.size(), std::nanf(""));
  EXPECT_EQ(fault_of(), IntensityFault::kMissing);
  scan.intensities.clear();
  EXPECT_EQ(fault_of(), IntensityFault::kMissing);
  try {
    ReflectorDetector().detect(scan);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), describe(IntensityFault::kMissing));
  }
  EXPECT_EQ(detect(LaserScan()).report.fault, IntensityFault::kNone);
}

TEST(ReflectorDetectorParams, NamesFieldAndValueOfWhatIsWrong) {
  const auto error_of = [](auto&& change) {
    ReflectorDetectorParams params;
    change(params);
    try {
      ReflectorDetector detector(params);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const double nan = std::nan("");
  EXPECT_EQ(error_of([](auto& p) { p.diameter = 0.0; }), "diameter = 0: must be in [0.01, 1]");
  EXPECT_EQ(error_of([&](auto& p) { p.max_range = nan; }), "max_range = nan: must be in [0, 1000]");
  EXPECT_EQ(error_of([](auto& p) { p.min_visible = 2.0; }), "min_visible = 2: must be in [0.1, 1]");
  EXPECT_EQ(error_of([](auto& p) { p.min_hits = 0; }), "min_hits = 0: must be in [1, 100]");
  EXPECT_EQ(error_of([](auto& p) { p.contrast = 1.0; }), "contrast = 1: must be in [1.05, 1000]");
  EXPECT_EQ(error_of([](auto& p) { p.memory = -1; }), "memory = -1: must be in [0, 1000000]");
}

TEST(ReflectorDetectorParams, AreAllVisited) {
  ReflectorDetectorParams params;
  test::FieldValues before, after;
  visit_reflector_detector_fields(params, before);
  test::FieldChanger changer;
  visit_reflector_detector_fields(params, changer);
  visit_reflector_detector_fields(params, after);
  EXPECT_EQ(before.values().size(), 14U);
  EXPECT_EQ(before.values().at("shape"), "cylinder");
  for (const auto& [name, value] : before.values()) EXPECT_NE(after.values().at(name), value);
}

}  // namespace
}  // namespace falko_slam
