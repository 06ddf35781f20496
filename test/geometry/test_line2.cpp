// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/line2.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

std::vector<Eigen::Vector2d> points_on(const Line2& line, int count, double noise,
                                       std::mt19937_64& random) {
  const Eigen::Vector2d along(-line.normal.y(), line.normal.x());
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(line.offset * line.normal + (1.0 + 0.1 * i) * along +
                     Eigen::Vector2d(test::normal(random, noise), test::normal(random, noise)));
  }
  return points;
}

Line2 line_at(double angle, double offset) { return {{std::cos(angle), std::sin(angle)}, offset}; }

TEST(FitLine, FindsExactLinesInAllDirections) {
  auto random = test::seeded_random();
  for (double angle = -kPi; angle < kPi; angle += 0.1) {
    const Line2 line = line_at(angle, 2.5);
    const auto fit = fit_line(points_on(line, 10, 0.0, random));
    ASSERT_TRUE(fit);
    const double sign = fit->line.normal.dot(line.normal) < 0.0 ? -1.0 : 1.0;
    EXPECT_TRUE((sign * fit->line.normal).isApprox(line.normal, 1e-9)) << angle;
    EXPECT_NEAR(sign * fit->line.offset, line.offset, 1e-9) << angle;
    EXPECT_NEAR(fit->rms_distance, 0.0, 1e-9);
  }
}

// A line that no other line through any two directions beats: brute force over angles.
TEST(FitLine, LeavesTheSmallestResidual) {
  auto random = test::seeded_random();
  const auto points = points_on(line_at(0.7, 1.0), 15, 0.05, random);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& point : points) mean += point / static_cast<double>(points.size());
  double best = 1e9;
  for (double angle = 0.0; angle < kPi; angle += 1e-4) {
    const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
    double squares = 0.0;
    for (const auto& point : points) squares += std::pow(normal.dot(point - mean), 2);
    best = std::min(best, squares);
  }

  const auto fit = fit_line(points);

  ASSERT_TRUE(fit);
  const double squares = fit->rms_distance * fit->rms_distance * static_cast<double>(points.size());
  EXPECT_LE(squares, best + 1e-12);
  EXPECT_NEAR(squares, best, 1e-7);
}

// Errors of angle and offset, measured in the stated covariance, follow a chi-square distribution
// with two degrees of freedom: mean 2.
TEST(FitLine, CovarianceIsHonest) {
  auto random = test::seeded_random();
  constexpr double kNoise = 0.01;
  constexpr int kRuns = 2000;
  for (const double angle : {0.0, 0.9, -2.0}) {
    const Line2 line = line_at(angle, 3.0);
    double known = 0.0;
    double estimated = 0.0;
    for (int i = 0; i < kRuns; ++i) {
      const auto points = points_on(line, 20, kNoise, random);
      for (const double noise : {kNoise, 0.0}) {
        const auto fit = fit_line(points, noise);
        ASSERT_TRUE(fit);
        const double sign = fit->line.normal.dot(line.normal) < 0.0 ? -1.0 : 1.0;
        const Eigen::Vector2d normal = sign * fit->line.normal;
        Eigen::Matrix2d covariance = fit->covariance;
        if (sign < 0.0) {  // the offset changes sign with the normal
          covariance(0, 1) *= -1.0;
          covariance(1, 0) *= -1.0;
        }
        const Eigen::Vector2d error(angle_between(angle, std::atan2(normal.y(), normal.x())),
                                    sign * fit->line.offset - line.offset);
        (noise > 0.0 ? known : estimated) += error.dot(covariance.inverse() * error) / kRuns;
      }
    }
    EXPECT_NEAR(known, 2.0, 0.15) << angle;
    EXPECT_NEAR(estimated, 2.0 * 18.0 / 16.0, 0.2) << angle;  // F distribution with 18 in the noise
  }
}

TEST(FitLine, NeedsTwoDistinctPoints) {
  EXPECT_FALSE(fit_line({}));
  EXPECT_FALSE(fit_line({{1.0, 2.0}}));
  EXPECT_FALSE(fit_line({{1.0, 2.0}, {1.0, 2.0}, {1.0, 2.0}}));
}

TEST(FitLine, IsPreciseFarFromTheOrigin) {
  auto random = test::seeded_random();
  const Line2 line = line_at(0.4, 1e5);
  const auto fit = fit_line(points_on(line, 10, 0.0, random));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(std::abs(fit->line.normal.dot(line.normal)), 1.0, 1e-9);
  EXPECT_LT(fit->rms_distance, 1e-9);
}

TEST(Intersection, LiesOnBothLines) {
  const Line2 a = line_at(0.3, 2.0);
  const Line2 b = line_at(1.9, -1.0);
  const auto point = intersection(a, b);
  ASSERT_TRUE(point);
  EXPECT_NEAR(a.signed_distance(*point), 0.0, 1e-12);
  EXPECT_NEAR(b.signed_distance(*point), 0.0, 1e-12);
}

TEST(Intersection, IsEmptyForParallelLines) {
  EXPECT_FALSE(intersection(line_at(0.3, 2.0), line_at(0.3, 1.0)));
  EXPECT_FALSE(intersection(line_at(0.3, 2.0), line_at(0.3 + kPi, 1.0)));
  EXPECT_FALSE(intersection(line_at(0.3, 2.0), line_at(0.35, 1.0), 0.1));
  EXPECT_TRUE(intersection(line_at(0.3, 2.0), line_at(0.35, 1.0), 0.01));
}

}  // namespace
}  // namespace falko_slam
