// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/landmark_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "localization/landmark_drive.hpp"

namespace falko_slam {
namespace {

std::vector<std::size_t> sorted_near(const LandmarkIndex& index, const Eigen::Vector2d& point,
                                     double radius) {
  std::vector<std::size_t> found;
  index.find_near(point, radius, found);
  std::sort(found.begin(), found.end());
  return found;
}

TEST(LandmarkIndex, FindsWhatAComparisonWithAllFinds) {
  std::mt19937_64 random = test::seeded_random();
  for (const std::size_t count : {1U, 2U, 30U, 1000U}) {
    const LandmarkIndex index(test::scattered_landmarks(count, 100.0, 0.0, 0.01, random));
    for (int run = 0; run < 300; ++run) {
      const double x = test::uniform(random, -70.0, 70.0);
      const Eigen::Vector2d point(x, test::uniform(random, -70.0, 70.0));
      const double radius = std::exp(test::uniform(random, -3.0, 5.0));
      std::vector<std::size_t> expected;
      for (std::size_t i = 0; i < count; ++i) {
        if ((index.landmarks()[i].position - point).norm() <= radius) expected.push_back(i);
      }
      EXPECT_EQ(sorted_near(index, point, radius), expected);
    }
  }
}

TEST(LandmarkIndex, FindsAllWithinAnInfiniteRadius) {
  std::mt19937_64 random = test::seeded_random();
  const LandmarkIndex index(test::scattered_landmarks(50, 10.0, 0.0, 0.01, random));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sorted_near(index, {3.0, 4.0}, infinity).size(), 50U);
}

TEST(LandmarkIndex, TakesMapsOfNoneAndOfARow) {
  EXPECT_TRUE(sorted_near(LandmarkIndex({}), {0.0, 0.0}, 10.0).empty());
  std::vector<Landmark> row;
  for (std::uint32_t i = 0; i < 1000; ++i)
    row.push_back({i, {0.1 * i, 0.0}, Eigen::Matrix2d::Zero()});
  EXPECT_EQ(sorted_near(LandmarkIndex(row), {50.0, 0.0}, 1.04).size(), 21U);
}

TEST(LandmarkIndex, FindsById) {
  const Eigen::Matrix2d none = Eigen::Matrix2d::Zero();
  const LandmarkIndex index({{7, {0.0, 0.0}, none}, {3, {1.0, 0.0}, none}});
  EXPECT_EQ(index.find(3), std::optional<std::size_t>(1));
  EXPECT_FALSE(index.find(4));
}

TEST(LandmarkIndex, RefusesWhatIsNoMap) {
  const Eigen::Matrix2d none = Eigen::Matrix2d::Zero();
  const auto build = [](std::vector<Landmark> landmarks) { LandmarkIndex index(landmarks); };
  EXPECT_THROW(build({{1, {0, 0}, none}, {1, {1, 0}, none}}), std::invalid_argument);
  EXPECT_THROW(build({{1, {std::nan(""), 0}, none}}), std::invalid_argument);
  EXPECT_THROW(build({{1, {0, 0}, -Eigen::Matrix2d::Identity()}}), std::invalid_argument);
}

TEST(LandmarkIndex, KnowsTheGreatestDeviation) {
  Eigen::Matrix2d turned;
  turned << 5.0, 4.0, 4.0, 5.0;  // eigenvalues 1 and 9
  EXPECT_NEAR(LandmarkIndex({{1, {0.0, 0.0}, turned}}).largest_deviation(), 3.0, 1e-12);
}

}  // namespace
}  // namespace falko_slam
