// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/descriptor_extractor.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "falko_slam/evaluation/scan_perturbation.hpp"
#include "falko_slam/features/falko.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

// The definitions, point by point and in double precision.
DescribedKeypoint describe_naively(const LaserScan& scan, const Keypoint& keypoint,
                                   const DescriptorParams& params) {
  DescribedKeypoint result;
  result.keypoint = keypoint;
  const auto cells = static_cast<std::size_t>(params.rings * params.sectors);
  result.bsc.words.assign((cells + 63) / 64, 0);
  std::vector<double> histogram(static_cast<std::size_t>(params.sectors));
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (!scan.valid(i)) continue;
    const Eigen::Vector2d offset =
        Pose2(0.0, 0.0, -keypoint.orientation) * (scan.point(i) - keypoint.position);
    if (offset.norm() >= params.radius) continue;
    const int ring = static_cast<int>(offset.norm() * params.rings / params.radius);
    const double angle = std::atan2(offset.y(), offset.x());
    const int sector =
        (static_cast<int>(std::floor(params.sectors / kTwoPi * angle)) + params.sectors) %
        params.sectors;
    const auto cell = static_cast<std::size_t>(ring * params.sectors + sector);
    result.bsc.words[cell / 64] |= std::uint64_t{1} << (cell % 64);
    for (int j = 0; j < params.sectors; ++j) {
      const int d = std::abs(j - sector);
      const double bins = std::min(d, params.sectors - d) / params.cgh_sigma;
      histogram[static_cast<std::size_t>(j)] += std::exp(-0.5 * bins * bins);
    }
  }
  const double sum = std::accumulate(histogram.begin(), histogram.end(), 0.0);
  for (const double bin : histogram) {
    result.cgh.bins.push_back(sum > 0.0 ? static_cast<float>(bin / sum) : 0.0F);
  }
  return result;
}

class DescriptorExtraction : public ::testing::Test {
 protected:
  DescriptorExtraction() {
    auto random = test::seeded_random();
    scan_ = test::closed_scan(office_scene(), {-3.0, -1.0, 0.4}, 1440, 0.01, random);
    keypoints_ = FalkoDetector().detect(scan_);
  }
  LaserScan scan_;
  std::vector<Keypoint> keypoints_;
};

TEST_F(DescriptorExtraction, FollowsTheDefinitions) {
  ASSERT_GT(keypoints_.size(), 5U);
  for (const double sigma : {0.6, 2.0, 8.0}) {
    for (const double radius : {0.5, 0.2, 3.0}) {
      DescriptorParams params;
      params.cgh_sigma = sigma;
      params.radius = radius;
      DescriptorExtractor extractor(params);
      for (const auto& feature : extractor.extract(scan_, keypoints_)) {
        const auto expected = describe_naively(scan_, feature.keypoint, params);
        // A point on the border of a cell may fall to either side in single precision.
        EXPECT_LE(distance(feature.bsc, expected.bsc), 1);
        for (std::size_t i = 0; i < expected.cgh.bins.size(); ++i) {
          EXPECT_NEAR(feature.cgh.bins[i], expected.cgh.bins[i], 0.01);
        }
      }
    }
  }
}

TEST_F(DescriptorExtraction, TurnsWithTheScan) {
  DescriptorExtractor extractor;
  const auto features = extractor.extract(scan_, keypoints_);
  for (const std::size_t by : {1U, 500U, 1439U}) {
    const LaserScan turned = with_beams_rotated(scan_, by);
    const double angle = static_cast<double>(by) * scan_.angle_increment;
    for (const auto& feature : features) {
      Keypoint keypoint = feature.keypoint;
      keypoint.position = Pose2(0.0, 0.0, -angle) * keypoint.position;
      keypoint.orientation = wrap_angle(keypoint.orientation - angle);
      keypoint.beam = (keypoint.beam + scan_.size() - by) % scan_.size();
      const auto again = extractor.extract(turned, {keypoint}).front();
      EXPECT_LE(distance(again.bsc, feature.bsc), 1);
      EXPECT_LT(distance(again.cgh, feature.cgh), 1e-3);
    }
  }
}

TEST_F(DescriptorExtraction, HistogramsSumToOne) {
  DescriptorExtractor extractor;
  for (const auto& feature : extractor.extract(scan_, keypoints_)) {
    EXPECT_NEAR(std::accumulate(feature.cgh.bins.begin(), feature.cgh.bins.end(), 0.0), 1.0, 1e-5);
  }
}

TEST_F(DescriptorExtraction, OfNothingIsAllZero) {
  LaserScan empty = scan_;
  std::fill(empty.ranges.begin(), empty.ranges.end(), std::nan(""));
  std::fill(empty.status.begin(), empty.status.end(), BeamStatus::kErroneous);
  DescriptorExtractor extractor;
  const auto feature = extractor.extract(empty, {keypoints_.front()}).front();
  for (const auto word : feature.bsc.words) EXPECT_EQ(word, 0U);
  for (const float bin : feature.cgh.bins) EXPECT_EQ(bin, 0.0F);
}

// Nearer to the sensor than the radius of the descriptor: all beams may take part.
TEST_F(DescriptorExtraction, WorksNextToTheSensor) {
  auto random = test::seeded_random();
  Scene closet;
  closet.add_box({0.0, 0.0, 0.0}, {0.6, 0.4});
  for (const bool closed : {true, false}) {
    LaserScan scan = test::closed_scan(closet, {0.05, 0.02, 0.3}, 720, 0.0, random);
    scan.closed = closed;
    Keypoint keypoint;
    keypoint.position = {0.1, 0.15};
    keypoint.beam = 500;
    const DescriptorParams params;
    DescriptorExtractor extractor(params);
    const auto feature = extractor.extract(scan, {keypoint}).front();
    EXPECT_LE(distance(feature.bsc, describe_naively(scan, keypoint, params).bsc), 1);
  }
}

TEST_F(DescriptorExtraction, NumbersCellsByRingAndSector) {
  LaserScan scan;
  scan.angle_min = 0.0;
  scan.angle_increment = 0.1;
  scan.ranges = {2.3, 2.0};
  scan.status = {BeamStatus::kValid, BeamStatus::kErroneous};
  scan.ranges[1] = std::nan("");
  Keypoint keypoint;
  keypoint.position = {2.0, 0.0};
  keypoint.orientation = -0.1;  // the point lies 0.3 m away, 0.1 rad to the left of it
  DescriptorExtractor extractor;
  const auto feature = extractor.extract(scan, {keypoint}).front();
  // Ring floor(0.3 * 8 / 0.5) = 4, sector 0.
  for (std::size_t i = 0; i < 128; ++i) EXPECT_EQ(feature.bsc.cell(i), i == 4 * 16) << i;
}

TEST(DescriptorParams, AreChecked) {
  DescriptorParams params;
  params.rings = 0;
  EXPECT_THROW(DescriptorExtractor extractor(params), std::invalid_argument);
  params = {};
  params.cgh_sigma = 0.0;
  EXPECT_THROW(DescriptorExtractor extractor(params), std::invalid_argument);
  params = {};
  params.radius = std::nan("");
  EXPECT_THROW(DescriptorExtractor extractor(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
