// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "falko_slam/evaluation/literal_falko.hpp"
#include "falko_slam/features/falko.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

// With the parameters of the thesis the detector must judge a beam as the naive reading does.
class FalkoAgainstLiteral : public ::testing::Test {
 protected:
  FalkoAgainstLiteral() {
    auto random = test::seeded_random();
    for (double x = -7.0; x < 8.0; x += 1.3) {
      LaserScan scan = test::closed_scan(office_scene(), {x, -1.0, 0.3 * x}, 720, 0.01, random);
      scan.closed = false;  // the naive reading does not reach over the seam
      scans_.push_back(scan);
    }
  }
  std::vector<LaserScan> scans_;
};

TEST_F(FalkoAgainstLiteral, ScoresTheSameBeamsTheSame) {
  FalkoParams params = thesis_falko_params();
  params.suppression_radius = 0.0;  // all candidates
  LiteralFalkoParams literal;
  literal.suppression_radius = -1.0;
  FalkoDetector detector(params);
  std::size_t candidates = 0;
  std::size_t same = 0;
  for (const LaserScan& scan : scans_) {
    const auto expected = literal_falko(scan, literal);
    const auto found = detector.detect(scan);
    for (const Keypoint& keypoint : expected) {
      ++candidates;
      const auto match = std::find_if(found.begin(), found.end(), [&](const Keypoint& other) {
        return other.beam == keypoint.beam && other.score == keypoint.score &&
               (other.position - keypoint.position).norm() < 1e-3;
      });
      if (match == found.end()) continue;
      ++same;
      EXPECT_NEAR(match->radius, keypoint.radius, 1e-3 * keypoint.radius);
    }
  }
  // The radius is tabulated over the range: a point on its edge may fall on the other side.
  ASSERT_GT(candidates, 500U);
  EXPECT_GT(static_cast<double>(same), 0.98 * static_cast<double>(candidates));
}

TEST_F(FalkoAgainstLiteral, FindsTheSameKeypoints) {
  FalkoDetector detector(thesis_falko_params());
  std::size_t expected_count = 0;
  std::size_t found_again = 0;
  for (const LaserScan& scan : scans_) {
    const auto found = detector.detect(scan);
    for (const Keypoint& keypoint : literal_falko(scan)) {
      ++expected_count;
      found_again += static_cast<std::size_t>(
          std::any_of(found.begin(), found.end(), [&](const Keypoint& other) {
            return (other.position - keypoint.position).norm() < 0.2;
          }));
    }
  }
  EXPECT_GT(static_cast<double>(found_again), 0.97 * static_cast<double>(expected_count));
}

}  // namespace
}  // namespace falko_slam
